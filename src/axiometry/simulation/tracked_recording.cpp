// SPDX-License-Identifier: Apache-2.0
#include "axiometry/simulation/tracked_recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "axiometry/base/contract.h"
#include "axiometry/numeric/random/random.h"

namespace axiometry::simulation {
namespace {

constexpr std::uint64_t stream_length_samples = 66;
constexpr double tracked_samples_most = 1e10;
constexpr std::size_t strip_of_lengths = 4096;  // a multiple of RandomStream::group
constexpr double lost_from = 0.2, lost_to = 0.8;

double way_mm(Vector3 a) { return std::sqrt(dot(a, a)); }

}  // namespace

Result<TrackedRecording> TrackedRecording::make(const TrackedMachine& machine, const VirtualTracker& tracker,
                                                const TrackingPlan& plan, const SimulatedLengths& lengths, double rate,
                                                std::uint64_t seed) {
  AXIOMETRY_CONTRACT(!lengths.truth.empty());
  if (!(rate >= 0.001 && rate <= 1e7))
    return fail(fmt::format("found a rate of {} samples a second, expected 0.001 to 10000000", rate));
  TrackedRecording recording(tracker, rate, seed);
  if (!recording.tracker_.dead_path_mm) recording.tracker_.dead_path_mm = lengths.truth.front().distance_mm;
  std::vector<std::size_t> stops;  // legs that end at a reading
  const Duration time = lengths.truth.front().time;
  for (const TrackingLine& line : plan.lines) {
    const auto along = spatial_line(line.plan.axis);
    const auto pass = [&](Vector3 axes) {
      recording.go(axes + plan.setup.tool_offset_mm + displacement_mm(machine, axes, time), line.plan.feed, 0.0);
    };
    for (const Vector3 place : line.plan.way_in_mm) pass(place);
    for (const PlannedMove& move : moves(line.plan)) {
      if (!move.approach) {
        pass(along->at(move.to));
        continue;
      }
      recording.go(lengths.truth[stops.size()].reflector_mm, line.plan.feed, line.plan.dwell.in_s());
      stops.push_back(recording.legs_.size() - 1);
    }
    for (const Vector3 place : line.plan.way_out_mm) pass(place);
  }
  recording.legs_.back().leave_s += rest_s;
  recording.break_beams(stops);
  const double total = std::floor(recording.duration_s() * rate) + 1.0;
  if (total > tracked_samples_most)
    return fail(
        fmt::format("found a recording of {:.3g} samples, expected at most {:.3g}", total, tracked_samples_most));
  recording.total_ = static_cast<std::size_t>(total);
  std::size_t leg = 0;
  for (std::size_t k = 0; k < recording.total_; ++k) {
    const double t = static_cast<double>(k) / rate;
    while (t > recording.legs_[leg].leave_s && leg + 1 < recording.legs_.size()) ++leg;
    recording.lost_ += is_lost(recording.legs_[leg], t) ? 1 : 0;
  }
  return recording;
}

void TrackedRecording::go(Vector3 to, double feed, double dwell_s) {
  Leg leg{.from = to, .to = to, .dead_path_mm = *tracker_.dead_path_mm};
  if (legs_.empty()) {
    leg.leave_s = rest_s + dwell_s;
  } else {
    leg.from = legs_.back().to;
    leg.begin_s = legs_.back().leave_s;
    leg.arrive_s = leg.begin_s + way_mm(to - leg.from) / feed * 60.0;
    leg.leave_s = leg.arrive_s + dwell_s;
  }
  legs_.push_back(leg);
}

/// On the longest way between the stop before and that of the reading.
void TrackedRecording::break_beams(const std::vector<std::size_t>& stops) {
  double jumped_mm = 0.0;
  std::size_t leg = 0;
  for (const TrueBreak& b : tracker_.breaks) {
    const std::size_t first = b.before_reading == 0 ? 0 : stops[b.before_reading - 1] + 1;
    std::size_t longest = first;
    for (std::size_t k = first; k <= stops[b.before_reading]; ++k)
      if (legs_[k].arrive_s - legs_[k].begin_s > legs_[longest].arrive_s - legs_[longest].begin_s) longest = k;
    for (; leg <= longest; ++leg) legs_[leg].dead_path_mm -= jumped_mm;
    legs_[longest].is_lost = legs_[longest].is_lost || b.told;
    legs_[longest].jump_mm += b.jump_mm;
    jumped_mm += b.jump_mm;
  }
  for (; leg < legs_.size(); ++leg) legs_[leg].dead_path_mm -= jumped_mm;
}

bool TrackedRecording::is_lost(const Leg& leg, double t_s) {
  const double share = (t_s - leg.begin_s) / (leg.arrive_s - leg.begin_s);
  return leg.is_lost && share > lost_from && share < lost_to;
}

double TrackedRecording::shown_mm(const Leg& leg, double t_s, double normal) const {
  const double whole_s = leg.arrive_s - leg.begin_s;
  const double share = whole_s > 0.0 ? std::clamp((t_s - leg.begin_s) / whole_s, 0.0, 1.0) : 1.0;
  const Vector3 at = leg.from + share * share * (3.0 - 2.0 * share) * (leg.to - leg.from);
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
  numeric::RandomStream stream({seed_, stream_length_samples, 0});
  std::vector<double> noise(strip_of_lengths);
  std::vector<Sample> samples(strip_of_lengths);
  std::size_t leg = 0;
  for (std::size_t first = 0; first < total_; first += strip_of_lengths) {
    stream.fill_normal(noise);
    std::size_t arrived = 0;
    for (std::size_t k = 0; k < std::min(strip_of_lengths, total_ - first); ++k) {
      const double t = static_cast<double>(first + k) / rate_;
      while (t > legs_[leg].leave_s && leg + 1 < legs_.size()) ++leg;
      if (!is_lost(legs_[leg], t)) samples[arrived++] = {t, shown_mm(legs_[leg], t, noise[k])};
    }
    if (arrived > 0) AXIOMETRY_TRY_VOID(sink(std::span<const Sample>(samples).first(arrived)));
  }
  return {};
}

}  // namespace axiometry::simulation
