// SPDX-License-Identifier: Apache-2.0
#include "axiometry/simulation/virtual_axis.h"

#include "axiometry/base/reading_limits.h"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

namespace axiometry::simulation {
namespace {

constexpr double deviation_limit = 1e6;  // a metre or 278°
constexpr double time_limit = 1e9;       // thirty years
constexpr double period_min_s = 1e-6;
constexpr double relative_limit = 1e5;  // µm/m: a tenth
constexpr double nodes_limit = 1e7;

struct Range {
  double lowest;
  double highest;
};

/// A number with its name; NaN is in no range.
Result<void> check(std::string_view what, double x, Range range) {
  if (x >= range.lowest && x <= range.highest) return {};
  return fail(fmt::format("found {} of {}, expected {} to {}", what, x, range.lowest, range.highest));
}

Result<void> check_size(std::string_view what, Deviation x) {
  return check(what, x.in_native(), {0.0, deviation_limit});
}
Result<void> check_signed(std::string_view what, Deviation x) {
  return check(what, x.in_native(), {-deviation_limit, deviation_limit});
}
Result<void> check_position(std::string_view what, Position x) {
  return check(what, x.in_native(), {-largest_stated, largest_stated});
}
Result<void> check_distance(std::string_view what, Position x) {
  return check(what, x.in_native(), {1e-9, largest_stated});
}
Result<void> check_time(std::string_view what, Duration x) { return check(what, x.in_s(), {period_min_s, time_limit}); }
Result<void> check_relative(std::string_view what, RelativeLength x, double lowest) {
  return check(what, x.in_um_per_m(), {lowest, relative_limit});
}

Result<void> check_pitch(const PitchError& pitch, const Plan& plan) {
  AXIOMETRY_TRY_VOID(check_relative("a slope (µm/m)", pitch.slope, -relative_limit));
  for (const Deviation c : pitch.polynomial) AXIOMETRY_TRY_VOID(check_signed("a polynomial coefficient", c));
  for (std::size_t k = 0; k < pitch.table.size(); ++k) {
    AXIOMETRY_TRY_VOID(check_position("a place in the table of pitch errors", pitch.table[k].at));
    AXIOMETRY_TRY_VOID(check_signed("a pitch error", pitch.table[k].deviation));
    if (k > 0 && pitch.table[k].at <= pitch.table[k - 1].at)
      return fail(fmt::format("found {} after {} in the table of pitch errors, expected ascending places",
                              pitch.table[k].at.in_native(), pitch.table[k - 1].at.in_native()));
  }
  if (!pitch.walk) return {};
  AXIOMETRY_TRY_VOID(check_size("a random pitch error", pitch.walk->size));
  AXIOMETRY_TRY_VOID(check_distance("a correlation length", pitch.walk->correlation_length));
  const Reach way = reach(plan);
  const double nodes =
      8.0 * (way.highest.in_native() - way.lowest.in_native()) / pitch.walk->correlation_length.in_native();
  return check("a number of nodes of the random pitch error", nodes, {0.0, nodes_limit});
}

Result<void> check_reversal(const VirtualAxis& axis) {
  AXIOMETRY_TRY_VOID(check_size("a backlash", axis.backlash.size));
  AXIOMETRY_TRY_VOID(check_size("a wear", axis.backlash.wear));
  AXIOMETRY_TRY_VOID(check_position("a place of the wear", axis.backlash.wear_at));
  AXIOMETRY_TRY_VOID(check_distance("a width of the wear", axis.backlash.wear_width));
  // A gap that grows faster than the axis moves would be no play. Both kinds of axes: ″ in a ° is the larger factor.
  if (axis.backlash.wear.in_native() > 0.1 * 1000.0 * axis.backlash.wear_width.in_native())
    return fail(fmt::format("found a wear of {} within {}, expected a width of at least ten times the wear",
                            axis.backlash.wear.in_native(), axis.backlash.wear_width.in_native()));
  AXIOMETRY_TRY_VOID(check_size("a lost motion", axis.lost_motion.size));
  AXIOMETRY_TRY_VOID(check_distance("a distance of the lost motion", axis.lost_motion.distance));
  AXIOMETRY_TRY_VOID(check_size("a stick-slip", axis.stick_slip.up));
  return check_size("a stick-slip", axis.stick_slip.down);
}

Result<void> check_motion(const VirtualAxis& axis) {
  AXIOMETRY_TRY_VOID(check_signed("a thermal growth", axis.thermal.growth));
  AXIOMETRY_TRY_VOID(check_time("a time constant (s)", axis.thermal.time_constant));
  if (axis.thermal.fixed_point) AXIOMETRY_TRY_VOID(check_position("a fixed point", *axis.thermal.fixed_point));
  if (axis.servo) {
    AXIOMETRY_TRY_VOID(check("a period of the servo (s)", axis.servo->period.in_s(), {1e-4, 1e3}));
    AXIOMETRY_TRY_VOID(check("a damping of the servo", axis.servo->damping, {0.05, 0.95}));
  }
  AXIOMETRY_TRY_VOID(check_size("an amplitude of the hunting", axis.hunting.amplitude));
  AXIOMETRY_TRY_VOID(check_time("a period of the hunting (s)", axis.hunting.period));
  AXIOMETRY_TRY_VOID(check_size("a resolution of the axis", axis.resolution));
  return check("an acceleration", axis.acceleration, {1e-3, 1e6});
}

Result<void> check_instrument(const VirtualInstrument& instrument, AxisKind kind) {
  AXIOMETRY_TRY_VOID(check_size("a noise", instrument.noise));
  AXIOMETRY_TRY_VOID(check_size("a drift", instrument.drift_per_root_hour));
  AXIOMETRY_TRY_VOID(check_size("a resolution of the instrument", instrument.resolution));
  AXIOMETRY_TRY_VOID(check("a probability of outliers", instrument.outlier_probability, {0.0, 1.0}));
  AXIOMETRY_TRY_VOID(check_size("a size of outliers", instrument.outlier_size));
  AXIOMETRY_TRY_VOID(check("a probability of slips", instrument.slip_probability, {0.0, 1.0}));
  AXIOMETRY_TRY_VOID(check_size("a size of slips", instrument.slip_size));
  AXIOMETRY_TRY_VOID(check_size("a vibration", instrument.vibration));
  AXIOMETRY_TRY_VOID(check_time("a period of the vibration (s)", instrument.vibration_period));
  const VirtualInstrument::Air& air = instrument.air;
  AXIOMETRY_TRY_VOID(check_relative("a slow variation of the air (µm/m)", air.slow, 0.0));
  AXIOMETRY_TRY_VOID(check_time("a period of the air (s)", air.slow_period));
  AXIOMETRY_TRY_VOID(check_relative("a random variation of the air (µm/m)", air.random, 0.0));
  AXIOMETRY_TRY_VOID(check_time("a correlation time of the air (s)", air.random_time));
  AXIOMETRY_TRY_VOID(check("a dead path", air.dead_path.in_native(), {0.0, largest_stated}));
  if (!instrument.expansion) return {};
  if (kind == AxisKind::rotary)
    return fail("found an expansion coefficient for a rotary axis, expected it for a linear one only");
  constexpr Range expansions{-100.0, 100.0};
  AXIOMETRY_TRY_VOID(check("a machine temperature (°C)", instrument.expansion->machine.in_celsius(), {-50.0, 150.0}));
  AXIOMETRY_TRY_VOID(check("an expansion of the machine (µm/(m·°C))",
                           instrument.expansion->machine_expansion.in_um_per_m_K(), expansions));
  return check("an assumed expansion (µm/(m·°C))", instrument.expansion->assumed_expansion.in_um_per_m_K(), expansions);
}

}  // namespace

Result<void> check_sound(const VirtualAxis& axis, const Plan& plan) {
  AXIOMETRY_TRY_VOID(axiometry::check_sound(plan));
  if (plan.targets.size() < 2) return fail("found a plan of one target, expected two or more");
  AXIOMETRY_TRY_VOID(check_pitch(axis.pitch, plan));
  for (const CyclicError& cyclic : axis.cyclic) {
    AXIOMETRY_TRY_VOID(check_distance("a period of a cyclic error", cyclic.period));
    AXIOMETRY_TRY_VOID(check_signed("an amplitude of a cyclic error", cyclic.amplitude));
    AXIOMETRY_TRY_VOID(check("a phase of a cyclic error (°)", cyclic.phase.in_deg(), {-360.0, 360.0}));
  }
  AXIOMETRY_TRY_VOID(check_reversal(axis));
  AXIOMETRY_TRY_VOID(check_motion(axis));
  return check_instrument(axis.instrument, plan.axis.kind);
}

}  // namespace axiometry::simulation
