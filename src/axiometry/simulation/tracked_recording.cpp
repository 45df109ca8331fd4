// SPDX-License-Identifier: Apache-2.0
#include "axiometry/simulation/tracked_recording.h"

#include <cmath>
#include <span>

#include "axiometry/base/contract.h"

namespace axiometry::simulation {
namespace {

constexpr std::uint64_t stream_length_samples = 66;
constexpr double lost_from = 0.2, lost_to = 0.8;

/// Rounds everywhere alike, which a hypot() of the C library need not.
double way_mm(Vector3 a) { return std::sqrt(dot(a, a)); }

}  // namespace

Result<TrackedRecording> TrackedRecording::make(const TrackedMachine& machine, const VirtualTracker& tracker,
                                                const TrackingPlan& plan, const SimulatedLineLengths& lengths,
                                                double rate, std::uint64_t seed) {
  AXIOMETRY_CONTRACT(!lengths.truth.empty());
  TrackedRecording recording(tracker, rate, seed);
  if (!recording.tracker_.dead_path_mm) recording.tracker_.dead_path_mm = lengths.truth.front().distance_mm;
  std::vector<std::size_t> stops;  // legs that end at a reading
  const Duration time = lengths.truth.front().time;
  for (const TrackingLine& line : plan.lines) {
    const auto along = spatial_line(line.plan.axis);
    const auto pass = [&](Vector3 axes) {
      recording.way_.go(axes + plan.setup.tool_offset_mm + displacement_mm(machine, axes, time), line.plan.feed, 0.0);
    };
    for (const Vector3 place : line.plan.way_in_mm) pass(place);
    for (const PlannedMove& move : moves(line.plan)) {
      if (!move.approach) {
        pass(along->at(move.to));
        continue;
      }
      recording.way_.go(lengths.truth[stops.size()].reflector_mm, line.plan.feed, line.plan.dwell.in_s());
      stops.push_back(recording.way_.legs().size() - 1);
    }
    for (const Vector3 place : line.plan.way_out_mm) pass(place);
  }
  recording.way_.after_last();
  recording.break_beams(stops);
  AXIOMETRY_TRY(recording.count_, recording.way_.count(rate));
  return recording;
}

/// On the longest way between the stop before and that of the reading.
void TrackedRecording::break_beams(const std::vector<std::size_t>& stops) {
  const std::span<ReflectorLeg> legs = way_.legs();
  lengths_.assign(legs.size(), {.dead_path_mm = *tracker_.dead_path_mm});
  double jumped_mm = 0.0;
  std::size_t leg = 0;
  for (const TrueBreak& b : tracker_.breaks) {
    const std::size_t first = b.before_reading == 0 ? 0 : stops[b.before_reading - 1] + 1;
    std::size_t longest = first;
    for (std::size_t k = first; k <= stops[b.before_reading]; ++k)
      if (legs[k].way_s() > legs[longest].way_s()) longest = k;
    for (; leg <= longest; ++leg) lengths_[leg].dead_path_mm -= jumped_mm;
    if (b.told) legs[longest].lost_from = lost_from, legs[longest].lost_to = lost_to;
    lengths_[longest].jump_mm += b.jump_mm;
    jumped_mm += b.jump_mm;
  }
  for (; leg < legs.size(); ++leg) lengths_[leg].dead_path_mm -= jumped_mm;
}

double TrackedRecording::shown_mm(const LegLength& leg, double share, Vector3 at, double normal) const {
  const double length = way_mm(at - tracker_.station_mm);
  const double kappa = 1.0 + tracker_.scale_error.in_um_per_m() * 1e-6;
  // A jump is one of what is shown, so that the share of the dead path in it has no scale error.
  const double jumped = *tracker_.dead_path_mm - leg.dead_path_mm + (share >= 0.5 ? leg.jump_mm : 0.0);
  const double sigma = tracker_.noise.in_mm() + tracker_.noise_per_length.in_um_per_m() * 1e-6 * length;
  const double shown = kappa * (length - *tracker_.dead_path_mm) + jumped + sigma * normal;
  const double step = tracker_.resolution.in_mm();
  return step == 0.0 ? shown : std::nearbyint(shown / step) * step;
}

Result<void> TrackedRecording::record(const SampleSink& sink) const {
  return way_.record(
      rate_, seed_, stream_length_samples,
      [this](std::size_t leg, double share, Vector3 at, double normal) {
        return shown_mm(lengths_[leg], share, at, normal);
      },
      sink);
}

}  // namespace axiometry::simulation
