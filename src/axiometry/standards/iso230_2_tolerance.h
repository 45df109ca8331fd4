// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/standards/iso230_2_assessment.h"
#include "axiometry/uncertainty/conformity.h"

/// Whether the parameters of an axis keep their limits: ISO 14253-1, JCGM 106:2012. The decision itself knows no
/// axis and stands in uncertainty/conformity.h; here stand its three inputs: limit, magnitude, uncertainty.
namespace axiometry::iso230_2 {

/// Who set a limit, in rising precedence.
enum class ToleranceSource {
  axis,     ///< what the archive says of the axis, where nobody else sets a limit
  table,    ///< a file of tolerance tables, by name and travel
  test,     ///< the test's own file
  entered,  ///< stated of the test by a person, over what its file says
  user,     ///< asked of every test that is evaluated: the command line
};

std::string_view tolerance_source_key(ToleranceSource source);  ///< "axis", "table", "test", "entered", "user"

/// A limit for one parameter, in its deviation unit; an upper limit of the magnitude, since B̄ is signed.
struct Tolerance {
  const ParameterInfo* parameter = nullptr;
  Deviation limit;
  ToleranceSource source = ToleranceSource::user;
  std::string origin{};  ///< of a table: which one, for people; else empty
};

/// The limits that a test's metadata state, in the order of `parameters`.
std::vector<Tolerance> stated_tolerances(const Metadata& metadata);

/// The method that an uncertainty comes from.
enum class UncertaintyMethod { annex_a, gum, monte_carlo };

std::string_view method_key(UncertaintyMethod method);    ///< "annex_a", as in the JSON results
std::string_view method_title(UncertaintyMethod method);  ///< "Annex A"

/// The standard uncertainty of a parameter and where it comes from.
struct StandardUncertainty {
  Deviation u;
  UncertaintyMethod method = UncertaintyMethod::annex_a;
  std::optional<Measurand> measurand{};  ///< whose uncertainty it is; absent for Annex A, which does not ask
};

/// What is known about a parameter's value, as far as a decision needs it.
struct ParameterUncertainty {
  StandardUncertainty standard;
  /// Of the parameter with its sign; part of the assessment, which must outlive this. nullptr: normal about the value.
  const uncertainty::SampledDistribution* distribution = nullptr;
};

/// One per parameter, in the order of `parameters`; absent where none was estimated.
using ParameterUncertainties = std::array<std::optional<ParameterUncertainty>, std::size(parameters)>;

/// The uncertainties that decide: for each parameter the most complete of what was estimated, Monte Carlo before GUM
/// before Annex A (u = U/2). The one place that chooses.
ParameterUncertainties deciding_uncertainties(const Assessment& assessment);

/// One limit and what came of it. Says by itself how it was decided, wherever it is shown.
struct Judgement {
  Tolerance tolerance;
  uncertainty::DecisionRule rule;
  std::optional<Deviation> magnitude;              ///< |value|; absent when the parameter does not exist (6.2)
  std::optional<StandardUncertainty> uncertainty;  ///< absent when none was estimated
  uncertainty::Decision decision;

  /// T − g: up to here accepted. Absent when nothing could be: no u, or g > T.
  std::optional<Deviation> acceptance_limit() const;
  /// T + g: beyond this rejected. Absent likewise without u.
  std::optional<Deviation> rejection_limit() const;
  /// Whether there are two limits to decide by: always under simple acceptance, else when an uncertainty is known.
  bool has_guard_band() const;
};

/// A decision on each limit. A parameter that does not exist has no verdict (not_applicable). What is compared with
/// the limits is the measured value, also where a Monte Carlo run knows its bias: that moves p_c alone.
/// The probability of conformity of B̄ counts both signs: P(−T ≤ B̄ ≤ T).
std::vector<Judgement> judge(const AxisParameters& measured, std::span<const Tolerance> tolerances,
                             const uncertainty::DecisionRule& rule, const ParameterUncertainties& uncertainties);

/// The verdict on all limits together: the worst of them, where an undecided one is worse than a conforming one.
/// Nothing without a limit; not_applicable when none of them could be judged.
std::optional<uncertainty::Verdict> overall_verdict(std::span<const Judgement> judgements);

}  // namespace axiometry::iso230_2
