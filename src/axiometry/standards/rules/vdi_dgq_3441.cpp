// SPDX-License-Identifier: Apache-2.0
//
// Formulas as several descriptions agree on; the names of the figures stand in the interface of an instrument.
//   s̄_i = (s_i↑ + s_i↓)/2, P_s,i = 6 s̄_i, U_i = |B_i|,
//   P_a = range of x̿_i, P = max[x̿_i + (U_i + P_s,i)/2] − min[x̿_i − (U_i + P_s,i)/2].
#include <array>
#include <cmath>

#include "axiometry/standards/rules/rule_values.h"

namespace axiometry::standards {
namespace {

using iso230_2::PositionResult;

/// P_s,i
double vdi_scatter(const PositionResult& p) { return 3.0 * (p.s_up->in_native() + p.s_down->in_native()); }
/// U_i
double vdi_reversal(const PositionResult& p) { return std::abs(p.reversal->in_native()); }

template <double (*of)(const PositionResult&)>
double mean_over_targets(const RuleCase& c) {
  double sum = 0.0;
  for (const auto& p : c.positions()) sum += of(p);
  return sum / static_cast<double>(c.positions().size());
}

RuleValue vdi_P(const RuleCase& c) {
  if (const auto lack = lack_of_scatter(c); !lack.empty()) return std::unexpected(lack);
  const auto half_width = [](const PositionResult& p) { return (vdi_reversal(p) + vdi_scatter(p)) / 2.0; };
  const double upper = largest(c, [&](const auto& p) { return p.mean->in_native() + half_width(p); });
  const double lower = -largest(c, [&](const auto& p) { return half_width(p) - p.mean->in_native(); });
  return Deviation::native(upper - lower);
}

RuleValue vdi_P_a(const RuleCase& c) {
  if (const auto lack = lack_of_reversal(c); !lack.empty()) return std::unexpected(lack);
  const double upper = largest(c, [](const auto& p) { return p.mean->in_native(); });
  const double lower = -largest(c, [](const auto& p) { return -p.mean->in_native(); });
  return Deviation::native(upper - lower);
}

RuleValue vdi_P_s_max(const RuleCase& c) {
  if (const auto lack = lack_of_scatter(c); !lack.empty()) return std::unexpected(lack);
  return Deviation::native(largest(c, vdi_scatter));
}

RuleValue vdi_P_s_mean(const RuleCase& c) {
  if (const auto lack = lack_of_scatter(c); !lack.empty()) return std::unexpected(lack);
  return Deviation::native(mean_over_targets<vdi_scatter>(c));
}

RuleValue vdi_U_max(const RuleCase& c) {
  if (const auto lack = lack_of_reversal(c); !lack.empty()) return std::unexpected(lack);
  return Deviation::native(largest_reversal(c));
}

RuleValue vdi_U_mean(const RuleCase& c) {
  if (const auto lack = lack_of_reversal(c); !lack.empty()) return std::unexpected(lack);
  return Deviation::native(mean_over_targets<vdi_reversal>(c));
}

constexpr Evidence others = Evidence::second_hand;

constexpr auto vdi_figures = std::to_array<RuleFigure>({
    {"P", "P", "Positioning uncertainty", "", others, "A",
     "3 s of both directions together in place of 2 s of each, about the mean of both", false, vdi_P},
    {"P_a", "P_a", "Positional deviation", "", others, "M", "", false, vdi_P_a},
    {"P_s_max", "P_s,max", "Positional scatter, largest", "", others, "R",
     "6 times the mean of both s, without the reversal", false, vdi_P_s_max},
    {"P_s_mean", "P_s,mean", "Positional scatter, mean over the targets", "", others, "R",
     "6 times the mean of both s, without the reversal, and a mean in place of the largest", false, vdi_P_s_mean},
    {"U_max", "U_max", "Reversal error, largest", "", others, "B", "", false, vdi_U_max},
    {"U_mean", "U_mean", "Reversal error, mean over the targets", "", others, "B_mean", "without the signs", false,
     vdi_U_mean},
});

constexpr std::size_t vdi_approaches = 5;

std::vector<iso230_2::Finding> vdi_findings(const RuleCase& c) {
  std::vector<iso230_2::Finding> all;
  expect_approaches(c, "vdi-dgq-3441-number-of-approaches", vdi_approaches, "all figures", all);
  return all;
}

}  // namespace

extern const AxisRule vdi_dgq_3441_axis_rule;
const AxisRule vdi_dgq_3441_axis_rule = {
    .id = "vdi-dgq-3441",
    .name = "VDI/DGQ 3441",
    .remark =
        "P and P_s hold 6 s in all, where A and R of ISO 230-2:2014 hold 4 s; U is the reversal error, no uncertainty, "
        "and U_mean leaves out the signs that B̄ has",
    .linear_only = false,
    .figures = vdi_figures,
    .findings = vdi_findings,
    .cycle = AskedCycle{.evidence = others, .approaches = vdi_approaches, .approaches_are_found = true},
};

}  // namespace axiometry::standards
