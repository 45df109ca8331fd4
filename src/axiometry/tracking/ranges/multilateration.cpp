// SPDX-License-Identifier: Apache-2.0
#include "axiometry/tracking/ranges/multilateration.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axiometry/base/go_on_unless.h"
#include "axiometry/tracking/ranges/multilateration_findings.h"
#include "axiometry/tracking/ranges/range_covariance.h"
#include "axiometry/tracking/ranges/range_input.h"
#include "axiometry/tracking/ranges/range_solution.h"
#include "axiometry/tracking/ranges/station_scales.h"

namespace axiometry::tracking {
namespace detail {
namespace {

/// One call of multilaterate().
class Multilateration {
 public:
  explicit Multilateration(const RangeInput& input)
      : in_(input),
        free_(input.options.scale == ScaleModel::free),
        unknown_scales_(free_ && !(input.options.scale_prior > 0.0)),
        with_size_(input.options.scale != ScaleModel::fixed && !(input.options.scale_prior > 0.0)) {}

  Result<MultilaterationFit> carry_out() {
    AXIOMETRY_TRY(const RangeCounts counts, check_ranges(in_));
    AXIOMETRY_TRY_VOID(check_counts(in_, fit_.rank, counts.segments));
    AXIOMETRY_TRY(starts_, start_all(in_, in_.options.find_breaks));
    if (!check_counts(in_, fit_.rank, segments())) {  // too few readings to tell a broken beam
      AXIOMETRY_TRY(starts_, start_all(in_, false));
      AXIOMETRY_TRY_VOID(check_counts(in_, fit_.rank, segments()));
    }
    AXIOMETRY_TRY_VOID(go_on_unless(in_.options.stop));
    lay_out_start();
    AXIOMETRY_TRY_VOID(check_rank(reduce(problem().input(), state_, std::nullopt, 0.0), 1.0));
    AXIOMETRY_TRY_VOID(solve());
    if (in_.options.find_breaks) AXIOMETRY_TRY_VOID(look_for_breaks());
    AXIOMETRY_TRY_VOID(go_on_unless(in_.options.stop));
    finish();
    AXIOMETRY_TRY_VOID(check_rank(run_.system, fit_.variance_factor()));
    fill(counts);
    return std::move(fit_);
  }

 private:
  std::size_t segments() const {
    std::size_t count = 0;
    for (const auto& dead : starts_.dead) count += dead.size();
    return count;
  }

  RangeProblem problem() const {
    return {layout_,
            weighting_,
            free_ ? in_.options.scale_prior : 0.0,
            free_ && with_size_,
            in_.options.iterations_most,
            point_chunks(layout_.points, layout_.columns(), in_.options.threads),
            in_.options.stop};
  }

  /// Everything about the mean of the nominal points, so that no digits are lost far from the origin.
  void lay_out_start() {
    const auto n = static_cast<double>(in_.nominal_mm.size());
    for (const Vector3& p : in_.nominal_mm) centre_ += 1.0 / n * p;
    nominal_.assign(in_.nominal_mm.begin(), in_.nominal_mm.end());
    for (Vector3& p : nominal_) p -= centre_;
    state_.points = nominal_;
    state_.stations = starts_.stations;
    for (Vector3& s : state_.stations) s -= centre_;
    state_.scales.assign(in_.stations, 1.0);
    lay_out_segments();
    double sum = 0.0;
    for (const RangeReading& r : in_.readings) sum += distance(nominal_[r.point], state_.stations[r.station]);
    weighting_ = {in_.options.ranging, in_.options.repeatability_sigma_mm,
                  std::max(sum / static_cast<double>(in_.readings.size()), 1e-6)};
  }

  void lay_out_segments() {
    layout_ = lay_out(nominal_.size(), in_.stations, in_.readings, starts_.segments, free_);
    state_.dead.clear();
    for (const auto& dead : starts_.dead) state_.dead.insert(state_.dead.end(), dead.begin(), dead.end());
  }

  Result<void> solve() {
    run_ = iterate(problem(), state_);
    AXIOMETRY_TRY_VOID(go_on_unless(in_.options.stop));
    if (run_.converged) return {};
    return fail(fmt::format(
        "the solution does not settle within {} iterations (points still move by {:.3g} mm), expected "
        "nominal points and lengths that belong together, and more readings than there are now ({} "
        "to spare, condition {:.1e})",
        run_.iterations, run_.system.largest_move_mm, fit_.rank.equations - fit_.rank.unknowns, fit_.rank.condition));
  }

