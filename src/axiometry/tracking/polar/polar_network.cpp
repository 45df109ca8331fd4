// SPDX-License-Identifier: Apache-2.0
#include "axiometry/tracking/polar/polar_network.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axiometry/base/contract.h"
#include "axiometry/base/go_on_unless.h"
#include "axiometry/numeric/dense/dense.h"
#include "axiometry/tracking/polar/polar_settling.h"
#include "axiometry/tracking/ranges/range_eigen.h"
#include "axiometry/tracking/station/residual_findings.h"

namespace axiometry::tracking {
namespace detail {
namespace {

constexpr double fits_to = 4.0;                   // χ² of a reading on average
constexpr std::size_t polar_unknowns_most = 300;  // unknowns of stations: their system is solved by dense matrices

/// One call of adjust_polar().
class PolarAdjustment {
 public:
  PolarAdjustment(std::size_t points, std::size_t stations, std::span<const PolarReading> readings,
                  const PolarOptions& options)
      : readings_(readings), options_(options), layout_(lay_out_polar(points, stations, readings)) {}

  Result<PolarFit> carry_out() {
    if (layout_.column.size() > polar_stations_most || layout_.columns > polar_unknowns_most)
      return fail(fmt::format("found {} stations with {} unknowns, expected no more than {} with {}",
                              layout_.column.size(), layout_.columns, polar_stations_most, polar_unknowns_most));
    AXIOMETRY_TRY(state_, start_polar(layout_, readings_, options_, fit_.findings));
    shift_to_origin();
    system_ = reduce_polar(layout_, readings_, state_);
    AXIOMETRY_TRY_VOID(check_points());
    AXIOMETRY_TRY_VOID(solve());
    AXIOMETRY_TRY_VOID(check_directions());
    AXIOMETRY_TRY_VOID(check_points());
    to_datum();
    AXIOMETRY_TRY_VOID(check_nominal());
    AXIOMETRY_TRY_VOID(go_on_unless(options_.stop));
    fill();
    return std::move(fit_);
  }

 private:
  void shift_to_origin() {
    for (const auto& p : state_.points) centre_ += p / static_cast<double>(state_.points.size());
    move(Eigen::Matrix3d::Identity(), -centre_);
  }

  /// p ↦ turn · p + shift, of everything.
  void move(const Eigen::Matrix3d& turn, const Eigen::Vector3d& shift) {
    for (auto& p : state_.points) p = turn * p + shift;
    for (PolarPose& pose : state_.poses) {
      pose.at = turn * pose.at + shift;
      pose.turn = turn * pose.turn;
    }
  }

  Eigen::Vector3d middle() const {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const auto& p : state_.points) mean += p / static_cast<double>(state_.points.size());
    return mean;
  }

  Result<void> check_points() const {
    for (std::size_t i = 0; i < system_.blocks.size(); ++i)
      if (!(system_.blocks[i].narrowest > 1e-12))
        return fail(
            fmt::format("found readings of point {} that leave it undetermined, expected angles, or lengths "
                        "from three stations off one line with it",
                        polar_point_name(options_, i)));
    return {};
  }

  /// In the coordinates of the state.
  std::vector<Eigen::Vector3d> nominal_points() const {
    std::vector<Eigen::Vector3d> nominal;
    for (const Vector3& p : options_.nominal_mm) nominal.push_back(eigen(p) - centre_);
    return nominal;
  }

  struct NominalMisfit {
    double rms_mm = 0.0;
    std::size_t farthest = 0;
    double farthest_mm = 0.0;
  };
  /// What is left between points once they are turned and moved onto others.
  static NominalMisfit misfit_of(std::span<const Eigen::Vector3d> from, std::span<const Eigen::Vector3d> to) {
    const Eigen::Matrix3d turn = best_turn(from, to);
    const auto n = static_cast<double>(from.size());
    Eigen::Vector3d shift = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < from.size(); ++k) shift += (to[k] - turn * from[k]) / n;
    NominalMisfit misfit;
    for (std::size_t k = 0; k < from.size(); ++k) {
      const double off = (to[k] - turn * from[k] - shift).norm();
      misfit.rms_mm += off * off / n;
      if (off > misfit.farthest_mm) misfit.farthest = k, misfit.farthest_mm = off;
    }
    misfit.rms_mm = std::sqrt(misfit.rms_mm);
    return misfit;
  }

