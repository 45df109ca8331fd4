// SPDX-License-Identifier: Apache-2.0
#include "axiometry/simulation/axis_errors.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "axiometry/simulation/elementary.h"

namespace axiometry::simulation {
namespace {

SlowProcess pitch_walk(const PitchError& pitch, const Plan& plan, std::uint64_t seed) {
  if (!pitch.walk) return {};
  const Reach way = reach(plan);
  const double step = pitch.walk->correlation_length.in_native() / nodes_per_correlation;
  return SlowProcess::stationary({seed, stream_pitch, 0}, {way.lowest.in_native(), way.highest.in_native(), step},
                                 exponential(-1.0 / nodes_per_correlation));
}

double in_table(std::span<const PitchError::Node> table, double p) {
  if (table.empty()) return 0.0;
  const auto above = std::ranges::upper_bound(table, Position::native(p), {}, &PitchError::Node::at);
  if (above == table.begin()) return table.front().deviation.in_native();
  if (above == table.end()) return table.back().deviation.in_native();
  const auto below = above - 1;
  const double part = (p - below->at.in_native()) / (above->at.in_native() - below->at.in_native());
  return below->deviation.in_native() + part * (above->deviation.in_native() - below->deviation.in_native());
}

}  // namespace

AxisErrors::AxisErrors(const VirtualAxis& axis, const Plan& plan, const Timeline& timeline, std::uint64_t seed)
    : axis_(axis),
      legs_(timeline.legs()),
      per_position_(deviation_per_position(plan.axis.kind)),
      first_(plan.targets.front().in_native()),
      travel_(plan.targets.back().in_native() - first_),
      fixed_(axis.thermal.fixed_point ? axis.thermal.fixed_point->in_native() : first_),
      walk_(pitch_walk(axis.pitch, plan, seed)),
      begins_(legs_.size()),
      stick_(legs_.size()),
      quantised_(legs_.size()),
      phase_(legs_.size()),
      rest_(legs_.size()) {
  numeric::fill_normal({seed, stream_stick_slip, 0}, stick_);
  numeric::fill_uniform({seed, stream_hunting, 0}, phase_);
  const double resolution = axis.resolution.in_native() / per_position_;
  Reversal state{gap(legs_.front().to) / 2.0, -1.0};  // it came from above
  for (std::size_t k = 0; k < legs_.size(); ++k) {
    const Leg& leg = legs_[k];
    const double size = leg.towards() > 0.0 ? axis.stick_slip.up.in_native() : axis.stick_slip.down.in_native();
    stick_[k] = leg.approach ? -leg.towards() * size * std::abs(stick_[k]) : 0.0;
    if (resolution > 0.0) quantised_[k] = (std::nearbyint(leg.to / resolution) * resolution - leg.to) * per_position_;
    begins_[k] = state;
    state = reversal(k, leg.to);
    rest_[k] = on_the_way(k, leg.to);
  }
}

double AxisErrors::curve(double p) const {
  const PitchError& pitch = axis_.pitch;
  double d = pitch.slope.in_um_per_m() * 1e-6 * (p - first_) * per_position_;
  if (!pitch.polynomial.empty()) {
    const double u = (p - first_) / travel_;
    double sum = 0.0;
    for (std::size_t k = pitch.polynomial.size(); k-- > 0;) sum = (sum + pitch.polynomial[k].in_native()) * u;
    d += sum;
  }
  d += in_table(pitch.table, p);
  if (pitch.walk) d += pitch.walk->size.in_native() * walk_.at(p);
  for (const CyclicError& cyclic : axis_.cyclic)
    d += cyclic.amplitude.in_native() * wave(p / cyclic.period.in_native() + cyclic.phase.in_deg() / 360.0).sine;
  return d;
}

double AxisErrors::gap(double p) const {
  const Backlash& b = axis_.backlash;
  if (b.wear.in_native() == 0.0) return b.size.in_native();
  const double x = (p - b.wear_at.in_native()) / b.wear_width.in_native();
  return b.size.in_native() + b.wear.in_native() * exponential(-std::min(x * x, 700.0));
}

AxisErrors::Reversal AxisErrors::reversal(std::size_t k, double c) const {
  const Leg& leg = legs_[k];
  const double way = c - leg.from, half = gap(c) / 2.0;
  Reversal state{std::clamp(begins_[k].play - way * per_position_, -half, half), leg.towards()};
  if (axis_.lost_motion.size.in_native() > 0.0)
    state.wind += (begins_[k].wind - leg.towards()) *
                  exponential(-std::min(std::abs(way) / axis_.lost_motion.distance.in_native(), 700.0));
  return state;
}

double AxisErrors::on_the_way(std::size_t k, double c) const {
  const Leg& leg = legs_[k];
  const Reversal state = reversal(k, c);
  const double part = leg.to == leg.from ? 1.0 : (c - leg.from) / (leg.to - leg.from);
  const double before = k > 0 ? stick_[k - 1] + quantised_[k - 1] : 0.0;
  const double after = stick_[k] + quantised_[k];
  return curve(c) + state.play - 0.5 * axis_.lost_motion.size.in_native() * state.wind +
         ((1.0 - part) * before + part * after);
}

double AxisErrors::in_time(std::size_t k, double c, double t) const {
  double d = 0.0;
  if (const ThermalGrowth& thermal = axis_.thermal; thermal.growth.in_native() != 0.0)
    d += thermal.growth.in_native() * (1.0 - exponential(-t / thermal.time_constant.in_s())) *
         (thermal.everywhere ? 1.0 : (c - fixed_) / travel_);
  return d + (t >= legs_[k].arrive ? hunting(k, t) : 0.0);
}

double AxisErrors::stick_expected(const Leg& leg) const {
  const StickSlip& s = axis_.stick_slip;
  const double size = leg.towards() > 0.0 ? s.up.in_native() : s.down.in_native();
  return -leg.towards() * size * std::sqrt(2.0 / std::numbers::pi);
}

double AxisErrors::hunting(std::size_t k, double t) const {
  if (axis_.hunting.amplitude.in_native() == 0.0 || !legs_[k].approach) return 0.0;
  return axis_.hunting.amplitude.in_native() * wave(t / axis_.hunting.period.in_s() + phase_[k]).sine;
}

double AxisErrors::variance(const Leg& leg) const {
  const StickSlip& s = axis_.stick_slip;
  const double stick = leg.towards() > 0.0 ? s.up.in_native() : s.down.in_native();
  const double hunting = axis_.hunting.amplitude.in_native();
  return stick * stick * (1.0 - 2.0 / std::numbers::pi) + 0.5 * hunting * hunting;
}

}  // namespace axiometry::simulation
