// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/live/sources/simulated_lengths.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "axiometry/app/volumetric/simulated_recording.h"
#include "axiometry/base/text/text.h"
#include "axiometry/model/aligned.h"
#include "axiometry/simulation/tracked_recording.h"
#include "axiometry/volumetric/simulate/simulated_lengths.h"

namespace axiometry::app {
namespace {

constexpr std::array presets = {
    LengthPreset{"good", "Nothing goes wrong", "One dead path for all lengths, each within the noise"},
    LengthPreset{"broken-beam", "The beam is broken once on the way",
                 "Samples are missing, and the lengths from there on have another dead path"},
};
constexpr double usual_jump_mm = 3.7;     // more than a plan leaves open
constexpr double share_of_longest = 0.7;  // of the ways: on a short one too few samples are lost to show it
constexpr std::uint64_t most_draws = 100;

bool breaks_beam(const SimulatedLengthCapture& capture) { return capture.preset == "broken-beam"; }

RawSetting setting_of(std::size_t samples) {
  RawSetting setting;
  setting.samples = samples;
  setting.rate = simulated_rate_hz;
  setting.lengths = true;
  return setting;
}

/// Squareness and scales as machines have them, larger or smaller by the seed.
simulation::TrackedMachine usual_machine(std::uint64_t seed) {
  const double size = 0.5 + 0.1 * static_cast<double>(seed % 11);
  const auto relative = [&](double um_per_m) { return RelativeLength::um_per_m(size * um_per_m); };
  simulation::TrackedMachine machine;
  machine.scale = {relative(12.0), relative(-8.0), relative(15.0)};
  machine.C0Y = relative(20.0);
  machine.B0Z = relative(-14.0);
  machine.A0Z = relative(9.0);
  machine.repeatability = {Length::um(0.3), Length::um(0.3), Length::um(0.3)};
  return machine;
}

/// The first reading of a line, where there are several.
std::size_t middle_of(const TrackingPlan& plan) {
  std::size_t readings = 0;
  for (std::size_t k = 0; k < plan.lines.size() / 2; ++k) readings += approaches(plan.lines[k].plan).size();
  return plan.lines.size() > 1 ? readings : approaches(plan.lines.front().plan).size() / 2;
}

Result<Connect> lines_source(const SimulatedLengthCapture& capture) {
  const TrackingPlan& plan = *capture.task.lines();
  if (is_aligned(plan.setup))
    return fail(
        "found a plan whose interferometer is aligned with each line, expected one with a station: the "
        "simulator follows a reflector");
  const std::uint64_t seed = capture.seed + capture.task.part();
  simulation::VirtualTracker tracker;
  tracker.station_mm = plan.setup.station.position_mm;
  tracker.noise = Length::um(0.1);
  if (breaks_beam(capture))
    tracker.breaks = {{.before_reading = middle_of(plan), .jump_mm = usual_jump_mm, .told = true}};
  const simulation::TrackedMachine machine = usual_machine(capture.seed);
  AXIOMETRY_TRY(const auto lengths, simulation::simulate_lengths(machine, tracker, plan, {}, seed));
  AXIOMETRY_TRY(auto made,
                simulation::TrackedRecording::make(machine, tracker, plan, lengths, simulated_rate_hz, seed));
  auto recording = std::make_shared<const simulation::TrackedRecording>(std::move(made));
  return played_source([recording](const SampleSink& sink) { return recording->record(sink); },
                       setting_of(recording->samples()), capture.pace);
}

bool breaks_on_long_way(const std::vector<volumetric::PlannedStop>& stops,
                        const volumetric::SimulatedLengths& lengths) {
  const auto way = [&](std::size_t to) { return distance(stops[to].axes_mm, stops[to - 1].axes_mm); };
  double longest = 0.0;
  for (std::size_t k = 1; k < stops.size(); ++k) longest = std::max(longest, way(k));
  return lengths.jumps.empty() || way(lengths.jumps.front().before_reading) >= share_of_longest * longest;
}

/// The part alone, so that what goes wrong does so in it.
Result<Connect> volume_source(const SimulatedLengthCapture& capture) {
  volumetric::CalibrationPlan plan = *capture.task.volume();
  plan.runs = {plan.runs[capture.task.part() - 1]};
  const std::uint64_t seed = capture.seed + capture.task.part();
  const volumetric::TrueErrors errors = volumetric::drawn_errors(plan.machine.travel, {}, {capture.seed, 0});
  volumetric::SimulatedFaults faults;
  faults.told_breaks = breaks_beam(capture) ? 1 : 0;
  const auto drawn = [&](std::uint64_t trial) {
    return volumetric::simulate_lengths(plan.machine, errors, volumetric::visits_of(plan), faults, {seed, trial});
  };
  AXIOMETRY_TRY(auto lengths, drawn(0));
  for (std::uint64_t trial = 1; trial < most_draws && !breaks_on_long_way(plan.runs.front().stops, lengths); ++trial)
    lengths = drawn(trial).value_or(lengths);
  const RecordingNoise noise{.rate = simulated_rate_hz};
  AXIOMETRY_TRY(auto made, PartsRecording::make(plan, {1, 1}, errors, lengths, noise, seed));
  auto recording = std::make_shared<const PartsRecording>(std::move(made));
  return played_source([recording](const SampleSink& sink) { return recording->record(sink); },
                       setting_of(recording->samples()), capture.pace);
}

}  // namespace

std::span<const LengthPreset> length_presets() { return presets; }

Result<Connect> simulated_lengths_source(const SimulatedLengthCapture& capture) {
  if (std::ranges::find(presets, capture.preset, &LengthPreset::id) == presets.end()) {
    std::vector<std::string_view> known;
    for (const LengthPreset& preset : presets) known.push_back(preset.id);
    return fail(
        fmt::format("preset: found {}, expected one of {}", text::quoted(capture.preset), fmt::join(known, ", ")));
  }
  return capture.task.volume() ? volume_source(capture) : lines_source(capture);
}

}  // namespace axiometry::app
