// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/formats/text/units.h"
#include "axiometry/standards/iso230_2/verdict/tolerance.h"

/// Limits and decision rules as a user writes them, before the kind of the axis is known.
namespace axiometry::app {

/// "A=10um", "R_up=0.003mm"
struct ToleranceText {
  const iso230_2::ParameterInfo* parameter = nullptr;
  double value = 0.0;
  const formats::Unit* unit = nullptr;

  std::string text() const;  ///< "A=10um"
};

/// Fails on an unknown parameter, a missing or unknown unit, a limit that is no number above 0 or more than a metre.
Result<ToleranceText> parse_tolerance(std::string_view text);

/// Fails when a parameter has two limits in units of the same kind of axis. One in µm and one in ″ are two limits
/// for a folder of linear and rotary axes.
Result<void> check_tolerances(const std::vector<ToleranceText>& texts);

/// The limits for this kind of axis. Fails when a parameter has a limit for the other kind only.
Result<std::vector<iso230_2::Tolerance>> tolerances_for(AxisKind kind, const std::vector<ToleranceText>& texts);

/// "simple", "iso14253-1", "guard-band=3um"
struct RuleText {
  uncertainty::DecisionRule::Kind kind = uncertainty::DecisionRule::Kind::simple;
  double guard_band = 0.0;              ///< width of a guard band that is chosen, in `unit`
  const formats::Unit* unit = nullptr;  ///< unit of the guard band; nullptr for the other rules
};

/// Fails on another word, and on a guard band without a width of 0 or more and its unit.
Result<RuleText> parse_rule(std::string_view text);

/// Fails when the guard band is a length and the axis rotary, or the other way round.
Result<uncertainty::DecisionRule> rule_for(AxisKind kind, const RuleText& text);

/// The rule that a test's metadata state; nothing when they state none. Fails on the rule guard-band without its
/// width, and on a width with another rule.
Result<std::optional<uncertainty::DecisionRule>> stated_rule(const Metadata& metadata);

}  // namespace axiometry::app