  /// What cannot be determined at this state. `factor` is that of the variances.
  Result<void> check_rank(const ReducedSystem& system, double factor) {
    const RangeProblem problem = this->problem();
    const ReducedRank rank = reduced_rank(system, problem.gauge(state_), layout_);
    const StationSpread spread = station_spread(state_.stations);
    fit_.rank.condition = rank.condition;
    fit_.rank.weakest_mm = rank.weakest_mm * std::sqrt(factor);
    fit_.rank.stations_off_plane_mm = spread.off_plane_mm;
    weakest_station_ = rank.weakest_station;
    // The height over the common plane is what makes the stations' system regular; when it is known no better than
    // itself it may as well be 0.
    const std::size_t open = coplanar_null_directions(in_.stations, unknown_scales_);
    fit_.rank.stations_coplanar =
        open > 0 && (spread.off_plane_mm <= 2.0 * fit_.rank.weakest_mm ||
                     (rank.null_directions > 0 && spread.off_plane_mm < 1e-3 * spread.off_line_mm));
    fit_.rank.null_directions = std::max(rank.null_directions, fit_.rank.stations_coplanar ? open : 0);
    if (spread.off_line_mm <= 1e-3 * weighting_.scale_length_mm && rank.null_directions > 0)
      return fail(
          fmt::format("found {} stations on one line within {:.2g} mm, expected stations around the points: {} "
                      "directions stay undetermined",
                      in_.stations, spread.off_line_mm, rank.null_directions));
    if (fit_.rank.stations_coplanar)
      return fail(
          fmt::format("found {} stations on one plane within {:.2g} mm, expected one well off it or {} stations: "
                      "{} direction{} stay{} undetermined beyond position and orientation",
                      in_.stations, spread.off_plane_mm, unknown_scales_ ? 8 : 6, fit_.rank.null_directions,
                      fit_.rank.null_directions == 1 ? "" : "s", fit_.rank.null_directions == 1 ? "s" : ""));
    if (system.weak_points > 0)
      return fail(fmt::format(
          "found {} point{} in one plane with all stations that see them (the first is {}), expected "
          "a station off it: across the plane they stay undetermined",
          system.weak_points, system.weak_points == 1 ? "" : "s", point_name(in_.options, system.first_weak)));
    if (rank.null_directions > 0)
      return fail(
          fmt::format("found {} points and {} stations whose lengths leave {} direction{} undetermined beyond "
                      "{}, expected more points or stations elsewhere",
                      nominal_.size(), in_.stations, rank.null_directions, rank.null_directions == 1 ? "" : "s",
                      with_size_ ? "position, orientation and size" : "position and orientation"));
    return {};
  }

  /// A step in the residuals that a further dead path explains is a break; one that it does not is left alone.
  Result<void> look_for_breaks() {
    constexpr std::size_t breaks_most = 8;
    for (std::size_t k = 0; k < breaks_most; ++k) {
      AXIOMETRY_TRY_VOID(go_on_unless(in_.options.stop));
      if (layout_.readings() < fit_.rank.unknowns + 4) return {};
      const auto found = find_residual_step(in_, residuals(), starts_.segments);
      if (!found) return {};
      const RangeStarts starts_before = starts_;
      const RangeLayout layout_before = layout_;
      const RangeState state_before = state_;
      const RangeIteration run_before = run_;
      const std::size_t segment = starts_.segments[found->reading], fresh = starts_.dead[found->station].size();
      store_dead();
      starts_.dead[found->station].push_back(starts_.dead[found->station][segment]);
      for (std::size_t r = found->reading; r < in_.readings.size(); ++r)
        if (in_.readings[r].station == found->station && starts_.segments[r] == segment) starts_.segments[r] = fresh;
      lay_out_segments();
      run_ = iterate(problem(), state_);
      const double nu = static_cast<double>(layout_.readings() - fit_.rank.unknowns) - 1.0;
      const double gain = run_before.system.chi_squared - run_.system.chi_squared;
      if (!run_.converged || gain < 60.0 * std::max(1.0, run_.system.chi_squared / nu)) {
        starts_ = starts_before;
        layout_ = layout_before;
        state_ = state_before;
        run_ = run_before;
        return {};
      }
      store_dead();
      const auto& dead = starts_.dead[found->station];
      starts_.breaks.push_back({found->station, found->reading, dead[segment] - dead[fresh]});
      AXIOMETRY_TRY_VOID(check_counts(in_, fit_.rank, segments()));
    }
    return {};
  }

  void store_dead() {
    for (std::size_t k = 0; k < state_.dead.size(); ++k)
      starts_.dead[layout_.owner[k]][layout_.segment_of[k]] = state_.dead[k];
  }

  std::vector<double> residuals() const {
    std::vector<double> w(layout_.readings());
    for (std::size_t i = 0; i < layout_.points; ++i)
      for (std::size_t t = layout_.first[i]; t < layout_.first[i + 1]; ++t)
        w[layout_.reading[t]] = range_row(layout_, state_, weighting_, state_.points[i], t).residual;
    return w;
  }

  void finish() {
    mirrored_ = align(state_, nominal_, with_size_);
    fit_.iterations = run_.iterations;
    fit_.converged = run_.converged;
    run_.system = reduce(problem().input(), state_, std::nullopt, 0.0);
    fit_.chi_squared = run_.system.chi_squared;
    fit_.degrees_of_freedom = fit_.rank.equations - fit_.rank.unknowns;
  }

