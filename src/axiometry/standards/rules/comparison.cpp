// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/rules/comparison.h"

#include <fmt/format.h>

#include <algorithm>

#include "axiometry/base/contract.h"
#include "axiometry/standards/iso230_2/rules/claims.h"
#include "axiometry/standards/iso230_2/rules/message.h"
#include "axiometry/standards/iso230_2/rules/rules.h"

namespace axiometry::standards {
namespace {

using iso230_2::Finding;
using iso230_2::Severity;

constexpr std::string_view of_linear_axes = "is of linear axes alone";

ComparedFigure compared_figure(const AxisRule& rule, const RuleFigure& figure, const RuleCase& c) {
  ComparedFigure result{.figure = &figure};
  const bool excluded = rule.linear_only && c.metadata.axis.kind != AxisKind::linear;
  if (const RuleValue value = excluded ? RuleValue(std::unexpected(of_linear_axes)) : figure.value(c))
    result.value = *value;
  else
    result.absence = value.error();
  if (figure.share_of_travel && result.value)
    result.share_of_travel =
        result.value->in_native() / (c.series.travel_native() * deviation_per_position(c.metadata.axis.kind));
  if (figure.counterpart.empty()) return result;
  result.counterpart = iso230_2::find_parameter(figure.counterpart);
  AXIOMETRY_CONTRACT(result.counterpart != nullptr);
  result.counterpart_value = c.evaluation.parameters.*result.counterpart->member;
  return result;
}

/// "P", or "Lost motion" of a figure without a symbol.
std::string name_of(const RuleFigure& figure) {
  return std::string(figure.symbol.empty() ? figure.title : figure.symbol);
}

std::optional<Finding> warning(const AxisRule& rule, const ComparedFigure& compared, AxisKind kind) {
  const RuleFigure& figure = *compared.figure;
  if (figure.departs_by.empty() || !compared.value || !compared.counterpart_value) return std::nullopt;
  const double own = compared.value->in_native(), other = compared.counterpart_value->in_native();
  const auto shown = [&](double x) { return iso230_2::rules::deviation_message(kind, x); };
  const bool look_equal = iso230_2::rules::size_text(own) == iso230_2::rules::size_text(other);
  const std::string own_name = fmt::format("{} after {}", name_of(figure), rule.name);
  const std::string other_name = fmt::format("{} after {}", compared.counterpart->symbol, iso230_2::edition);
  using iso230_2::rules::message;
  const iso230_2::rules::Message said =
      look_equal ? message("for this axis {} and {} are both {}, and yet not the same figure ({})", own_name,
                           other_name, shown(own), evidence_words(figure.evidence))
                 : message("for this axis {} is {}, but {} is {}: they are not the same figure ({})", own_name,
                           shown(own), other_name, shown(other), evidence_words(figure.evidence));
  return iso230_2::rules::note("not-the-same-figure", std::string(rule.name), said);
}

/// What speaks against the readings, and so against figures of every rule.
bool is_of_readings(const Finding& finding) {
  constexpr std::string_view ids[] = {"outlying-reading",
                                      "uneven-scatter",
                                      "shifted-runs",
                                      "tilted-runs",
                                      "ordered-progression",
                                      "readings-copied",
                                      "readings-repeat-exactly",
                                      "readings-coarsely-rounded"};
  return std::ranges::find(ids, finding.id) != std::end(ids);
}

std::vector<Finding> findings_of_edition(const Test& test, const iso230_2::Assessment& assessment) {
  std::vector<Finding> all = iso230_2::errors_known_of(test, assessment);
  std::erase_if(all, [](const Finding& finding) { return finding.clause == iso230_2::source_clause; });
  for (Finding& finding : all) finding.clause = fmt::format("{}, {}", iso230_2::edition, finding.clause);
  for (const Finding& finding : assessment.findings) {
    if (finding.clause == iso230_2::source_clause) all.push_back(finding);
    if (finding.clause == iso230_2::source_clause ||
        (finding.severity != Severity::departure && !is_of_readings(finding)))
      continue;
    all.push_back(finding);
    all.back().clause = fmt::format("{}, {}", iso230_2::edition, finding.clause);
  }
  return all;
}

}  // namespace

std::optional<Deviation> ComparedFigure::difference() const {
  if (!value || !counterpart_value) return std::nullopt;
  return Deviation::native(value->in_native() - counterpart_value->in_native());
}

std::optional<double> ComparedFigure::relative_difference() const {
  if (!difference() || !(counterpart_value->in_native() > 0.0)) return std::nullopt;
  return difference()->in_native() / counterpart_value->in_native();
}

Result<RuleComparison> compare_rules(const Test& test, std::span<const AxisRule* const> rules) {
  if (is_diagonal(test.metadata.axis))
    return fail("found a diagonal, expected a test of one axis: other rules know no diagonals");
  RuleComparison result{.iso230_2 = iso230_2::assess(test)};
  result.findings = findings_of_edition(test, result.iso230_2);
  const RuleCase c{test.metadata, test.series, result.iso230_2.evaluation};
  for (const AxisRule* rule : rules.empty() ? axis_rule_table() : rules) {
    ComparedRule& compared = result.rules.emplace_back(ComparedRule{rule, {}});
    for (const RuleFigure& figure : rule->figures) {
      compared.figures.push_back(compared_figure(*rule, figure, c));
      if (auto found = warning(*rule, compared.figures.back(), test.metadata.axis.kind))
        result.warnings.push_back(*std::move(found));
    }
    if (rule->findings == nullptr) continue;
    for (Finding& finding : rule->findings(c)) {
      finding.clause = rule->name;
      result.findings.push_back(std::move(finding));
    }
  }
  std::ranges::stable_sort(result.findings, {}, &Finding::severity);
  return result;
}

}  // namespace axiometry::standards
