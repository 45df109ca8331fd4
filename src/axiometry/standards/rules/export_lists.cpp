// SPDX-License-Identifier: Apache-2.0
//
// What lists of export control ask for. Their limits, and what else they ask, are not here.
#include <array>

#include "axiometry/standards/rules/rule_values.h"

namespace axiometry::standards {
namespace {

std::string_view lack_for_smaller(const RuleCase& c) {
  const std::string_view up = lack_of_scatter(c, Direction::up);
  return up.empty() ? lack_of_scatter(c, Direction::down) : up;
}

RuleValue smaller_of_both(const RuleCase& c) {
  const auto& parameters = c.evaluation.parameters;
  if (!c.series.has_both_directions()) return std::unexpected(needs_both_directions);
  if (const auto lack = lack_for_smaller(c); !lack.empty()) return std::unexpected(lack);
  return std::min(*parameters.R_up, *parameters.R_down);
}

/// Strictly: where a reading is missing, no lower bound stands for it.
RuleValue accuracy_of_2006(const RuleCase& c) {
  if (const auto lack = lack_of_scatter(c); !lack.empty()) return std::unexpected(lack);
  return *c.evaluation.parameters.A;
}

constexpr auto export_figures = std::to_array<RuleFigure>({
    {"2B001", "", "Unidirectional positioning repeatability (2B001)", "", Evidence::second_hand, "R",
     "the smaller of R↑ and R↓, without the reversal", false, smaller_of_both},
    {"2B201", "A", "Positioning accuracy (2B201)", "", Evidence::second_hand, "A", "", false, accuracy_of_2006},
});

}  // namespace

extern const AxisRule export_lists_axis_rule;
const AxisRule export_lists_axis_rule = {
    .id = "export-lists",
    .name = "2B001, 2B201",
    .remark = "what lists of export control ask for, for information only: nothing is said of what they control",
    .linear_only = true,
    .figures = export_figures,
    .findings = nullptr,
};

}  // namespace axiometry::standards
