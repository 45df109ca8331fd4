// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "axiometry/numeric/dense/dense.h"
#include "axiometry/tracking/polar/polar_settling.h"
#include "axiometry/tracking/ranges/range_eigen.h"
#include "axiometry/tracking/ranges/range_start.h"

namespace axiometry::tracking::detail {
namespace {

/// Places the stations one after the other on points that are known already.
class PolarStart {
 public:
  PolarStart(const PolarLayout& layout, std::span<const PolarReading> readings, const PolarOptions& options)
      : layout_(layout), readings_(readings), options_(options), of_station_(layout.column.size()) {
    for (std::size_t k = 0; k < readings.size(); ++k) of_station_[readings[k].station].push_back(k);
    state_.points.resize(layout.first.size() - 1);
    state_.poses.resize(layout.column.size());
    starts_from_nominal_ = !options.nominal_mm.empty();
    known_.assign(state_.points.size(), starts_from_nominal_);
    for (std::size_t i = 0; i < options.nominal_mm.size(); ++i) state_.points[i] = eigen(options.nominal_mm[i]);
    placed_.assign(layout.column.size(), false);
  }

  Result<PolarState> carry_out(std::vector<Finding>& findings) {
    if (!options_.nominal_mm.empty()) place_all();
    if (!needs_nominal() && !is_any_placed()) place_without_nominal();
    AXIOMETRY_TRY_VOID(check_stations());
    AXIOMETRY_TRY_VOID(check_points());
    if (std::ranges::find(layout_.has_angles, false) == layout_.has_angles.end()) return std::move(state_);
    settle_angles();
    for (std::size_t j = 0; j < placed_.size(); ++j)
      if (!layout_.has_angles[j]) AXIOMETRY_TRY_VOID(place_by_lengths(j, findings));
    return std::move(state_);
  }

 private:
  bool needs_nominal() const { return options_.datum == PolarDatum::nominal; }
  bool is_any_placed() const { return std::ranges::find(placed_, true) != placed_.end(); }

  /// From the first station on, whose own frame is as good a beginning.
  void place_without_nominal() {
    starts_from_nominal_ = false;
    known_.assign(known_.size(), false);
    place_first();
    place_all();
  }

  void place_all() {
    while (place_more()) {
    }
  }

  Result<void> check_stations() const {
    for (std::size_t j = 0; j < placed_.size(); ++j) {
      if (!layout_.has_angles[j] || placed_[j]) continue;
      const std::string name = polar_station_name(options_, j);
      if (starts_from_nominal_)
        return fail(
            fmt::format("found fewer than three points off one line that station {} sees and that have nominal "
                        "places, expected three or more",
                        name));
      return fail(
          fmt::format("found fewer than three points off one line that station {} shares with those placed "
                      "before, expected three or more",
                      name));
    }
    return {};
  }

  Result<void> check_points() const {
    const auto unknown = std::ranges::find(known_, false);
    if (unknown == known_.end()) return {};
    const std::string name = polar_point_name(options_, static_cast<std::size_t>(unknown - known_.begin()));
    if (options_.nominal_mm.empty())
      return fail(fmt::format("found point {} without angles and without a nominal place, expected one of them", name));
    return fail(
        fmt::format("found point {} without angles, and no station that sees three nominal places off one line, "
                    "expected one of them",
                    name));
  }

  static Eigen::Vector3d shown(const PolarReading& r) { return r.length_mm * eigen(polar_frame(*r.direction).along); }

  void place_first() {
    for (std::size_t j = 0; j < placed_.size(); ++j) {
      if (!layout_.has_angles[j]) continue;
      placed_[j] = true;
      take_points(j);
      return;
    }
  }

  void take_points(std::size_t j) {
    const PolarPose& pose = state_.poses[j];
    for (const std::size_t k : of_station_[j]) {
      const PolarReading& r = readings_[k];
      if (!r.direction || known_[r.point]) continue;
      state_.points[r.point] = pose.at + pose.turn * shown(r);
      known_[r.point] = true;
    }
  }

  /// One round over the stations; whether any was placed.
  bool place_more() {
    bool any = false;
    for (std::size_t j = 0; j < placed_.size(); ++j) {
      if (placed_[j] || !layout_.has_angles[j] || !place_by_angles(j)) continue;
      placed_[j] = any = true;
      take_points(j);
    }
    return any;
  }

