// SPDX-License-Identifier: Apache-2.0
//
// A plan is judged by the rules for measured tests, on a test that has followed it and found no deviation at all, so
// that what conforms as a plan conforms when it is measured; and by some more, which only a plan can break.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "axiometry/base/counted.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/standards/iso230_2/plan/further.h"
#include "axiometry/standards/iso230_2/plan/plan.h"
#include "axiometry/standards/iso230_2/programme.h"
#include "axiometry/standards/iso230_2/rules/message.h"
#include "axiometry/standards/iso230_2/rules/rules.h"

namespace axiometry::iso230_2 {
namespace {

using rules::Case;

constexpr std::size_t most_readings = 20'000'000;
constexpr double position_slack = 1e-6;  // mm or °
constexpr double dwell_least_s = 0.1;    // no control settles and no instrument averages in less
constexpr double overrun_least_mm = 0.1, overrun_least_deg = 0.01;  // above the reversal error of a sound axis
constexpr double least_phases = 0.25;     // of the period: fewer are missed by chance of five targets in 2 % of plans
constexpr double periods_at_least = 2.0;  // Annex C
constexpr double targets_per_period_least = 4.0;  // Annex C: half the period is the limit, where nothing can be told

std::string position_text(const Plan& plan, double x) { return rules::position_text(plan.axis.kind, x); }

double travel_of(const Plan& plan) { return plan.targets.back().in_native() - plan.targets.front().in_native(); }

using PlanRule = std::optional<Finding>(const Plan&);

std::optional<Finding> reach_within_travel(const Plan& plan) {
  const auto [lowest, highest] = reach(plan);
  const Axis& axis = plan.axis;
  std::string ends;
  if (axis.travel_begin && lowest.in_native() < axis.travel_begin->in_native() - position_slack)
    ends = fmt::format("the overrun at {} below the axis travel from {}", position_text(plan, lowest.in_native()),
                       position_text(plan, axis.travel_begin->in_native()));
  if (axis.travel_end && highest.in_native() > axis.travel_end->in_native() + position_slack)
    ends += fmt::format("{}the overrun at {} above the axis travel to {}", ends.empty() ? "" : " and ",
                        position_text(plan, highest.in_native()), position_text(plan, axis.travel_end->in_native()));
  if (ends.empty()) return std::nullopt;
  return rules::departure("plan-reach-within-travel", "3.2",
                          fmt::format("found {}, expected ends that can be approached from both sides", ends));
}

std::optional<Finding> travel_known(const Plan& plan) {
  if (plan.axis.travel_begin && plan.axis.travel_end) return std::nullopt;
  const auto [lowest, highest] = reach(plan);
  return rules::note("plan-travel-known", "3.1",
                     fmt::format("found no limits of the axis travel; the overruns reach from {} to {}",
                                 position_text(plan, lowest.in_native()), position_text(plan, highest.in_native())));
}

/// ISO 230-6 takes the programme over from ISO 230-2, along the diagonal in place of the axis.
std::optional<Finding> line_of_several_axes(const Plan& plan) {
  if (!is_diagonal(plan.axis)) return std::nullopt;
  const auto& direction = plan.axis.line_direction;
  return rules::note(
      "plan-line-of-several-axes", "230-6",
      fmt::format("found a line that {} axes drive together (direction {} {} {}): a diagonal displacement "
                  "test, whose programme is judged along the line as that of one axis",
                  moving_axes(*spatial_line(plan.axis)), rules::figure(direction[0]), rules::figure(direction[1]),
                  rules::figure(direction[2])));
}

/// Its clauses are about positions and nothing else.
std::optional<Finding> made_for_other_errors(const Plan& plan) {
  if (measures_positions(plan)) return std::nullopt;
  return rules::note(
      "plan-other-errors", "1",
      fmt::format("found a plan made for {}, of which ISO 230-2 says nothing: its rules for targets, runs "
                  "and cycles of positions are not applied",
                  errors_text(plan)));
}

/// What the evaluation of straightness and rotations asks for, so that it is known before the measurement.
std::optional<Finding> evaluable_errors(const Plan& plan) {
  const bool straight = std::ranges::any_of(plan.errors, &MotionName::straightness);
  const bool turns = std::ranges::any_of(plan.errors, &MotionName::rotation);
  const std::size_t least = straight ? 3 : turns ? 2 : 0;
  if (plan.targets.size() < least)
    return rules::departure("plan-few-positions", "1",
                            fmt::format("found {} for {}, expected at least {}: of fewer no line can be told from what "
                                        "departs from it",
                                        counted(plan.targets.size(), "target"), errors_text(plan), least));
  if (least > 0 && !plan.further.empty())
    return rules::note("plan-further-tests-of-errors", "1",
                       fmt::format("found further tests in a plan for {}, expected it alone: straightness and "
                                   "angles are evaluated with a plan of one test",
                                   errors_text(plan)));
  return std::nullopt;
}

/// Which way an axis with rollover goes to an angle is up to its control, and an angle beyond the turn may be refused.
std::optional<Finding> beyond_one_turn(const Plan& plan) {
  const auto [lowest, highest] = reach(plan);
  if (plan.axis.kind != AxisKind::rotary || (lowest.in_native() >= 0.0 && highest.in_native() < 360.0))
    return std::nullopt;
  return rules::note("plan-beyond-one-turn", plan.clause.empty() ? "5.3" : plan.clause,
                     fmt::format("found a way from {} to {}, beyond one turn from 0°: where the control counts to 360° "
                                 "only, its program is to be written with rollover",
                                 position_text(plan, lowest.in_native()), position_text(plan, highest.in_native())));
}

std::optional<Finding> warm_up_planned(const Plan& plan) {
  if (plan.warm_up_runs > 0) return std::nullopt;
  return rules::missing("plan-warm-up-planned", "4.3",
                        "found no warm-up run, expected the warm-up that was specified or agreed before the test");
}

std::optional<Finding> rests_at_targets(const Plan& plan) {
  const double dwell_s = plan.dwell.in_s();
  if (dwell_s >= dwell_least_s) return std::nullopt;
  if (!(dwell_s > 0.0))
    return rules::missing("plan-rests-at-targets", "5.1",
                          "found no dwell at the targets, expected a rest long enough to reach and record each");
  return rules::missing("plan-rests-at-targets", "5.1",
                        fmt::format("found a dwell of {} s at the targets, expected a rest long enough to reach and "
                                    "record each: {} s at least",
                                    format_shortest(dwell_s), format_shortest(dwell_least_s)));
}

/// What the axis loses on reversal would else be lost at the target.
std::optional<Finding> overrun_reverses(const Plan& plan) {
  const double least = plan.axis.kind == AxisKind::linear ? overrun_least_mm : overrun_least_deg;
  if (plan.overrun.in_native() >= least - position_slack) return std::nullopt;
  return rules::missing("plan-overrun-reverses", "3.2",
                        fmt::format("found overruns of {}, expected more than an axis loses on reversal: {} at least",
                                    position_text(plan, plan.overrun.in_native()), position_text(plan, least)));
}

std::optional<Finding> period_below_interval(const Plan& plan) {
  const auto& expected = plan.axis.expected_period;
  if (!expected || plan.targets.size() < 3) return std::nullopt;
  const double period = expected->in_native();
  const double p = travel_of(plan) / static_cast<double>(plan.targets.size() - 1);
  if (!(period > random_part * p)) return std::nullopt;
  return rules::note(
      "plan-period-below-interval", "5.2",
      fmt::format("found a period of {} beside a mean interval of {}, expected one below 30 % of the interval for "
                  "a random part of a whole period; the random part is 30 % of the interval",
                  position_text(plan, period), position_text(plan, p)));
}

/// The largest part of the period that no target falls into is the widest gap between neighbouring phases.
std::optional<Finding> period_sampled(const Plan& plan) {
  const auto& expected = plan.axis.expected_period;
  if (!expected || plan.targets.size() < 3 || !(expected->in_native() > 0.0)) return std::nullopt;
  const double period = expected->in_native();
  if (period >= travel_of(plan)) return std::nullopt;
  std::vector<double> phases;
  for (Position p : plan.targets) phases.push_back(p.in_native() / period - std::floor(p.in_native() / period));
  std::ranges::sort(phases);
  double gap = phases.front() + 1.0 - phases.back();
  for (std::size_t k = 1; k < phases.size(); ++k) gap = std::max(gap, phases[k] - phases[k - 1]);
  if (1.0 - gap >= least_phases) return std::nullopt;
  return rules::note("plan-period-sampled", "5.2",
                     fmt::format("found targets in {} % only of the period of {}, expected them spread over all of "
                                 "it; take another seed or more targets",
                                 rules::figure(std::round(100.0 * (1.0 - gap))), position_text(plan, period)));
}

std::optional<Finding> feed_reached(const Plan& plan) {
  const double needed = distance_to_feed(plan).in_native();
  if (plan.overrun.in_native() >= needed) return std::nullopt;
  return rules::note(
      "plan-feed-reached", "5.3.2",
      fmt::format("found overruns of {}, expected {} to reach the feed of {} {}/min at {} {}/s²",
                  position_text(plan, plan.overrun.in_native()), position_text(plan, needed), rules::figure(plan.feed),
                  position_unit(plan.axis.kind), rules::figure(acceleration_of(plan)), position_unit(plan.axis.kind)));
}

std::optional<Finding> period_given(const Plan& plan) {
  if (plan.axis.expected_period && plan.axis.expected_period->in_native() > 0.0) return std::nullopt;
  return rules::missing("plan-period-given", "Annex C",
                        "found no expected period, expected that of the periodic error in question");
}

std::optional<Finding> period_covered(const Plan& plan) {
  if (period_given(plan)) return std::nullopt;
  const double period = plan.axis.expected_period->in_native();
  if (travel_of(plan) >= periods_at_least * period - position_slack) return std::nullopt;
  return rules::departure("plan-period-covered", "Annex C",
                          fmt::format("found targets over {}, expected at least two periods of {}",
                                      position_text(plan, travel_of(plan)), position_text(plan, period)));
}

std::optional<Finding> period_resolved(const Plan& plan) {
  if (period_given(plan)) return std::nullopt;
  const double period = plan.axis.expected_period->in_native();
  const double p = travel_of(plan) / static_cast<double>(std::max<std::size_t>(plan.targets.size(), 2) - 1);
  if (p <= period / targets_per_period_least + position_slack) return std::nullopt;
  return rules::departure(
      "plan-period-resolved", "Annex C",
      fmt::format("found a mean interval of {}, expected one well below the period of {}: a quarter at most",
                  position_text(plan, p), position_text(plan, period)));
}

/// What is said of every plan.
constexpr PlanRule* common_rules[] = {line_of_several_axes, made_for_other_errors, evaluable_errors,
                                      travel_known,         reach_within_travel,   beyond_one_turn,
                                      warm_up_planned,      rests_at_targets,      overrun_reverses};
/// Of these, what is said once of the test that others belong to, whose axis and warm-up are theirs.
constexpr PlanRule* rules_of_the_first[] = {line_of_several_axes, evaluable_errors, travel_known, beyond_one_turn,
                                            warm_up_planned};
/// Of the test for a periodic error.
constexpr PlanRule* period_rules[] = {period_given, period_covered, period_resolved};
/// Of a test after clause 5.
constexpr PlanRule* target_rules[] = {period_below_interval, period_sampled};
constexpr rules::Rule* programme_rules[] = {
    rules::both_ends_from_both_sides,
    rules::part_of_axis_travel,
    rules::equally_spaced_targets,
    rules::gap_between_targets,
    rules::targets_on_compensation,
    rules::number_of_targets,
    rules::principal_positions,
    rules::directions_of_approach,
    rules::number_of_approaches,
    rules::missing_readings,
    rules::more_than_five_turns,
    rules::cycle_declared_otherwise,
    rules::step_cycle,
};

std::string unvisited_targets(const Plan& plan) {
  constexpr std::size_t named = 10;
  std::vector<bool> visited(plan.targets.size(), false);
  for (const Approach& a : approaches(plan)) visited[a.target] = true;
  std::string list;
  std::size_t count = 0;
  for (std::size_t i = 0; i < visited.size(); ++i) {
    if (visited[i] || ++count > named) continue;
    list += fmt::format("{}{}", list.empty() ? "" : ", ", i + 1);
  }
  return count > named ? list + ", …" : list;
}

/// Why there is no test that the plan could be judged as.
Finding without_series(const Plan& plan) {
  const std::string clause = plan.clause.empty() ? "5.3" : plan.clause;
  if (plan.targets.size() < 2)
    return rules::departure("plan-one-target", clause,
                            "found one target, expected several over the measurement travel");
  if (2 * plan.targets.size() * plan.runs > most_readings)
    return rules::departure("plan-too-many-approaches", clause, "found more approaches than any test has");
  const std::string unvisited = unvisited_targets(plan);
  return rules::departure("plan-target-not-approached", clause,
                          fmt::format("found no approach to target{} {}, expected some to each target",
                                      unvisited.contains(',') ? "s" : "", unvisited));
}

class PlanFindings {
 public:
  void add(std::optional<Finding> finding) {
    if (finding) list_.push_back(*std::move(finding));
  }

