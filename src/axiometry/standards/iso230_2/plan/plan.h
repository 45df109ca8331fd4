// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/plan.h"
#include "axiometry/standards/iso230_2/assessment/assessment.h"

/// The test programme of ISO 230-2:2014: clauses 4.3, 5.2, 5.3.2 to 5.3.5, Table 1, Annexes B and C. Clauses 5.3.3 and
/// 5.3.4 follow general knowledge.
///
/// **Targets**, formula (1): P_i = (i − 1)·p + r over the measurement travel, p its length divided by m − 1, with a
/// fresh r for each target, uniform within ±R. R is one period of the expected periodic error, and 30 % of p when none
/// is expected. Where the period is longer than 0.3 p, R stays 0.3 p: the order of the targets is kept, and up to a
/// period of 0.6 p every phase of it can still be drawn, while a longer one is sampled by the steps of p themselves;
/// plan_findings() says so. The first and the last target shift inwards only, by at most R and 5 % of the measurement
/// travel (and so that a travel above 2 000 mm or 360° stays above), because the overruns beyond them must fit.
/// Targets are rounded to a step that controls take, 0.001 mm or 0.0001° unless told otherwise.
/// Since r is uniform over whole periods, it samples them evenly even where p is a multiple of the period.
///
/// **Compensation**: a target on a sampling point (3.28) is drawn again, at first until it is R/20 away from all, then
/// until it is no longer within 0.001 mm or °; plan_findings() names those for which there is no such place.
///
/// **Principal positions**: on a rotary axis up to 360° the multiples of 90° inside the measurement travel take the
/// place of the nearest target and have no random part, since 5.3.4 wants them measured as such; where one is a
/// sampling point of the compensation, the target stands within 0.1° of it instead.
///
/// **Turning without end**: a rotary axis whose travel is exactly 360° and that has no soft limits is taken for one
/// that turns on. Its targets divide the turn (p = 360°/m, m a multiple of 4) and its overruns have no limits.
///
/// **Numbers**: the random part of target i depends on the seed and i alone (numeric/random/random.h), so that a seed
/// gives the same plan on every platform.
namespace axiometry::iso230_2 {

/// A part of an axis, mm or °.
struct Stretch {
  Position from;
  Position to;
  double length() const { return to.in_native() - from.in_native(); }
};

/// The test for a periodic error (Annex C): targets at an eighth of the period, ±30 % of that, over three periods.
struct PeriodicTest {
  std::optional<Position> at;  ///< middle of the targets; of the axis travel when absent
};

/// How many targets a plan has at most.
inline constexpr std::size_t targets_most = 10'000;

/// What the user wants. What is absent is chosen as make_plan() says.
struct PlanRequest {
  Axis axis;                           ///< travel_begin and travel_end must be given
  std::vector<MotionName> errors;      ///< copied: what is to be read at the stops
  std::string machine;                 ///< copied, as the next
  std::string date;                    ///< "2026-11-21"
  std::optional<Stretch> measurement;  ///< measurement travel (3.2)
  std::optional<Stretch> soft_limits;  ///< soft limits of the control, where they differ from the axis travel
  TestCycle cycle = TestCycle::standard;
  std::vector<Approach> sequence;           ///< approaches of the user-defined cycle
  std::vector<Position> targets;            ///< given by the user, in any order; empty: drawn
  std::optional<std::size_t> count;         ///< m
  std::optional<Position> interval;         ///< p at most
  std::optional<std::size_t> runs;          ///< n
  std::string rule;                         ///< copied
  std::size_t least_runs = 0;               ///< n at least where it is not given; of areas always, which no user gives
  std::optional<std::size_t> area_targets;  ///< m of areas; as the clause asks for when absent
  bool equal_steps = false;  ///< targets without a random part, from one end of travel and areas to the other
  std::optional<Position> overrun;
  std::optional<double> feed;  ///< mm/min or °/min
  std::optional<Duration> dwell;
  std::optional<std::size_t> warm_up_runs;
  std::optional<Position> segment;  ///< length of the segments of a scale, from the beginning of the travel (5.3.3)
  std::vector<Stretch> areas;       ///< stretches of the normal working area, for the tests that belong to a long one
  std::optional<Position> step;     ///< step to which target positions are rounded
  std::optional<double> acceleration;    ///< mm/s² or °/s²
  std::optional<PeriodicTest> periodic;  ///< instead of all that clause 5 asks; needs axis.expected_period
  std::uint64_t seed = 0;
};

/// Defaults: 1 000 mm/min or 720 °/min, a dwell of 3 s, one warm-up run, 1 000 mm/s² (0.1 g) or 500 °/s².
/// n is 5, and 1 above 2 000 mm or 360° and in the test for a periodic error.
///
/// Overrun: 1 % of the axis travel within 1 and 10 mm or °, and more where the feed v is not reached in it: v²/a from
/// rest to rest, but at most 10 % of the axis travel; rounded up to whole mm or °. Where the measurement travel is
/// given and leaves less room, that room, if it is 1 mm or ° at least.
///
/// Measurement travel: all that the overruns leave of the axis travel (and of the soft limits); of a rotary axis at
/// most five revolutions in its middle.
///
/// m: what the clause asks for; a mean interval of 250 mm (or one segment, if that is less) above 2 000 mm. Each
/// segment of the scale that is left without a target is given one more.
///
/// Of errors without the positions of the axis: the same targets and runs, but no clause and nothing further.
///
/// `further` (of tests above 2 000 mm or 360°): five approaches over each stretch of the normal working area, by
/// default one in the middle of the measurement travel.
///
/// Fails, with the numbers, on a travel that is missing, reversed or empty, on numbers that are not finite or not
/// positive, on targets, overruns or stretches beyond the travel or the soft limits, on a travel too short for the
/// targets, on more than 10 000 targets, on a period that is missing or does not fit, and as
/// check_sound() does.
Result<Plan> make_plan(const PlanRequest& request);

/// What the standard has to say about a plan, also one that people have edited: the rules of find_departures() that
/// concern the programme, as if every approach had been measured, and those that only a plan can break (overruns beyond
/// the travel, a feed that is not reached, no warm-up, a period that the targets do not sample). Departures first. Of a
/// plan without positions, of which the standard says nothing, only what keeps the axis from following it, and what
/// holds at every stop. Findings about a further plan begin with its title. Needs a sound plan.
std::vector<Finding> plan_findings(const Plan& plan);

/// A test that followed the plan and found no deviation; nothing where it is too large for one. Needs a sound plan.
std::optional<Series> series_of(const Plan& plan);

/// No finding is a departure.
bool conforming(std::span<const Finding> findings);

/// Nor is anything missing with which evaluating the test would find it not to be in accordance with the standard: a
/// warm-up, a rest at the targets, a random part of them. Only then may a plan be called one after the standard.
bool in_accordance(std::span<const Finding> findings);

/// mm/s² or °/s²: the plan's, or the usual one when nothing is known about the axis, 1 000 mm/s² or 500 °/s².
double acceleration_of(const Plan& plan);

/// From the first command to the last, from rest to rest on each: with the feed v, the acceleration a (of speeding up
/// and slowing down) and the distance d, d/v + v/a, or 2·√(d/a) where d < v²/a; and a dwell at each approach; the ways
/// in and out of a line in space likewise, point by point. Without the further plans. Needs a sound plan.
Duration estimated_duration(const Plan& plan);

/// How long each of moves(plan) takes, without the dwell at its end; 0 for the first, which comes from anywhere.
std::vector<Duration> move_durations(const std::vector<PlannedMove>& moves, double feed, double acceleration);

/// The least distance from rest to rest on which the feed is reached: v²/a.
Position distance_to_feed(const Plan& plan);

}  // namespace axiometry::iso230_2
