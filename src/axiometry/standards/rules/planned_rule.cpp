// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/rules/planned_rule.h"

#include <fmt/format.h>

#include <string>

namespace axiometry::standards {
namespace {

/// What is said before all that the rule finds. Its cycle may not be known, the plan be too large to be judged.
std::string planned_standing(const AxisRule& rule, bool judged, bool departs) {
  if (!rule.cycle)
    return fmt::format("nothing is known of the cycle that {} asks for: the plan is judged by ISO 230-2:2014 alone",
                       rule.name);
  const std::string_view evidence = evidence_words(rule.cycle->evidence);
  if (!judged) return fmt::format("the plan is too large to be judged by the cycle of {} ({})", rule.name, evidence);
  if (departs) return fmt::format("the plan departs from what is known of the cycle of {} ({})", rule.name, evidence);
  return fmt::format("the plan keeps to what is known of the cycle of {} ({}); no conformity with it is stated",
                     rule.name, evidence);
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
  if (request.cycle == TestCycle::standard) request.cycle = rule.cycle->order.value_or(request.cycle);
  if (!request.targets.empty()) return request;
  request.equal_steps = rule.cycle->equal_steps;
  if (rule.cycle->targets > 0 && !request.count && !request.interval) request.count = rule.cycle->targets;
  return request;
}

std::vector<iso230_2::Finding> planned_rule_findings(const AxisRule& rule, const Plan& plan) {
  std::vector<iso230_2::Finding> all;
  bool departs = rule.cycle && rule.cycle->order && plan.cycle != *rule.cycle->order;
  bool tells_approaches = false;
  const auto series = iso230_2::series_of(plan);
  if (series && rule.findings != nullptr) {
    Metadata metadata;
    metadata.axis = plan.axis;
    metadata.conditions.cycle = plan.cycle;
    const iso230_2::Evaluation evaluation = iso230_2::evaluate(*series);
    for (const iso230_2::Finding& finding : rule.findings({metadata, *series, evaluation})) {
      const bool broken = finding.severity == iso230_2::Severity::departure;
      departs = departs || broken;
      tells_approaches = tells_approaches || (broken && finding.id.find("approaches") != std::string::npos);
      all.push_back(
          {finding.id, "", iso230_2::Severity::note, fmt::format("by {}: {}", rule.name, finding.message)});
    }
  }
  // Of a test its figures say this, where they are absent.
  if (series && rule.cycle && !tells_approaches && plan.runs < rule.cycle->approaches) {
    departs = true;
    all.push_back(
        {"plan-rule-approaches", "", iso230_2::Severity::note,
         fmt::format("by {}: found {} approach{} to a target from one direction, expected {} or more for all figures",
                     rule.name, plan.runs, plan.runs == 1 ? "" : "es", rule.cycle->approaches)});
  }
  if (series && rule.cycle && !(series->has(Direction::up) && series->has(Direction::down))) {
    departs = true;
    all.push_back({"plan-rule-directions", "", iso230_2::Severity::note,
                   fmt::format("by {}: found approaches from one direction only, expected both for all figures",
                               rule.name)});
  }
  all.insert(all.begin(), iso230_2::Finding{"plan-rule", "", iso230_2::Severity::note,
                                            planned_standing(rule, series.has_value(), departs)});
  return all;
}

}  // namespace axiometry::standards
