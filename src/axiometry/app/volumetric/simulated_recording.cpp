// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/volumetric/simulated_recording.h"

#include <algorithm>
#include <cmath>

#include "axiometry/base/contract.h"
#include "axiometry/volumetric/machine/kinematics.h"
#include "axiometry/volumetric/plan/run_way.h"

namespace axiometry::app {
namespace {

using simulation::ReflectorLeg;
using volumetric::CalibrationPlan;
using volumetric::SimulatedJump;
using volumetric::SimulatedLengths;
using volumetric::TrueErrors;
using volumetric::VolumetricReading;

constexpr std::uint64_t stream_part_samples = 67;
constexpr double beam_lost_from = 0.2, beam_lost_to = 0.8;
constexpr double moving_s = 60.0;

double straight_mm(Vector3 a) { return std::sqrt(dot(a, a)); }

/// Of the runs before this one.
std::size_t first_reading(const CalibrationPlan& plan, std::size_t run, const SimulatedLengths& simulated) {
  std::size_t reading = 0;
  for (std::size_t before = 0; before < run; ++before)
    while (reading < simulated.lengths.readings.size() &&
           simulated.lengths.readings[reading].station == plan.runs[before].station &&
           simulated.lengths.readings[reading].tool == plan.runs[before].tool)
      ++reading;
  return reading;
}

}  // namespace

Result<PartsRecording> PartsRecording::make(const CalibrationPlan& plan, PartRange parts, const TrueErrors& errors,
                                            const SimulatedLengths& simulated, const RecordingNoise& noise,
                                            std::uint64_t seed) {
  AXIOMETRY_TRY_VOID(check_parts(plan, parts));
  PartsRecording recording(noise, seed);
  std::size_t reading = first_reading(plan, parts.first - 1, simulated);
  for (std::size_t run = parts.first - 1; run < parts.last; ++run)
    recording.drive(plan, run, errors, simulated, reading);
  recording.way_.after_last();
  AXIOMETRY_TRY(recording.count_, recording.way_.count(noise.rate));
  return recording;
}

void PartsRecording::drive(const CalibrationPlan& plan, std::size_t run, const TrueErrors& errors,
                           const SimulatedLengths& simulated, std::size_t& reading) {
  const volumetric::PlannedRun& planned = plan.runs[run];
  const Vector3 station = plan.machine.stations[planned.station].at_mm;
  const Vector3 tool = plan.machine.tools[planned.tool].offset_mm;
  const auto& readings = simulated.lengths.readings;
  bool begins = true, beam_kept = true;
  std::size_t first_leg = way_.legs().size();
  for (const volumetric::WayPoint& point : volumetric::way_of(plan, planned)) {
    const Vector3 q = point.axes_mm;
    const Vector3 at = q + tool + 1e-3 * volumetric::displacement_exact_um(plan.machine, errors.at(q), q, tool);
    const bool heard = point.is_reading && reading < readings.size() && readings[reading].axes_mm == q &&
                       readings[reading].station == planned.station && readings[reading].tool == planned.tool;
    const double rest_s = heard ? plan.dwell.in_s() : 0.0;
    if (begins)
      way_.carry(at, moving_s, rest_s + simulation::ReflectorWay::rest_s);
    else
      way_.go(at, plan.feed_mm_per_min, rest_s);
    errors_.resize(way_.legs().size(), {.station_mm = station});
    beam_kept = beam_kept && (begins || !point.is_reading || point.beam_kept);
    begins = false;
    if (!heard) continue;
    double jump_um = 0.0;
    bool told = !beam_kept;
    for (const SimulatedJump& jump :
         std::ranges::equal_range(simulated.jumps, reading, {}, &SimulatedJump::before_reading)) {
      jump_um += jump.jump_um;
      told = told || jump.told;
    }
    arrive(first_leg, readings[reading].length_mm - straight_mm(at - station), 1e-3 * jump_um, told);
    first_leg = way_.legs().size();
    beam_kept = true;
    ++reading;
  }
  const double last = first_leg > 0 ? errors_[first_leg - 1].to_mm : 0.0;
  for (std::size_t leg = first_leg; leg < errors_.size(); ++leg) errors_[leg].from_mm = errors_[leg].to_mm = last;
}

/// The legs up to a stop, where a length of that error is shown.
void PartsRecording::arrive(std::size_t first_leg, double error_mm, double jump_mm, bool is_lost) {
  const std::span<ReflectorLeg> legs = way_.legs();
  if (first_leg == 0 || legs[first_leg].lost_to == 1.0) {  // of the part
    for (std::size_t leg = first_leg; leg < legs.size(); ++leg) errors_[leg].from_mm = errors_[leg].to_mm = error_mm;
    return;
  }
  const auto longest = std::ranges::max_element(legs.begin() + static_cast<std::ptrdiff_t>(first_leg), legs.end(), {},
                                                &ReflectorLeg::way_s) -
                       legs.begin();
  double error = errors_[first_leg - 1].to_mm;
  for (std::size_t leg = first_leg; leg < legs.size(); ++leg) {
    errors_[leg].from_mm = error;
    if (static_cast<std::ptrdiff_t>(leg) == longest) {
      errors_[leg].jump_mm = jump_mm;
      error += jump_mm;
    }
    if (leg + 1 == legs.size()) error = error_mm;
    errors_[leg].to_mm = error;
  }
  if (!is_lost) return;
  legs[static_cast<std::size_t>(longest)].lost_from = beam_lost_from;
  legs[static_cast<std::size_t>(longest)].lost_to = beam_lost_to;
}

Result<void> PartsRecording::record(const SampleSink& sink) const {
  const double sigma = noise_.sigma.in_mm();
  return way_.record(
      noise_.rate, seed_, stream_part_samples,
      [&](std::size_t leg, double share, Vector3 at, double normal) {
        const LegError& e = errors_[leg];
        const double error = e.from_mm + share * (e.to_mm - e.from_mm - e.jump_mm) + (share >= 0.5 ? e.jump_mm : 0.0);
        return straight_mm(at - e.station_mm) + error + sigma * normal;
      },
      sink);
}

}  // namespace axiometry::app
