// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <vector>

#include "axiometry/base/contract.h"
#include "axiometry/standards/iso230_2/plan/plan.h"

namespace axiometry::iso230_2 {
namespace {

/// From rest to rest.
Duration way_duration(double way, double feed, double acceleration) {
  const double feed_per_s = feed / 60.0;
  const double to_feed = feed_per_s * feed_per_s / acceleration;
  return Duration::s(way < to_feed ? 2.0 * std::sqrt(way / acceleration)
                                   : way / feed_per_s + feed_per_s / acceleration);
}

/// To the line in space and away from it, point by point.
Duration ways_duration(const Plan& plan) {
  const auto line = spatial_line(plan.axis);
  Duration sum;
  if (!line) return sum;
  std::vector<Vector3> in = plan.way_in_mm, out = plan.way_out_mm;
  in.push_back(line->at(reach(plan).lowest));
  out.insert(out.begin(), line->at(reach(plan).lowest));
  for (const auto* way : {&in, &out})
    for (std::size_t k = 1; k < way->size(); ++k)
      sum = sum + way_duration(distance((*way)[k - 1], (*way)[k]), plan.feed, acceleration_of(plan));
  return sum;
}

}  // namespace

double acceleration_of(const Plan& plan) {
  return plan.acceleration.value_or(plan.axis.kind == AxisKind::linear ? 1000.0 : 500.0);
}

Position distance_to_feed(const Plan& plan) {
  const double feed_per_s = plan.feed / 60.0;
  return Position::native(feed_per_s * feed_per_s / acceleration_of(plan));
}

std::vector<Duration> move_durations(const std::vector<PlannedMove>& list, double feed, double acceleration) {
  AXIOMETRY_CONTRACT(feed > 0.0 && acceleration > 0.0);
  std::vector<Duration> durations(list.size());
  for (std::size_t k = 1; k < list.size(); ++k)
    durations[k] = way_duration(std::abs(list[k].to.in_native() - list[k - 1].to.in_native()), feed, acceleration);
  return durations;
}

Duration estimated_duration(const Plan& plan) {
  Duration sum = static_cast<double>(approaches(plan).size()) * plan.dwell + ways_duration(plan);
  for (Duration d : move_durations(moves(plan), plan.feed, acceleration_of(plan))) sum = sum + d;
  return sum;
}

}  // namespace axiometry::iso230_2
