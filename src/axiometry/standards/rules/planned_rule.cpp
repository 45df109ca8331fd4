// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/rules/planned_rule.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

#include "axiometry/standards/rules/rule_values.h"

namespace axiometry::standards {
namespace {

/// What is said before all that the rule finds. Its cycle may not be known, the plan be too large to be judged.
std::string planned_standing(const AxisRule& rule, bool judged, bool departs) {
  if (!rule.cycle)
    return fmt::format("nothing is known of the cycle that {} asks for: the plan is judged by ISO 230-2:2014 alone",
                       rule.name);
  const std::string_view evidence = evidence_words(rule.cycle->evidence);
  if (departs) return fmt::format("the plan departs from what is known of the cycle of {} ({})", rule.name, evidence);
  if (!judged) return fmt::format("the plan is too large to be judged by the cycle of {} ({})", rule.name, evidence);
  return fmt::format("the plan keeps to what is known of the cycle of {} ({}); no conformity with it is stated",
                     rule.name, evidence);
}

/// What the rule finds of one test of a plan, and whether that departs from its cycle.
struct PlannedTrial {
  std::vector<iso230_2::Finding> findings;
  bool judged = false;
  bool departs = false;
};

class PlannedJudge {
 public:
  PlannedJudge(const AxisRule& rule, const Plan& plan, std::string_view title)
      : rule_(rule), plan_(plan), begin_(title.empty() ? "" : fmt::format("{}: ", title)) {}

  PlannedTrial trial(Axis axis) && {
    if (rule_.cycle && rule_.cycle->order && plan_.cycle != *rule_.cycle->order)
      departure("plan-rule-order", fmt::format("found the order of the {} cycle, expected that of the {} cycle",
                                               cycle_name(plan_.cycle), cycle_name(*rule_.cycle->order)));
    const auto series = iso230_2::series_of(plan_);
    if (!series) return std::move(trial_);
    trial_.judged = true;
    Metadata metadata;
    metadata.axis = std::move(axis);
    metadata.conditions.cycle = plan_.cycle;
    const iso230_2::Evaluation evaluation = iso230_2::evaluate(*series);
    const RuleCase test{metadata, *series, evaluation};
    if (rule_.findings != nullptr)
      for (const iso230_2::Finding& finding : rule_.findings(test)) {
        trial_.departs = trial_.departs || finding.severity == iso230_2::Severity::departure;
        add(finding.id, finding.message);
      }
    if (rule_.cycle) hold_against_cycle(test, *rule_.cycle);
    return std::move(trial_);
  }

 private:
  /// What of a test its figures say, where they are absent.
  void hold_against_cycle(const RuleCase& test, const AskedCycle& cycle) {
    const std::size_t found = fewest_approaches(test);
    if (!cycle.approaches_are_found && found < cycle.approaches)
      departure("plan-rule-approaches",
                fmt::format("found {} approach{} to a target from one direction, expected {} or more for all figures",
                            found, found == 1 ? "" : "es", cycle.approaches));
    if (!test.series.has_both_directions())
      departure("plan-rule-directions", "found approaches from one direction only, expected both for all figures");
  }

  void departure(std::string id, std::string_view message) {
    trial_.departs = true;
    add(std::move(id), message);
  }

  void add(std::string id, std::string_view message) {
    trial_.findings.push_back(
        {std::move(id), "", iso230_2::Severity::note, fmt::format("{}by {}: {}", begin_, rule_.name, message)});
  }

  const AxisRule& rule_;
  const Plan& plan_;
  std::string begin_;
  PlannedTrial trial_;
};

/// A test that belongs to another has its own stretch for its travel.
PlannedTrial further_trial(const AxisRule& rule, const Plan& part) {
  Axis axis = part.axis;
  axis.travel_begin = part.targets.front();
  axis.travel_end = part.targets.back();
  return PlannedJudge(rule, part, part.title).trial(std::move(axis));
}

}  // namespace

Result<iso230_2::PlanRequest> with_cycle_of(const AxisRule& rule, iso230_2::PlanRequest request) {
  if (rule.linear_only && request.axis.kind == AxisKind::rotary)
    return fail(fmt::format("found a rotary axis, expected a linear one: {} says nothing of others", rule.name));
  if (request.periodic || !request.errors.empty())
    return fail(
        fmt::format("found a plan of something else than positions over the travel, expected one of these: {} "
                    "says nothing of others",
                    rule.name));
  request.rule = rule.id;
  if (!rule.cycle) return request;
  request.least_runs = rule.cycle->approaches;
  request.equal_steps = rule.cycle->equal_steps;
  if (rule.cycle->targets > 0) request.area_targets = rule.cycle->targets;
  if (request.cycle == TestCycle::standard) request.cycle = rule.cycle->order.value_or(request.cycle);
  if (request.targets.empty() && !request.count && !request.interval) request.count = request.area_targets;
  return request;
}

std::vector<iso230_2::Finding> planned_rule_findings(const AxisRule& rule, const Plan& plan) {
  PlannedTrial all = PlannedJudge(rule, plan, "").trial(plan.axis);
  for (const Plan& part : plan.further) {
    PlannedTrial trial = further_trial(rule, part);
    all.judged = all.judged && trial.judged;
    all.departs = all.departs || trial.departs;
    std::ranges::move(trial.findings, std::back_inserter(all.findings));
  }
  all.findings.insert(all.findings.begin(), iso230_2::Finding{"plan-rule", "", iso230_2::Severity::note,
                                                              planned_standing(rule, all.judged, all.departs)});
  return std::move(all.findings);
}

}  // namespace axiometry::standards