  void fill(const RangeCounts& counts) {
    const RangeProblem problem = this->problem();
    const std::vector<double> reduced = reduced_covariance(run_.system, problem.gauge(state_));
    RangeCovariances c = range_covariances(
        {layout_, state_, weighting_, reduced, with_size_, in_.options.point_covariances, problem.chunks});
    fit_.residuals_mm = std::move(c.residuals);
    fit_.normalised_residuals = std::move(c.normalised);
    fit_.point_covariances_mm2 = std::move(c.points);
    fit_.station_covariances_mm2 = std::move(c.stations);
    fit_.scale_sigmas = std::move(c.scale_sigmas);
    fit_.dead_path_sigmas_mm.resize(in_.stations);
    const double factor = fit_.variance_factor();
    for (std::size_t k = 0; k < c.dead_sigmas.size(); ++k)
      fit_.dead_path_sigmas_mm[layout_.owner[k]].push_back(c.dead_sigmas[k] * std::sqrt(factor));
    multiply(fit_.point_covariances_mm2, factor);
    multiply(fit_.station_covariances_mm2, factor);
    for (double& u : fit_.scale_sigmas) u *= std::sqrt(factor);
    if (in_.options.scale == ScaleModel::common && in_.options.scale_prior > 0.0) add_size_prior();

    store_dead();
    fit_.dead_paths_mm = starts_.dead;
    fit_.segments = starts_.segments;
    fit_.breaks = starts_.breaks;
    settle_jumps();
    fit_.scales = state_.scales;
    fit_.points_mm = std::move(state_.points);
    fit_.stations_mm = std::move(state_.stations);
    for (Vector3& p : fit_.points_mm) p += centre_;
    for (Vector3& s : fit_.stations_mm) s += centre_;
    const double sigma = std::sqrt(weighting_.variance(weighting_.scale_length_mm));
    fit_.findings =
        multilateration_findings({in_.readings, fit_, in_.options, starts_.mirrored, mirrored_,
                                  counts.points_seen_by_three, sigma, weighting_.scale_length_mm, weakest_station_});
  }

  /// The size of a break by the dead paths of the result.
  void settle_jumps() {
    for (RangeBreak& b : fit_.breaks) {
      std::size_t before = b.reading;
      while (before > 0 && in_.readings[--before].station != b.station) {
      }
      const auto& dead = fit_.dead_paths_mm[b.station];
      if (in_.readings[before].station == b.station)
        b.jump_mm = dead[fit_.segments[before]] - dead[fit_.segments[b.reading]];
    }
  }

  static void multiply(std::vector<Matrix3>& matrices, double factor) {
    for (Matrix3& m : matrices)
      for (auto& row : m)
        for (double& x : row) x *= factor;
  }

  /// A common scale with a prior changes the size alone: every place moves by ε (p − c) with ε of that uncertainty.
  void add_size_prior() {
    const double u = in_.options.scale_prior;
    const auto add = [&](Matrix3& m, Vector3 p) {
      for (std::size_t a = 0; a < 3; ++a)
        for (std::size_t b = 0; b < 3; ++b) m[a][b] += u * u * p[a] * p[b];
    };
    for (std::size_t i = 0; i < fit_.point_covariances_mm2.size(); ++i)
      add(fit_.point_covariances_mm2[i], state_.points[i]);
    for (std::size_t j = 0; j < fit_.station_covariances_mm2.size(); ++j)
      add(fit_.station_covariances_mm2[j], state_.stations[j]);
    fit_.scale_sigmas.assign(in_.stations, u);
  }

  const RangeInput& in_;
  bool free_;
  bool unknown_scales_;  // a prior tells as much as six coplanar stations lack, how well is a matter of covariances
  bool with_size_;       // whether nothing tells the size, so that it is taken from the nominal points
  Vector3 centre_{};
  std::vector<Vector3> nominal_;  // nominal points relative to centre_
  RangeStarts starts_;
  RangeLayout layout_;
  RangeState state_;
  RangeWeighting weighting_;
  RangeIteration run_;
  bool mirrored_ = false;
  std::size_t weakest_station_ = 0;
  MultilaterationFit fit_;
};

}  // namespace
}  // namespace detail

std::optional<std::size_t> points_least(std::size_t stations, ScaleModel scale) {
  if (stations < 4) return std::nullopt;
  const std::size_t per_station = scale == ScaleModel::free ? 5 : 4;
  const std::size_t gauge = scale == ScaleModel::free ? 7 : 6;
  return (per_station * stations - gauge + stations - 4) / (stations - 3);  // rounded up
}

Result<MultilaterationFit> multilaterate(std::span<const Vector3> nominal_mm, std::size_t stations,
                                         std::span<const RangeReading> readings,
                                         const MultilaterationOptions& options) {
  const detail::RangeInput input{nominal_mm, stations, readings, options};
  AXIOMETRY_TRY(MultilaterationFit fit, detail::Multilateration(input).carry_out());
  if (auto finding = detail::scale_finding(input, fit)) fit.findings.push_back(*std::move(finding));
  return fit;
}

}  // namespace axiometry::tracking
