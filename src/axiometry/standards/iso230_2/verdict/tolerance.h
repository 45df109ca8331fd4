// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/standards/iso230_2/assessment/assessment.h"
#include "axiometry/standards/iso230_2/comparison_slack.h"
#include "axiometry/standards/iso230_2/verdict/lower_bounds.h"
#include "axiometry/standards/iso230_2/verdict/uncertainty_of_record.h"
#include "axiometry/uncertainty/conformity.h"

/// Whether the parameters of an axis keep their limits: ISO 14253-1, JCGM 106:2012. The decision itself knows no
/// axis and stands in uncertainty/conformity.h; here stand its three inputs: limit, magnitude, uncertainty.
namespace axiometry::iso230_2 {

/// Who set a limit, in rising precedence. Limits merge parameter by parameter (merged_limits()).
enum class ToleranceSource {
  axis,     ///< what the archive says of the axis
  table,    ///< a file of tolerance tables, by name and travel
  test,     ///< the test's own file
  entered,  ///< stated of the test by a person, over what its file says
  user,     ///< asked of every test that is evaluated: the command line
};

std::string_view tolerance_source_key(ToleranceSource source);  ///< "axis", "table", "test", "entered", "user"

/// A limit that another one has taken the place of.
struct ReplacedLimit {
  Deviation limit;
  ToleranceSource source = ToleranceSource::user;
};

/// A limit for one parameter, in its deviation unit; an upper limit of the magnitude, since B̄ is signed.
struct Tolerance {
  const ParameterInfo* parameter = nullptr;
  Deviation limit;
  ToleranceSource source = ToleranceSource::user;
  std::string origin{};  ///< which table, for people; which day an axis in the archive has it since; else empty
  std::vector<ReplacedLimit> replaced{};  ///< limits of the same parameter that it replaced, in rising precedence
};

/// The limits of both, parameter by parameter: one of `over` takes the place of the one below, which it remembers.
std::vector<Tolerance> merged_limits(std::vector<Tolerance> below, std::span<const Tolerance> over);

/// The limits that a test's metadata state, in the order of `parameters`.
std::vector<Tolerance> stated_tolerances(const Metadata& metadata);

/// One limit and what came of it. Says by itself how it was decided, wherever it is shown.
struct Judgement {
  Tolerance tolerance;
  uncertainty::DecisionRule rule;
  std::optional<Deviation> magnitude;            ///< |value|; absent when the parameter does not exist (6.2)
  std::optional<StatedUncertainty> uncertainty;  ///< absent when none was estimated
  uncertainty::Decision decision;
  /// Why nothing is decided although there is a value: an effect that it holds, or terms that it
  /// lacks, under every rule; or, where the rule asks for an uncertainty, that the method of record states none or one
  /// that is doubted. Empty mostly; else the verdict is `undecided`, without probability and zones.
  std::string withheld{};
  Remedy remedy{};  ///< what mends that, where it is an effect

  /// T − g: up to here accepted. Absent when nothing could be: no u, g > T, or withheld.
  std::optional<Deviation> acceptance_limit() const;
  /// T + g: beyond this rejected. Absent likewise.
  std::optional<Deviation> rejection_limit() const;
  /// Whether there are two limits to decide by: under simple acceptance, else when an uncertainty is known.
  bool has_guard_band() const;
};

/// What a decision asks beside values, limits and rule.
struct JudgedWith {
  ParameterUncertainties uncertainties{};            ///< uncertainties of record
  ComparisonSlack slack{};                           ///< how far rounding may have moved a value off its limit
  std::span<const UncorrectedEffect> uncorrected{};  ///< what the values hold and nobody knows the doubt of
  UncertaintyRefusals refusals{};                    ///< why there is no uncertainty of record
  LowerBounds lower_bounds{};                        ///< what lacks terms, and why
};

/// A decision on each limit. A parameter that does not exist has no verdict (not_applicable). The limit of B̄ is one of
/// its magnitude: p_c counts both signs, P(−T ≤ B̄ ≤ T). Withheld where an uncorrected effect is not negligible: where
/// its size is not known, is more than a hundredth of the limit, or could turn the verdict. A lower bound never
/// conforms; that it exceeds its limit stays so.
std::vector<Judgement> judge(const AxisParameters& measured, std::span<const Tolerance> tolerances,
                             const uncertainty::DecisionRule& rule, const JudgedWith& with);

/// The verdict on all limits together: the worst of them. A demand that could not be judged counts as undecided beside
/// others, so that nothing conforms as a whole of which a part was not looked at. Nothing without a limit;
/// not_applicable when none of them could be judged.
std::optional<uncertainty::Verdict> overall_verdict(std::span<const Judgement> judgements);

}  // namespace axiometry::iso230_2
