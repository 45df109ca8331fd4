// SPDX-License-Identifier: Apache-2.0
#include "axiometry/simulation/presets.h"

#include <algorithm>

namespace axiometry::simulation {
namespace {

Deviation size(double um_or_arcsec) { return Deviation::native(um_or_arcsec); }

double travel_of(const Plan& plan) {
  return plan.targets.empty() ? 1.0 : plan.targets.back().in_native() - plan.targets.front().in_native();
}

/// The place at this part of the travel.
Position part_of(const Plan& plan, double part) {
  return Position::native(plan.targets.empty() ? 0.0 : plan.targets.front().in_native() + part * travel_of(plan));
}

/// A correlation length or width; a travel of nothing is refused elsewhere.
Position length(const Plan& plan, double part) { return Position::native(std::max(part * travel_of(plan), 1e-6)); }

/// The slope that makes this deviation at the end of the travel.
RelativeLength over_travel(const Plan& plan, double um_or_arcsec) {
  return RelativeLength::um_per_m(um_or_arcsec * 1e6 / deviation_per_position(plan.axis.kind) /
                                  std::max(travel_of(plan), 1e-6));
}

/// A machine in good order: a µm of everything or less.
VirtualAxis good(const Plan& plan) {
  VirtualAxis axis;
  axis.pitch.walk = PitchError::Walk{size(0.5), length(plan, 0.25)};
  axis.backlash.size = size(0.4);
  axis.stick_slip = {size(0.2), size(0.2)};
  axis.instrument.noise = size(0.1);
  axis.instrument.resolution = size(0.01);
  return axis;
}

VirtualAxis backlash(const Plan& plan) {
  VirtualAxis axis = good(plan);
  axis.backlash.size = size(6.0);
  return axis;
}

VirtualAxis worn_screw(const Plan& plan) {
  VirtualAxis axis = good(plan);
  axis.backlash = {size(1.5), size(7.0), part_of(plan, 0.4), length(plan, 0.15)};
  axis.pitch.table = {
      {part_of(plan, 0.15), size(0.0)}, {part_of(plan, 0.4), size(3.0)}, {part_of(plan, 0.65), size(0.0)}};
  return axis;
}

VirtualAxis lost_motion(const Plan& plan) {
  VirtualAxis axis = good(plan);
  axis.lost_motion = {size(5.0), length(plan, 0.12)};
  return axis;
}

VirtualAxis pitch(const Plan& plan) {
  VirtualAxis axis = good(plan);
  axis.pitch.slope = over_travel(plan, 6.0);
  axis.pitch.polynomial = {size(8.0), size(-8.0)};
  return axis;
}

VirtualAxis cyclic(const Plan& plan) {
  VirtualAxis axis = good(plan);
  const Position period = plan.axis.expected_period.value_or(Position::native(10.0));
  axis.cyclic = {{period, size(2.0), Angle::deg(0.0)},
                 {Position::native(0.5 * period.in_native()), size(0.5), Angle::deg(60.0)}};
  return axis;
}

VirtualAxis thermal(const Plan& plan) {
  VirtualAxis axis = good(plan);
  axis.thermal = {size(12.0), Duration::s(1200.0), {}, false};
  return axis;
}

VirtualAxis stick_slip(const Plan& plan) {
  VirtualAxis axis = good(plan);
  axis.stick_slip = {size(3.0), size(1.0)};
  return axis;
}

VirtualAxis noise(const Plan& plan) {
  VirtualAxis axis = good(plan);
  axis.instrument.noise = size(1.5);
  return axis;
}

VirtualAxis outliers(const Plan& plan) {
  VirtualAxis axis = good(plan);
  axis.instrument.outlier_probability = 0.02;
  axis.instrument.outlier_size = size(20.0);
  return axis;
}

VirtualAxis loose_optics(const Plan& plan) {
  VirtualAxis axis = good(plan);
  axis.instrument.slip_probability = 0.06;
  axis.instrument.slip_size = size(3.0);
  return axis;
}

VirtualAxis drift(const Plan& plan) {
  VirtualAxis axis = good(plan);
  axis.instrument.drift_per_root_hour = size(10.0);
  return axis;
}

VirtualAxis air(const Plan& plan) {
  VirtualAxis axis = good(plan);
  axis.instrument.air.slow = over_travel(plan, 3.0);
  axis.instrument.air.random = over_travel(plan, 1.0);
  axis.instrument.air.slow_period = Duration::s(600.0);
  return axis;
}

VirtualAxis wrong_expansion(const Plan& plan) {
  VirtualAxis axis = good(plan);
  axis.instrument.expansion = {.machine = Temperature::celsius(25.0),
                               .machine_expansion = ExpansionCoefficient::um_per_m_K(11.5),
                               .assumed_expansion = ExpansionCoefficient::um_per_m_K(8.0)};
  return axis;
}

VirtualAxis servo_hunting(const Plan& plan) {
  VirtualAxis axis = good(plan);
  axis.servo = Servo{Duration::s(0.05), 0.12};
  axis.hunting = {size(1.5), Duration::s(0.11)};
  return axis;
}

VirtualAxis mixed(const Plan& plan) {
  VirtualAxis axis = good(plan);
  axis.backlash.size = size(3.0);
  axis.cyclic = {{plan.axis.expected_period.value_or(Position::native(10.0)), size(1.2), Angle::deg(0.0)}};
  axis.pitch.polynomial = {size(10.0), size(-6.0)};
  axis.thermal = {size(6.0), Duration::s(1200.0), {}, false};
  axis.stick_slip = {size(0.8), size(0.8)};
  axis.servo = Servo{Duration::s(0.05), 0.5};
  axis.instrument.vibration = size(0.2);
  return axis;
}

constexpr Preset table[] = {
    {"good", "nothing: an axis in good order", "A few µm of everything; curves without a pattern", good},
    {"backlash", "play in the drive", "The curves ↑ and ↓ are parallel, B as large at every target", backlash},
    {"worn-screw", "play and pitch error where the screw is used most", "B grows in one part of the travel",
     worn_screw},
    {"lost-motion", "elastic wind-up that needs a way to turn round",
     "The curves ↑ and ↓ part slowly behind each end of the travel", lost_motion},
    {"pitch", "pitch errors of screw or scale",
     "↑ and ↓ follow one slanted or bent curve; E and M large, B and R small", pitch},
    {"cyclic", "an error that repeats with every turn of the screw",
     "A jagged curve that ↑ and ↓ share; its period shows only at targets closer than it", cyclic},
    {"thermal", "the screw grows while the test runs",
     "Each run lies above the one before, most at the far end; R grows along the travel", thermal},
    {"stick-slip", "friction lets the axis stop short, more ↑ than ↓", "R↑ larger than R↓, ↑ below ↓ on average",
     stick_slip},
    {"noise", "a restless instrument or table", "Wide bands of the same size at every target, both directions", noise},
    {"outliers", "single readings far away", "One wide band among narrow ones", outliers},
    {"loose-optics", "a mirror that shifts now and then", "Whole runs, or parts of them, lie apart at every target",
     loose_optics},
    {"drift", "the zero of the instrument wanders", "Runs lie apart by the same amount at every target", drift},
    {"air", "turbulent or drifting air in the beam", "Bands that widen with the distance from the zero point", air},
    {"wrong-expansion-coefficient", "the instrument corrects a warm machine with another material's expansion",
     "A straight slope that no screw has; E grows with the travel, R stays small", wrong_expansion},
    {"servo-hunting", "a control loop that does not come to rest",
     "Wide bands without outliers; the recording swings at rest", servo_hunting},
    {"mixed", "a bit of everything, as machines have it", "Look for one fault after the other, largest first", mixed},
};

}  // namespace

std::span<const Preset> presets() { return table; }

const Preset* find_preset(std::string_view id) {
  const auto found = std::ranges::find(table, id, &Preset::id);
  return found == std::end(table) ? nullptr : found;
}

}  // namespace axiometry::simulation
