// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/standards/iso230_2/assessment/assessment.h"
#include "axiometry/standards/rules/rule.h"

/// The same readings by several rules, each figure beside the parameter of ISO 230-2:2014 that it is taken for.
namespace axiometry::standards {

/// What stands with every comparison: sentences without full stop.
inline constexpr std::string_view no_conformity_stated =
    "Figures for comparison; no conformity with any rule but ISO 230-2:2014 is looked at, and none is stated";
inline constexpr std::string_view no_uncertainty_stated = "No uncertainty is stated for figures of other rules";
inline constexpr std::string_view no_uncertainty_known =
    "No uncertainty is stated for figures of other rules: no input of it is known";
inline constexpr std::string_view no_uncertainty_found =
    "No uncertainty is stated for figures of other rules: each tells why not";

/// In which a figure lies, the measured value always among it; native unit.
struct FigureInterval {
  Deviation low;
  Deviation high;
  Deviation u;          ///< standard uncertainty, of the assumption about the noise that gives the largest
  bool stable = false;  ///< whether more trials would change nothing of what is stated
};

/// The trials behind the intervals (rule_trials.h).
struct RuleTrials {
  iso230_2::Measurand measurand = iso230_2::Measurand::this_test;
  std::uint64_t seed = 0;
  std::size_t trials = 0;
  bool stable = false;
  double coverage = 0.95;
  std::vector<std::string> notes;  ///< what was assumed, sentences without full stop
};

struct ComparedFigure {
  const RuleFigure* figure = nullptr;
  std::optional<Deviation> value;
  std::string_view absence;               ///< why there is no value; empty where there is one
  std::optional<double> share_of_travel;  /// value over measured travel, of figures that are stated so

  const iso230_2::ParameterInfo* counterpart = nullptr;  ///< its like in ISO 230-2:2014; null where there is none
  std::optional<Deviation> counterpart_value;

  std::optional<FigureInterval> interval{};
  std::string no_interval_because{};  ///< why a figure with a value has no interval, after trials

  /// Value less that of the counterpart, where both exist.
  std::optional<Deviation> difference() const;
  /// The same as a part of the counterpart; nothing where that is 0 or less, as a signed mean may be.
  std::optional<double> relative_difference() const;
};

struct ComparedRule {
  const AxisRule* rule = nullptr;
  std::vector<ComparedFigure> figures;  ///< all of the rule's
};

struct RuleComparison {
  iso230_2::Assessment iso230_2;  ///< assessment after ISO 230-2:2014
  std::vector<ComparedRule> rules;
  /// In place of a clause stands the rule: departures from ISO 230-2:2014 with its clauses, remarks of the source,
  /// what the other rules ask of the test as far as that is known; departures first.
  std::vector<iso230_2::Finding> findings;
  /// For who compares specifications: "for this axis P after VDI/DGQ 3441 is …, but A after ISO 230-2:2014 is …",
  /// one for each figure whose formula is another one.
  std::vector<iso230_2::Finding> warnings;
  bool trials_asked_for = false;
  std::optional<RuleTrials> trials{};  ///< absent where none were asked for, and where nothing is known to draw from
};

/// By these rules, all that there are where none is named. Takes a time that grows with the readings. Fails on a
/// diagonal: its figures are none of an axis.
Result<RuleComparison> compare_rules(const Test& test, std::span<const AxisRule* const> rules);

/// What stands with every comparison about the uncertainty: none, or what the intervals are of and are not. A sentence
/// without full stop.
std::string uncertainty_statement(const RuleComparison& comparison);

}  // namespace axiometry::standards
