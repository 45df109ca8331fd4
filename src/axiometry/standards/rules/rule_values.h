// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>

#include "axiometry/standards/rules/rule.h"

/// What several rules take of the readings. Private to this folder.
namespace axiometry::standards {

/// Reasons why there is no figure, as RuleValue has them.
inline constexpr std::string_view needs_both_directions = "needs approaches from both directions";
inline constexpr std::string_view needs_both_everywhere = "needs every target approached from both directions";
inline constexpr std::string_view needs_two_from_both =
    "needs two approaches or more to every target from each direction";
inline constexpr std::string_view needs_this_direction = "needs approaches from this direction";
inline constexpr std::string_view needs_two = "needs two approaches or more to every target";
inline constexpr std::string_view needs_reading_everywhere = "needs a reading at every target";

/// Empty where every target has B_i.
std::string_view lack_of_reversal(const RuleCase& c);
/// Empty where every target has s_i↑ and s_i↓, and so all else.
std::string_view lack_of_scatter(const RuleCase& c);
/// Empty where every target has the mean of this direction.
std::string_view lack_of_means(const RuleCase& c, Direction direction);
/// Empty where every target has the s_i of this direction.
std::string_view lack_of_scatter(const RuleCase& c, Direction direction);

const std::optional<Deviation>& mean_of(const iso230_2::PositionResult& p, Direction direction);
const std::optional<Deviation>& s_of(const iso230_2::PositionResult& p, Direction direction);

/// Largest of what `of` says of each target, in the native unit.
template <typename Of>
double largest(const RuleCase& c, Of of) {
  double most = -std::numeric_limits<double>::infinity();
  for (const auto& p : c.positions()) most = std::max(most, of(p));
  return most;
}

/// max |B_i|, of a test without lack_of_reversal().
double largest_reversal(const RuleCase& c);

/// Range of the bands mean ± k s of both directions, of a test without lack_of_scatter().
double range_of_bands(const RuleCase& c, double k);

/// Range of the means of both directions, of a test without lack_of_reversal().
double range_of_means(const RuleCase& c);

/// As `AxisParameters` has it, by the formulas of ISO 230-2:2014; where readings are missing a lower bound, as there.
template <std::optional<Deviation> iso230_2::AxisParameters::*member, typename Lack>
RuleValue parameter_or(const RuleCase& c, Lack lack) {
  if (const auto& value = c.evaluation.parameters.*member) return *value;
  const std::string_view why = lack(c);
  return std::unexpected(why.empty() ? needs_two_from_both : why);
}

/// How often the least approached target was approached from a direction that was run at all; 0 without readings.
std::size_t fewest_approaches(const RuleCase& c);

/// The departure `id`, "found 3 approaches to a target, expected 5 or more" where there are fewer, with what for.
void expect_approaches(const RuleCase& c, std::string id, std::size_t least, std::string_view what,
                       std::vector<iso230_2::Finding>& findings);

/// The twelve figures of the editions with 2 s, whose formulas are those of ISO 230-2:2014. With older names. Of a
/// program or second-hand: no edition was read.
std::span<const RuleFigure> two_sigma_figures(Evidence evidence);

}  // namespace axiometry::standards