  bool place_by_angles(std::size_t j) {
    std::vector<Eigen::Vector3d> from, to;
    Eigen::Vector3d from_mean = Eigen::Vector3d::Zero(), to_mean = from_mean;
    for (const std::size_t k : of_station_[j]) {
      const PolarReading& r = readings_[k];
      if (!r.direction || !known_[r.point]) continue;
      from.push_back(shown(r));
      to.push_back(state_.points[r.point]);
      from_mean += from.back();
      to_mean += to.back();
    }
    if (from.size() < 3) return false;
    from_mean /= static_cast<double>(from.size());
    to_mean /= static_cast<double>(from.size());
    Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
    for (const auto& p : to) moments += (p - to_mean) * (p - to_mean).transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> spread(moments, Eigen::EigenvaluesOnly);
    if (!(spread.eigenvalues()[1] > 1e-8 * spread.eigenvalues()[2]))
      return false;  // on one line within 1e-4 of its length
    PolarPose& pose = state_.poses[j];
    pose.turn = best_turn(from, to);
    pose.at = to_mean - pose.turn * from_mean;
    return true;
  }

  /// The points as all stations with angles tell them, before others are placed on these: one instrument with bad
  /// angles may have told them first.
  void settle_angles() {
    std::vector<std::size_t> number(placed_.size(), 0);
    std::size_t stations = 0;
    for (std::size_t j = 0; j < placed_.size(); ++j)
      if (layout_.has_angles[j]) number[j] = stations++;
    std::vector<PolarReading> readings;
    std::vector<bool> has_direction(state_.points.size(), false);
    for (const PolarReading& r : readings_) {
      if (!layout_.has_angles[r.station]) continue;
      readings.push_back(r);
      readings.back().station = number[r.station];
      if (r.direction) has_direction[r.point] = true;
    }
    if (stations < 2 || std::ranges::find(has_direction, false) != has_direction.end()) return;
    PolarState some{state_.points, {}};
    for (std::size_t j = 0; j < placed_.size(); ++j)
      if (layout_.has_angles[j]) some.poses.push_back(state_.poses[j]);
    const PolarLayout layout = lay_out_polar(some.points.size(), stations, readings);
    PolarSettling found = settle_polar(layout, readings, std::move(some), options_);
    if (found.outcome != PolarOutcome::settled || found.inverse.null_directions > 0) return;
    state_.points = std::move(found.state.points);
    for (std::size_t j = 0; j < placed_.size(); ++j)
      if (layout_.has_angles[j]) state_.poses[j] = found.state.poses[number[j]];
  }

  Result<void> place_by_lengths(std::size_t j, std::vector<Finding>& findings) {
    StationReadings readings;
    readings.segments = layout_.segments[j];
    for (const std::size_t k : of_station_[j]) {
      const PolarReading& r = readings_[k];
      readings.nominal_mm.push_back(vector(state_.points[r.point]));
      readings.length_mm.push_back(r.length_mm);
      readings.segment.push_back(r.segment);
      readings.reading.push_back(k);
      readings.point.push_back(r.point);
    }
    AXIOMETRY_TRY(const StationStart start, start_station(readings, polar_station_name(options_, j)));
    state_.poses[j].at = eigen(start.station_mm);
    state_.poses[j].dead = start.dead_mm;
    if (start.mirror_mm)
      findings.push_back({"polar-station-side", true,
                          fmt::format("the points of station {} lie on a plane, and no length tells on which side "
                                      "of it the station stands: it was taken on the upper side",
                                      polar_station_name(options_, j))});
    return {};
  }

  const PolarLayout& layout_;
  std::span<const PolarReading> readings_;
  const PolarOptions& options_;
  std::vector<std::vector<std::size_t>> of_station_;
  PolarState state_;
  std::vector<bool> known_, placed_;
  bool starts_from_nominal_ = false;
};

}  // namespace

Result<PolarState> start_polar(const PolarLayout& layout, std::span<const PolarReading> readings,
                               const PolarOptions& options, std::vector<Finding>& findings) {
  return PolarStart(layout, readings, options).carry_out(findings);
}

}  // namespace axiometry::tracking::detail