  /// The parts across the beam are 0 behind the instrument too: there a reading seems to fit that is not met at all.
  Result<void> check_directions() const {
    for (std::size_t k = 0; k < readings_.size(); ++k) {
      const PolarReading& r = readings_[k];
      if (!r.direction) continue;
      const PolarPose& pose = state_.poses[r.station];
      const Eigen::Vector3d beam = pose.turn * eigen(polar_frame(*r.direction).along);
      if (beam.dot(state_.points[r.point] - pose.at) > 0.0) continue;
      return fail(
          fmt::format("found reading {} (station {}, point {}) that looks away from where the point comes out, "
                      "expected angles within 90° of it: one of the readings of this point{} is wrong",
                      k + 1, polar_station_name(options_, r.station), polar_point_name(options_, r.point),
                      options_.nominal_mm.empty() ? "" : ", or its nominal place,"));
    }
    return {};
  }

  Result<void> solve() {
    PolarSettling found = settle_polar(layout_, readings_, std::move(state_), options_);
    state_ = std::move(found.state);
    system_ = std::move(found.system);
    inverse_ = std::move(found.inverse);
    fit_.iterations = found.iterations;
    switch (found.outcome) {
      case PolarOutcome::settled: return check_stations();
      case PolarOutcome::not_wanted: return go_on_unless(options_.stop);
      case PolarOutcome::diverged:
        return fail(fmt::format("the solution diverges in iteration {}, expected readings that belong together; {}",
                                found.iterations, farthest_reading()));
      case PolarOutcome::unsettled: break;
    }
    if (found.outcome == PolarOutcome::unsettled &&
        system_.chi_squared <= fits_to * static_cast<double>(layout_.equations))
      return fail(fmt::format(
          "the solution fits the readings but does not settle within {} iterations (points or stations still move "
          "by {:.3g} mm): they tell where the stations stand too weakly, expected more points, or better angles",
          options_.iterations_most, found.move_mm));
    return fail(
        fmt::format("the solution does not settle within {} iterations (points or stations still move by {:.3g} "
                    "mm), expected readings that belong together; {}",
                    options_.iterations_most, found.move_mm, farthest_reading()));
  }

  Result<void> check_stations() const {
    if (inverse_.null_directions == 0) return {};
    return fail(
        fmt::format("found readings that leave {} direction{} of the stations undetermined beyond position "
                    "and orientation, expected more points that several stations see, off one line",
                    inverse_.null_directions, inverse_.null_directions == 1 ? "" : "s"));
  }

  /// Of a solution that is none: where to look first.
  std::string farthest_reading() const {
    std::array<PolarRow, 3> rows;
    std::size_t farthest = 0;
    double most = -1.0;
    for (std::size_t k = 0; k < readings_.size(); ++k) {
      const std::size_t count = polar_rows(readings_[k], state_, layout_.has_angles[readings_[k].station], rows);
      for (std::size_t r = 0; r < count; ++r) {
        if (!(std::abs(rows[r].residual) > most)) continue;
        most = std::abs(rows[r].residual);
        farthest = k;
      }
    }
    return fmt::format("reading {} (station {}, point {}) is farthest from the others", farthest + 1,
                       polar_station_name(options_, readings_[farthest].station),
                       polar_point_name(options_, readings_[farthest].point));
  }

  std::optional<std::size_t> datum_station() const {
    if (options_.datum == PolarDatum::nominal) return std::nullopt;
    const auto first = std::ranges::find(layout_.has_angles, true);
    return static_cast<std::size_t>(first - layout_.has_angles.begin());
  }

