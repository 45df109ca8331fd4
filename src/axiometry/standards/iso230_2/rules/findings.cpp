// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "axiometry/base/contract.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/rounded_text.h"
#include "axiometry/standards/iso230_2/rules/message.h"
#include "axiometry/standards/iso230_2/rules/rules.h"
#include "axiometry/standards/readings/runs_made.h"

namespace axiometry::iso230_2 {
namespace rules {
namespace {

struct Row {
  Rule* rule;
  bool departs = false;  ///< whether it can find a departure; the others cost a table of many tests nothing
};
constexpr bool may_depart = true;

// In the order of the clauses.
constexpr Row every_rule[] = {
    {both_ends_from_both_sides, may_depart},
    {targets_within_axis_travel, may_depart},
    {part_of_axis_travel},
    {readings_beyond_errors, may_depart},
    {same_reversal_everywhere},
    {readings_repeat_exactly},
    {readings_copied},
    {readings_coarsely_rounded},
    {straight_slope},
    {temperature_without_correction, may_depart},
    {temperature_change},
    {air_pressure_unlikely},
    {ordered_progression},
    {equally_spaced_targets},
    {gap_between_targets},
    {targets_on_compensation, may_depart},
    {number_of_targets, may_depart},
    {principal_positions},
    {directions_of_approach, may_depart},
    {number_of_approaches, may_depart},
    {missing_readings, may_depart},
    {runs_left_out},
    {runs_in_blocks},
    {more_than_five_turns},
    {cycle_declared_otherwise, may_depart},
    {additional_test},
    {parameters_not_applicable},
    {items_of_identification},
    {impossible_date},
    {date_not_read},
    {equipment_identified},
    {sensors_complete},
    {equipment_calibrated},
    {calibration_date_not_read},
    {line_in_space},
    {uncertainty_stated},
    {uncertainty_of_zero},
    {station_stated},
    {repeatability_below_variation},
    {step_cycle, may_depart},
    {diagonal_line},
};

}  // namespace

Case make_case(const Metadata& metadata, const Series& series, const Evaluation& evaluation,
               const std::optional<AnnexA>& uncertainty) {
  return {metadata,
          series,
          evaluation,
          uncertainty,
          programme_of(metadata.axis.kind, Position::native(series.travel_native())),
          {runs_made(series, Direction::up), runs_made(series, Direction::down)}};
}

std::string figure(double x) { return format_shortest(std::round(x * 1000.0) / 1000.0); }

std::string size_text(double x) { return format_significant(x, 3); }

Message deviation_message(AxisKind kind, double x) {
  Message said(fmt::format("{} {}", size_text(x), deviation_unit(kind)));
  said.deviations.push_back({0, said.text.size(), Deviation::native(x)});
  return said;
}

Message deviation_message(const Case& c, double x) { return deviation_message(c.kind(), x); }

Finding finding(std::string id, std::string clause, Severity severity, Message message) {
  return {std::move(id), std::move(clause), severity, std::move(message.text), std::move(message.deviations)};
}

std::string position_text(AxisKind kind, double position) {
  return figure(position) + (kind == AxisKind::linear ? " mm" : "°");
}

std::string position_text(const Case& c, double position) { return position_text(c.kind(), position); }

std::string target_text(const Case& c, std::size_t target) {
  return fmt::format("target {} ({})", target + 1, position_text(c, c.target(target)));
}

}  // namespace rules

std::optional<Finding> find_progression(const Metadata& metadata, const Series& series, const Evaluation& evaluation,
                                        const std::optional<AnnexA>& uncertainty) {
  const rules::Case c = rules::make_case(metadata, series, evaluation, uncertainty);
  for (Finding& finding : rules::scatter_findings(c))
    if (finding.clause == rules::progression_clause) return std::move(finding);
  return rules::ordered_progression(c);
}

std::vector<Finding> find_departures(const Metadata& metadata, const Series& series, const Evaluation& evaluation,
                                     const std::optional<AnnexA>& uncertainty, Depth depth) {
  const rules::Case c = rules::make_case(metadata, series, evaluation, uncertainty);
  std::vector<Finding> findings;
  findings.reserve(std::size(rules::every_rule));
  bool drift_told = false;
  for (const auto& [rule, departs] : rules::every_rule) {
    if (!departs && depth == Depth::departures_only) continue;
    if (rule == rules::straight_slope)
      for (Finding& finding : rules::scatter_findings(c)) {  // this rule may find several
        drift_told = drift_told || finding.clause == rules::progression_clause;
        findings.push_back(std::move(finding));
      }
    if (rule == rules::ordered_progression && drift_told) continue;  // the drift was told already, with its size
    auto finding = rule(c);
    if (!finding) continue;
    AXIOMETRY_CONTRACT(departs || finding->severity != Severity::departure);
    findings.push_back(std::move(*finding));
  }
  if (depth == Depth::departures_only)
    std::erase_if(findings, [](const Finding& finding) { return finding.severity != Severity::departure; });
  std::ranges::stable_sort(findings, {}, &Finding::severity);
  return findings;
}

}  // namespace axiometry::iso230_2