  void add_programme(const Plan& plan, bool further) {
    const auto series = series_of(plan);
    if (!series) {
      add(without_series(plan));
      return;
    }
    Metadata metadata;
    metadata.axis = plan.axis;
    metadata.conditions.cycle = plan.cycle;
    const Evaluation evaluation = evaluate(*series);
    const Case c = rules::make_case(metadata, *series, evaluation, std::nullopt);
    for (rules::Rule* rule : programme_rules) {
      if (further && rule == rules::part_of_axis_travel) continue;
      add(rule(c));
    }
    if (!further && !has_additional_test(plan)) add(rules::additional_test(c));
    for (const Finding& unexplained : rules::unexplained(c))
      for (Finding& found : list_)
        if (found.id == unexplained.id) found.severity = unexplained.severity;
  }

  std::vector<Finding> sorted() && {
    std::ranges::stable_sort(list_, {}, &Finding::severity);
    return std::move(list_);
  }

 private:
  std::vector<Finding> list_;
};

/// `whole`: the plan that it is a further one of; of these the whole tells whether the feed is reached where both move
/// alike.
std::vector<Finding> findings_of(const Plan& plan, const Plan* whole = nullptr) {
  const bool further = whole != nullptr;
  PlanFindings findings;
  for (PlanRule* rule : common_rules)
    if (!further || std::ranges::find(rules_of_the_first, rule) == std::end(rules_of_the_first))
      findings.add(rule(plan));
  if (further) findings.add(of_another_axis(*whole, plan));
  if (!further || plan.feed != whole->feed || plan.overrun != whole->overrun) findings.add(feed_reached(plan));
  if (!measures_positions(plan)) return std::move(findings).sorted();
  if (plan.clause == "Annex C") {
    for (PlanRule* rule : period_rules) findings.add(rule(plan));
  } else {
    for (PlanRule* rule : target_rules) findings.add(rule(plan));
    findings.add_programme(plan, further);
  }
  return std::move(findings).sorted();
}

}  // namespace

std::optional<Series> series_of(const Plan& plan) {
  const std::size_t m = plan.targets.size(), n = plan.runs;
  if (2 * m * n > most_readings) return std::nullopt;
  std::vector<double> deviations(2 * m * n, std::numeric_limits<double>::quiet_NaN());
  for (const Approach& a : approaches(plan))
    deviations[(static_cast<std::size_t>(a.direction) * m + a.target) * n + a.run] = 0.0;
  auto series = Series::make_dense(plan.targets, n, std::move(deviations));
  return series ? std::optional(*std::move(series)) : std::nullopt;
}

std::vector<Finding> plan_findings(const Plan& plan) {
  std::vector<Finding> all = findings_of(plan);
  for (const Plan& part : plan.further)
    for (Finding& finding : findings_of(on_the_same_axis(plan, part), &plan)) {
      if (!part.title.empty()) finding.message = fmt::format("{}: {}", part.title, finding.message);
      all.push_back(std::move(finding));
    }
  std::ranges::stable_sort(all, {}, &Finding::severity);
  return all;
}

bool in_accordance(std::span<const Finding> findings) {
  return conforming(findings) && std::ranges::find(findings, Severity::missing, &Finding::severity) == findings.end();
}

bool conforming(std::span<const Finding> findings) {
  return std::ranges::find(findings, Severity::departure, &Finding::severity) == findings.end();
}

}  // namespace axiometry::iso230_2