  void to_datum() {
    if (const auto station = datum_station()) {
      const PolarPose pose = state_.poses[*station];
      move(pose.turn.transpose(), -(pose.turn.transpose() * pose.at));
    } else {
      const std::vector<Eigen::Vector3d> nominal = nominal_points();
      Eigen::Vector3d mean = Eigen::Vector3d::Zero();
      for (const auto& p : nominal) mean += p / static_cast<double>(nominal.size());
      const Eigen::Matrix3d turn = best_turn(state_.points, nominal);
      move(turn, mean - turn * middle());
    }
    system_ = reduce_polar(layout_, readings_, state_);
    inverse_ = invert_polar(system_, station_gauge(layout_, state_, middle()));
  }

  /// What the turn onto the nominal points leaves must be errors of a machine, not points that are others.
  Result<void> check_nominal() const {
    if (datum_station()) return {};
    const std::vector<Eigen::Vector3d> nominal = nominal_points();
    std::vector<Eigen::Vector3d> mirrored;
    for (const auto& p : state_.points) mirrored.emplace_back(-p.x(), p.y(), p.z());
    const NominalMisfit misfit = misfit_of(state_.points, nominal);
    double spread = 0.0;
    for (const auto& p : nominal) spread = std::max(spread, 2.0 * (p - nominal.front()).norm());
    const double most = nominal_misfit_most_mm(spread);
    if (misfit.rms_mm <= most) return {};
    const bool is_mirror = misfit_of(mirrored, nominal).rms_mm <= most;
    return fail(
        fmt::format("found points that lie {:.3f} mm (root mean square) from their nominal places, point {} the "
                    "farthest by {:.3f} mm, expected a few tenths: {}",
                    misfit.rms_mm, polar_point_name(options_, misfit.farthest), misfit.farthest_mm,
                    is_mirror ? "azimuths or an axis of the nominal places count the other way"
                              : "are points exchanged, or are these places of another set?"));
  }

  void fill() {
    fit_.chi_squared = system_.chi_squared;
    fit_.equations = layout_.equations;
    fit_.unknowns = 3 * state_.points.size() + layout_.columns - 6;
    const PolarCovariances c = polar_covariances(layout_, state_, system_, inverse_.factor, datum_station());
    const double factor = fit_.variance_factor();
    const auto grown = [factor](Matrix3 m) {
      for (auto& row : m)
        for (double& x : row) x *= factor;
      return m;
    };
    const Eigen::Vector3d back = datum_station() ? Eigen::Vector3d(Eigen::Vector3d::Zero()) : centre_;
    for (std::size_t i = 0; i < state_.points.size(); ++i) {
      fit_.points_mm.push_back(vector(state_.points[i] + back));
      fit_.covariances_mm2.push_back(grown(c.points[i]));
    }
    for (std::size_t j = 0; j < state_.poses.size(); ++j) {
      const PolarPose& pose = state_.poses[j];
      PolarStation station{vector(pose.at + back), {}, {}, static_cast<bool>(layout_.has_angles[j]), pose.dead};
      if (j != datum_station())
        station.covariance_mm2 = grown(c.stations[j]);  // of the datum rounding alone would be left
      for (std::size_t a = 0; a < 3; ++a)
        for (std::size_t b = 0; b < 3; ++b)
          station.turn[a][b] = pose.turn(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b));
      fit_.stations.push_back(std::move(station));
    }
    if (options_.checks) check_readings();
  }

  /// 1 less the redundancy number of a row: the share of its variance that the fit takes up.
  double leverage(const PolarReading& reading, const PolarRow& row) const {
    const PolarBlock& block = system_.blocks[reading.point];
    Eigen::VectorXd local = -(block.shares.transpose() * row.point);
    const std::size_t begin = layout_.column[reading.station];
    const std::size_t pose = layout_.has_angles[reading.station] ? 6 : 3;
    for (std::size_t k = 0; k < block.columns.size(); ++k) {
      const std::size_t column = block.columns[k];
      double& share = local[static_cast<Eigen::Index>(k)];
      if (column >= begin && column < begin + pose) share += row.pose[static_cast<Eigen::Index>(column - begin)];
      if (pose == 3 && column == begin + 3 + reading.segment) share += row.dead;
    }
    const Eigen::RowVectorXd taken = local.transpose() * inverse_.factor(block.columns, Eigen::all);
    const double sum = row.point.dot(block.covariance * row.point) + taken.squaredNorm();
    return std::clamp(sum, 0.0, 1.0);
  }

