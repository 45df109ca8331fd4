// SPDX-License-Identifier: Apache-2.0
//
// Terms 342 and 346 were read, for B and R; that A is meant with 3 s is told by others. E is of means, without any s.
#include <array>
#include <cmath>

#include "axiometry/standards/rules/rule_values.h"

namespace axiometry::standards {
namespace {

constexpr double three_sigma = 3.0;

RuleValue three_sigma_A(const RuleCase& c) {
  if (const auto lack = lack_of_scatter(c); !lack.empty()) return std::unexpected(lack);
  return Deviation::native(range_of_bands(c, three_sigma));
}

RuleValue three_sigma_E(const RuleCase& c) {
  if (const auto lack = lack_of_reversal(c); !lack.empty()) return std::unexpected(lack);
  return Deviation::native(range_of_means(c));
}

/// R = max R_i, R_i = max(3 s_i↑ + 3 s_i↓ + |B_i|, 6 s_i↑, 6 s_i↓).
RuleValue three_sigma_R(const RuleCase& c) {
  if (const auto lack = lack_of_scatter(c); !lack.empty()) return std::unexpected(lack);
  return Deviation::native(largest(c, [](const iso230_2::PositionResult& p) {
    const double up = p.s_up->in_native(), down = p.s_down->in_native();
    return std::max({three_sigma * (up + down) + std::abs(p.reversal->in_native()), 2.0 * three_sigma * up,
                     2.0 * three_sigma * down});
  }));
}

RuleValue three_sigma_B(const RuleCase& c) {
  if (const auto lack = lack_of_reversal(c); !lack.empty()) return std::unexpected(lack);
  return Deviation::native(largest_reversal(c));
}

constexpr std::string_view wider = "3 s in place of 2 s";

constexpr auto three_sigma_figures = std::to_array<RuleFigure>({
    {"A", "A", "Bidirectional accuracy of positioning", "", Evidence::second_hand, "A", wider, false, three_sigma_A},
    {"E", "E", "Bidirectional systematic deviation of positioning", "", Evidence::second_hand, "E", "", false,
     three_sigma_E},
    {"R", "R", "Bidirectional repeatability of positioning", "342, 346", Evidence::text, "R", wider, false,
     three_sigma_R},
    {"B", "B", "Reversal value", "342, 346", Evidence::text, "B", "", false, three_sigma_B},
});

}  // namespace

extern const AxisRule jis_b_0182_1993_axis_rule;
const AxisRule jis_b_0182_1993_axis_rule = {
    .id = "jis-b-0182-1993",
    .name = "JIS B 0182:1993",
    .remark = "mean ± 3 s, as at the time of ISO 230-2:1988",
    .linear_only = false,
    .figures = three_sigma_figures,
    .findings = nullptr,
};

}  // namespace axiometry::standards
