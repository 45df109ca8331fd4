// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/standards/iso230_2/assessment/assessment.h"
#include "axiometry/uncertainty/belief.h"

/// The uncertainty of record: of all that was estimated the one that stands beside a value, is drawn, kept, listed and
/// decides. Everything that shows or uses an uncertainty of a parameter asks here, so that no page has two; other
/// methods stand in comparisons only.
namespace axiometry::iso230_2 {

/// The method that an uncertainty comes from (model/metadata.h).
using axiometry::UncertaintyMethod;

std::string_view method_key(UncertaintyMethod method);    ///< "annex_a", as in the JSON results
std::string_view method_word(UncertaintyMethod method);   ///< "annex-a", as `uncertainty.method` has it
std::string_view method_title(UncertaintyMethod method);  ///< "Annex A"

/// The uncertainty of one parameter as it is stated.
struct StatedUncertainty {
  UncertaintyMethod method = UncertaintyMethod::annex_a;
  std::optional<Measurand> measurand;  ///< measurand whose uncertainty it is; absent for Annex A, which does not ask
  Deviation u;                         ///< standard uncertainty: U/2 of Annex A
  std::optional<Deviation> U;          ///< expanded; absent of the Monte Carlo method, which states the interval
  /// Value ± U, or of the Monte Carlo method the interval with its coverage probability, widened to hold the measured
  /// value where it does not.
  uncertainty::Interval interval;
  std::optional<double> degrees_of_freedom{};  ///< ν of the GUM, where finite: Student's t, else normal
};

/// The same with what a decision asks: the belief in the parameter with its sign.
struct ParameterUncertainty {
  StatedUncertainty stated;
  uncertainty::Belief belief;  ///< refers to the assessment, which must outlive it and stay where it is
  std::string doubt{};         ///< why no verdict may rest on it, though it is stated; empty where one may
};

/// One per parameter, in the order of `parameters`; absent where the method states none.
using ParameterUncertainties = std::array<std::optional<ParameterUncertainty>, std::size(parameters)>;

/// The method of record: the chosen one, also where it has found nothing. Where none was chosen, the Monte Carlo
/// method if it was asked for, since it alone sees that the parameters are extremes; else Annex A, the standard's own;
/// else the GUM. Absent where nothing was estimated.
std::optional<UncertaintyMethod> method_of_record(const Assessment& assessment);

/// The Monte Carlo run where it states an interval of anything; nullptr where there is none, or outliers refused it.
const MonteCarlo* run_with_intervals(const Assessment& assessment);

/// The distributions of a parameter that a Monte Carlo run holds possible, each with trials: of every hypothesis, and
/// that moved by ParameterDistribution::shift_of(). They live as long as the run.
std::vector<uncertainty::Possible> held_possible(const MonteCarlo& run, const ParameterInfo& parameter);

/// By that one method; never filled up from another. One of 0 is none: what acts was stated as 0 or not at all.
ParameterUncertainties uncertainties_of_record(const Assessment& assessment);

/// Why the method of record states nothing of a parameter that has a value; empty where it does, or none was chosen.
using UncertaintyRefusals = std::array<std::string, std::size(parameters)>;
UncertaintyRefusals refusals_of_record(const Assessment& assessment);

/// What is stated of one parameter.
std::optional<StatedUncertainty> uncertainty_of_record(const Assessment& assessment, const ParameterInfo& parameter);

std::size_t index_of(const ParameterInfo& parameter);  ///< contract: a row of `parameters`, or a copy of one

}  // namespace axiometry::iso230_2