  void check_readings() {
    std::vector<double> all;
    std::array<PolarRow, 3> rows;
    for (const PolarReading& reading : readings_) {
      const std::size_t count = polar_rows(reading, state_, layout_.has_angles[reading.station], rows);
      const double d = (state_.points[reading.point] - state_.poses[reading.station].at).norm();
      double size[3] = {}, normalised[3] = {};
      for (std::size_t k = 0; k < count; ++k) {
        const double taken = leverage(reading, rows[k]);
        (k == 0 ? fit_.told_by_lengths : fit_.told_by_angles) += taken;
        size[k] = -rows[k].residual * rows[k].sigma * (k == 0 ? 1.0 : d);
        normalised[k] = 1.0 - taken > 1e-9 ? -rows[k].residual / std::sqrt(1.0 - taken) : 0.0;
        all.push_back(normalised[k]);
      }
      fit_.residuals.push_back({size[0], size[1], size[2], normalised[0], normalised[1], normalised[2]});
    }
    tell_outliers(outlier_limit(all));
    for (auto* const find : {chi_squared_finding, few_residuals_finding})
      if (auto finding = find(fit_.chi_squared, fit_.degrees_of_freedom()))
        fit_.findings.push_back(*std::move(finding));
    if (fit_.degrees_of_freedom() == 0)
      fit_.findings.push_back(
          {"polar-nothing-checks", false, "there are no more readings than unknowns: nothing checks the result"});
    std::ranges::stable_partition(fit_.findings, &Finding::serious);
  }

  void tell_outliers(double limit) {
    constexpr std::size_t most_listed = 5;
    std::size_t count = 0;
    for (std::size_t k = 0; k < readings_.size(); ++k) {
      const PolarResidual& r = fit_.residuals[k];
      const std::pair<std::string_view, double> parts[] = {
          {"length", r.length_normalised}, {"azimuth", r.sideways_normalised}, {"elevation", r.upwards_normalised}};
      for (const auto& [name, size] : parts) {
        if (!(std::abs(size) > limit) || ++count > most_listed) continue;
        fit_.findings.push_back(
            {"polar-outliers", true,
             fmt::format("the {} of reading {} (station {}, point {}) does not fit the others: {:.1f} times its "
                         "standard uncertainty",
                         name, k + 1, polar_station_name(options_, readings_[k].station),
                         polar_point_name(options_, readings_[k].point), std::abs(size))});
      }
    }
    if (count > most_listed)
      fit_.findings.push_back(
          {"polar-outliers", true, fmt::format("{} further do not fit the others either", count - most_listed)});
  }

  std::span<const PolarReading> readings_;
  const PolarOptions& options_;
  PolarLayout layout_;
  Eigen::Vector3d centre_ = Eigen::Vector3d::Zero();
  PolarState state_;
  PolarSystem system_;
  PolarInverse inverse_;
  PolarFit fit_;
};

}  // namespace
}  // namespace detail

Result<PolarFit> adjust_polar(std::size_t points, std::size_t stations, std::span<const PolarReading> readings,
                              const PolarOptions& options) {
  AXIOMETRY_CONTRACT(!readings.empty() && std::ranges::all_of(readings, [&](const PolarReading& r) {
    return r.point < points && r.station < stations && r.length_sigma_mm > 0.0;
  }));
  AXIOMETRY_CONTRACT(options.nominal_mm.empty() || options.nominal_mm.size() == points);
  AXIOMETRY_CONTRACT(options.datum == PolarDatum::station
                         ? std::ranges::any_of(readings, [](const PolarReading& r) { return r.direction.has_value(); })
                         : !options.nominal_mm.empty());
  return detail::PolarAdjustment(points, stations, readings, options).carry_out();
}

}  // namespace axiometry::tracking
