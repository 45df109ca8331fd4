// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <expected>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/test.h"
#include "axiometry/standards/iso230_2/finding.h"
#include "axiometry/standards/iso230_2/parameters.h"

/// Other rules than ISO 230-2:2014 for the same readings, one descriptor per file of this folder: what each calls its
/// figures, how they follow from the readings, what it asks of the test, and on what our knowledge of it rests. The
/// figures stand beside those of ISO 230-2:2014 so that a specification is not compared with the wrong one
/// (comparison.h). Conformity with any of them is never stated. Their uncertainty comes from the trials that carry the
/// parameters of ISO 230-2:2014 too (rule_trials.h).
///
/// Symbols: x̄_i↑, x̄_i↓ means of a target, x̿_i their mean, s_i↑, s_i↓ with divisor n − 1, B_i = x̄_i↑ − x̄_i↓;
/// values in the native deviation unit, µm or ″.
namespace axiometry::standards {

/// Where a formula was found.
enum class Evidence {
  text,         ///< read in the text of the rule
  makers_text,  ///< read in a maker's manual that says how it applies the rule
  program,      ///< read in the code of another program
  second_hand,  ///< read in descriptions by others that agree
};

std::string_view evidence_key(Evidence evidence);  ///< "text", "makers-text", "program", "second-hand"

/// Where there is no room for more, "second-hand": evidence_note then stands below.
std::string_view evidence_source(Evidence evidence);
inline constexpr std::string_view evidence_note =
    "evidence: where the formula was read; what was not read in the text of the rule was not checked against it";

/// What stands wherever a figure does: "second-hand, not checked against the text of the rule".
std::string_view evidence_words(Evidence evidence);

/// A test as other rules see it. Refers to what it is made of.
struct RuleCase {
  const Metadata& metadata;
  const Series& series;
  const iso230_2::Evaluation& evaluation;  ///< means, s_i and B_i of every target

  std::span<const iso230_2::PositionResult> positions() const { return evaluation.positions; }
};

/// A figure, or why the test has none: "needs approaches from both directions".
using RuleValue = std::expected<Deviation, std::string_view>;

struct RuleFigure {
  std::string_view key;     ///< name in JSON, unique within a rule: "P_s_max"
  std::string_view symbol;  ///< as report::symbol() reads it; empty where the rule has none that is known
  std::string_view title;   ///< "Positioning uncertainty"
  std::string_view clause;  ///< clause of the rule, or numbers of its terms; empty where it is not known
  Evidence evidence;
  std::string_view counterpart;  ///< key of the parameter of ISO 230-2:2014 that it is taken for; empty for none
  /// In what the formula differs from that parameter's; empty where both always have one value.
  std::string_view departs_by;
  bool share_of_travel = false;  ///< the rule states the value divided by the measured travel T
  RuleValue (*value)(const RuleCase&);
  /// Whether it is made of single readings; else of means and s of the targets alone (rule_trials.h).
  bool of_single_readings = false;
  /// Whether it is no difference of deviations, so that what all readings have in common is in it.
  bool counts_from_zero = false;
};

/// What a rule asks of the cycle of a test, as far as that is known; where it says nothing a test is planned after
/// ISO 230-2:2014 (planned_rule.h).
struct AskedCycle {
  Evidence evidence;
  std::size_t approaches = 0;        ///< least number of approaches to each target from each direction
  std::size_t targets = 0;           ///< number of targets over the measurement travel; 0 where it says nothing
  bool equal_steps = false;          ///< whether targets lie evenly from one end of the measurement travel to the other
  std::optional<TestCycle> order{};  ///< order of the approaches; absent where it says nothing
  bool approaches_are_found = false;  ///< whether AxisRule::findings tells of fewer approaches
};

struct AxisRule {
  std::string_view id;      ///< word of --standard: "vdi-dgq-3441"
  std::string_view name;    ///< "VDI/DGQ 3441"
  std::string_view remark;  ///< what its figures are and are not, a sentence without full stop
  bool linear_only;         ///< no figure of a rotary axis
  std::span<const RuleFigure> figures;
  /// How the test departs from what the rule asks of it, as far as that is known, and what must be known of figures;
  /// clauses are left empty. Null where nothing is known.
  std::vector<iso230_2::Finding> (*findings)(const RuleCase&);
  std::optional<AskedCycle> cycle{};  ///< absent where nothing is known
};

/// All of them, by the names of their sources.
std::span<const AxisRule* const> axis_rule_table();

/// By id; nullptr when there is none.
const AxisRule* find_axis_rule(std::string_view id);

/// Likewise. Fails with the ids that there are.
Result<const AxisRule*> rule_named(std::string_view id);

}  // namespace axiometry::standards
