// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string_view>

#include "axiometry/simulation/tracked_machine.h"

namespace axiometry::simulation {
namespace {

constexpr double displacement_most_mm = 1e4, relative_most = 0.5, place_most_mm = 1e6;
constexpr std::array<std::string_view, 3> axis_names = {"X", "Y", "Z"};

Result<void> check_length(double mm, std::string_view what, bool signed_too, double most_mm = displacement_most_mm) {
  const double least = signed_too ? -most_mm : 0.0;
  if (mm >= least && mm <= most_mm) return {};
  return fail(fmt::format("found {} of {:g} mm, expected {:g} to {:g} mm", what, mm, least, most_mm));
}

Result<void> check_ratio(RelativeLength x, std::string_view what, bool signed_too = true) {
  const double value = x.in_um_per_m() * 1e-6, least = signed_too ? -relative_most : 0.0;
  if (value >= least && value <= relative_most) return {};
  return fail(fmt::format("found {} of {:g} µm/m, expected {:g} to {:g} µm/m", what, x.in_um_per_m(), least * 1e6,
                          relative_most * 1e6));
}

Result<void> check_wave(const MotionWave& w) {
  AXIOMETRY_TRY_VOID(check_length(w.amplitude.in_mm(), "the amplitude of a sinusoid", true));
  if (w.displaced > 2 || w.moved > 2)
    return fail("found a sinusoid of an axis other than X, Y, Z, expected one of them");
  if (!(w.period_mm > 0.0) || !std::isfinite(w.period_mm) || !std::isfinite(w.phase.in_deg()))
    return fail(fmt::format("found a sinusoid of the period {:g} mm, expected one above 0", w.period_mm));
  // Places are within 1e6 mm; wave() takes turns up to 2⁵².
  if (w.period_mm < 1e-6)
    return fail(fmt::format("found a sinusoid of the period {:g} mm, expected 1e-6 mm or more", w.period_mm));
  return {};
}

}  // namespace

Result<void> check_sound(const TrackedMachine& machine) {
  for (std::size_t a = 0; a < 3; ++a) {
    const auto of = [&](std::string_view what) { return fmt::format("{} of {}", what, axis_names[a]); };
    AXIOMETRY_TRY_VOID(check_length(machine.origin_mm[a], of("the origin"), true, place_most_mm));
    AXIOMETRY_TRY_VOID(check_length(machine.offset_mm[a], of("the offset"), true));
    AXIOMETRY_TRY_VOID(check_ratio(machine.scale[a], of("a scale error")));
    AXIOMETRY_TRY_VOID(check_ratio(machine.warming[a], of("a growing scale error")));
    AXIOMETRY_TRY_VOID(check_length(machine.backlash[a].in_mm(), of("the play"), true));
    AXIOMETRY_TRY_VOID(check_length(machine.repeatability[a].in_mm(), of("the repeatability"), false));
    AXIOMETRY_TRY_VOID(check_length(machine.growth[a].in_mm(), of("the growth"), true));
  }
  AXIOMETRY_TRY_VOID(check_ratio(machine.C0Y, "a squareness C0Y"));
  AXIOMETRY_TRY_VOID(check_ratio(machine.B0Z, "a squareness B0Z"));
  AXIOMETRY_TRY_VOID(check_ratio(machine.A0Z, "a squareness A0Z"));
  for (const MotionWave& w : machine.waves) AXIOMETRY_TRY_VOID(check_wave(w));
  const double time = machine.growth_time.in_s();
  if (!(time > 0.0) || !std::isfinite(time))
    return fail(fmt::format("found the time of growth {:g} s, expected one above 0", time));
  return {};
}

Result<void> check_sound(const VirtualTracker& tracker) {
  for (std::size_t a = 0; a < 3; ++a)
    AXIOMETRY_TRY_VOID(
        check_length(tracker.station_mm[a], fmt::format("the station's {}", axis_names[a]), true, place_most_mm));
  if (tracker.dead_path_mm) AXIOMETRY_TRY_VOID(check_length(*tracker.dead_path_mm, "a dead path", true, place_most_mm));
  AXIOMETRY_TRY_VOID(check_length(tracker.noise.in_mm(), "noise", false));
  AXIOMETRY_TRY_VOID(check_ratio(tracker.noise_per_length, "noise in proportion to the length", false));
  AXIOMETRY_TRY_VOID(check_ratio(tracker.scale_error, "the instrument's scale error"));
  AXIOMETRY_TRY_VOID(check_length(tracker.resolution.in_mm(), "a resolution", false));
  for (std::size_t k = 0; k < tracker.breaks.size(); ++k) {
    AXIOMETRY_TRY_VOID(check_length(tracker.breaks[k].jump_mm, "the jump of a broken beam", true, place_most_mm));
    if (k > 0 && tracker.breaks[k].before_reading <= tracker.breaks[k - 1].before_reading)
      return fail(
          fmt::format("found a broken beam before reading {} after one before reading {}, expected them in order",
                      tracker.breaks[k].before_reading + 1, tracker.breaks[k - 1].before_reading + 1));
  }
  return {};
}

}  // namespace axiometry::simulation
