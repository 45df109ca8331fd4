// SPDX-License-Identifier: Apache-2.0
#include "axiometry/simulation/timeline.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "axiometry/simulation/elementary.h"

namespace axiometry::simulation {
namespace {

constexpr std::size_t approaches_max = 1'000'000;
constexpr double settled_to = 0.01;  // µm or ″

std::string text_of(const Approach& a) {
  return fmt::format("run {} {} of target {}", a.run + 1, arrow(a.direction), a.target + 1);
}

/// Fails unless each is an approach of the plan, and given once.
Result<void> check_known(const std::vector<Approach>& list, const std::vector<Approach>& planned) {
  for (std::size_t k = 0; k < list.size(); ++k) {
    if (std::ranges::find(planned, list[k]) == planned.end())
      return fail(fmt::format("found {}, expected an approach that the plan has", text_of(list[k])));
    if (std::find(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(k), list[k]) !=
        list.begin() + static_cast<std::ptrdiff_t>(k))
      return fail(fmt::format("found {} a second time, expected each once", text_of(list[k])));
  }
  return {};
}

/// The same plan with another order of approaches.
Plan with_sequence(Plan plan, std::vector<Approach> sequence) {
  plan.cycle = TestCycle::user_defined;
  plan.sequence = std::move(sequence);
  return plan;
}

/// The plan that the machine follows instead, but for doubled approaches.
Result<Plan> departed(const Plan& plan, const Departures& departures) {
  std::vector<Approach> sequence = approaches(plan);
  AXIOMETRY_TRY_VOID(check_known(departures.missed, sequence));
  AXIOMETRY_TRY_VOID(check_known(departures.doubled, sequence));
  for (const Approach& a : departures.doubled)
    if (std::ranges::find(departures.missed, a) != departures.missed.end())
      return fail(fmt::format("found {} both missed and doubled, expected one of the two", text_of(a)));
  if (departures.missed.empty() && departures.reversed_runs.empty()) return plan;
  if (!departures.reversed_runs.empty() && plan.cycle != TestCycle::standard)
    return fail(fmt::format("found a reversed run in the {} cycle, expected one in the standard cycle",
                            cycle_name(plan.cycle)));
  for (const std::size_t run : departures.reversed_runs) {
    if (run >= plan.runs) return fail(fmt::format("found reversed run {}, expected 1 to {}", run + 1, plan.runs));
    if (std::ranges::count(departures.reversed_runs, run) > 1)
      return fail(fmt::format("found reversed run {} twice, expected it once", run + 1));
    const auto of_run = [&](const Approach& a) { return a.run == run; };
    const auto begin = std::ranges::find_if(sequence, of_run);
    const auto middle = begin + static_cast<std::ptrdiff_t>(plan.targets.size());
    std::rotate(begin, middle, middle + static_cast<std::ptrdiff_t>(plan.targets.size()));
  }
  std::erase_if(sequence,
                [&](const Approach& a) { return std::ranges::find(departures.missed, a) != departures.missed.end(); });
  if (sequence.empty()) return fail("found every approach missed, expected one that is made");
  return with_sequence(plan, std::move(sequence));
}

}  // namespace

Timeline::Timeline(const VirtualAxis& axis) : acceleration_(axis.acceleration) {
  if (!axis.servo) return;
  servo_ = true;
  omega_ = 2.0 * std::numbers::pi / axis.servo->period.in_s();
  decay_ = axis.servo->damping * omega_;
  frequency_ = std::sqrt(1.0 - axis.servo->damping * axis.servo->damping) / axis.servo->period.in_s();
}

Result<Timeline> Timeline::make(const Plan& plan, const VirtualAxis& axis, const Departures& departures) {
  if (plan.targets.size() > approaches_max / (2 * plan.runs))
    return fail(fmt::format("found {} targets of {} runs, expected at most {} approaches", plan.targets.size(),
                            plan.runs, approaches_max));
  AXIOMETRY_TRY(const Plan followed, departed(plan, departures));
  const double feed = plan.feed / 60.0, dwell = plan.dwell.in_s();
  Timeline timeline(axis);
  timeline.small_ = settled_to / deviation_per_position(plan.axis.kind);
  const std::vector<PlannedMove> list = moves(followed);
  Leg& first = timeline.legs_.emplace_back();
  first.from = first.to = list.front().to.in_native();
  first.leave = rest_s;
  first.phases.fill({.at = first.to});
  for (std::size_t k = 1; k < list.size(); ++k) {
    const auto& approach = list[k].approach;
    const double to = list[k].to.in_native();
    timeline.add(to, feed, approach ? dwell : 0.0);
    timeline.legs_.back().approach = approach;
    if (!approach || std::ranges::find(departures.doubled, *approach) == departures.doubled.end()) continue;
    timeline.add(to - timeline.legs_.back().towards() * plan.overrun.in_native(), feed, 0.0);
    timeline.add(to, feed, dwell);
    timeline.legs_.back().approach = approach;
    timeline.legs_.back().extra = true;
  }
  timeline.legs_.back().leave += rest_s;
  return timeline;
}

void Timeline::add(double to, double feed, double dwell) {
  Leg leg;
  leg.begin = legs_.back().leave;
  leg.from = legs_.back().to;
  leg.to = to;
  const double way = std::abs(to - leg.from);
  const double speed = std::min(feed, std::sqrt(way * acceleration_));
  const double ramp_s = speed / acceleration_;
  const double cruise_s = way / speed - ramp_s;
  const double ramp = 0.5 * speed * ramp_s, sign = leg.towards();
  leg.phases[0] = {.begin = leg.begin, .at = leg.from, .acceleration = sign * acceleration_};
  leg.phases[1] = {.begin = leg.begin + ramp_s, .at = leg.from + sign * ramp, .speed = sign * speed};
  leg.phases[2] = {.begin = leg.begin + ramp_s + std::max(cruise_s, 0.0),
                   .at = to - sign * ramp,
                   .speed = sign * speed,
                   .acceleration = -sign * acceleration_};
  leg.arrive = leg.phases[2].begin + ramp_s;
  leg.phases[3] = {.begin = leg.arrive, .at = to};
  leg.leave = leg.arrive + dwell;
  leg.settled = leg.arrive;
  if (servo_) follow(leg);
  legs_.push_back(leg);
}

/// The constants of each phase, from e and e′ where the one before ends.
void Timeline::follow(Leg& leg) {
  const double damped = 2.0 * std::numbers::pi * frequency_;
  for (std::size_t k = 0; k < leg.phases.size(); ++k) {
    Phase& p = leg.phases[k];
    p.beta = 2.0 * decay_ * p.acceleration / (omega_ * omega_);
    p.alpha = (p.acceleration + 2.0 * decay_ * (p.speed - p.beta)) / (omega_ * omega_);
    p.cosine = lag_ - p.alpha;
    p.sine = (lag_speed_ - p.beta + decay_ * p.cosine) / damped;
    const double end = k + 1 < leg.phases.size() ? leg.phases[k + 1].begin : leg.leave;
    const double tau = end - p.begin;
    const Wave w = wave(frequency_ * tau);
    const double fading = exponential(-decay_ * tau);
    lag_ = following_error(p, end);
    lag_speed_ = p.beta + fading * ((damped * p.sine - decay_ * p.cosine) * w.cosine -
                                    (damped * p.cosine + decay_ * p.sine) * w.sine);
  }
  const Phase& rest = leg.phases.back();
  const double size = std::sqrt(rest.cosine * rest.cosine + rest.sine * rest.sine);
  const auto within = [&](double t) { return size * exponential(-decay_ * (t - leg.arrive)) <= small_; };
  if (within(leg.arrive)) return;
  double outside = leg.arrive;
  leg.settled = leg.leave;
  if (!within(leg.leave)) return;
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (outside + leg.settled);
    (within(middle) ? leg.settled : outside) = middle;
  }
}

const Phase& Timeline::phase_at(const Leg& leg, double t) {
  std::size_t k = leg.phases.size() - 1;
  while (k > 0 && t < leg.phases[k].begin) --k;
  return leg.phases[k];
}

double Timeline::command(const Leg& leg, const Phase& phase, double t) {
  if (t >= leg.arrive) return leg.to;
  const double tau = t - phase.begin;
  return phase.at + tau * (phase.speed + 0.5 * phase.acceleration * tau);
}

double Timeline::following_error(const Phase& phase, double t) const {
  if (!servo_) return 0.0;
  const double tau = t - phase.begin;
  const double steady = phase.alpha + phase.beta * tau;
  const double fading = exponential(-decay_ * tau);
  if (fading < 1e-16) return steady;  // of a way of a kilometre a picometre
  const Wave w = wave(frequency_ * tau);
  return steady + fading * (phase.cosine * w.cosine + phase.sine * w.sine);
}

}  // namespace axiometry::simulation
