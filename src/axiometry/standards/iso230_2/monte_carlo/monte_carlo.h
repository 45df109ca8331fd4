// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/model/test.h"
#include "axiometry/standards/iso230_2/inputs/inputs.h"
#include "axiometry/standards/iso230_2/monte_carlo/noise.h"
#include "axiometry/standards/iso230_2/parameters.h"
#include "axiometry/uncertainty/monte_carlo.h"

/// The Monte Carlo method (JCGM 101:2008) through the whole evaluation of clause 3: the distribution of every
/// parameter, given the readings and what is known about the inputs.
///
/// Every trial is a complete test that may have happened: readings as perfect instruments would have given them
/// (posterior.h), moved by one draw of each systematic input, evaluated as evaluate() does. A, E, M, R and
/// B are extremes of many readings: noise pushes them apart. What a trial finds is therefore smaller on average
/// than what was measured, and the difference is stated as the bias. The measured value stays the result.
namespace axiometry::iso230_2 {

/// How the sampling of n approaches enters where the question is what the machine does in the long run.
enum class TypeA {
  pooled,     ///< cells tell about each other (posterior.h): intervals hold what they promise
  t_scaled,   ///< each cell for itself, mean by Student's t and variance by χ² (JCGM 101, 6.4.9.2)
  resampled,  ///< whole runs drawn with replacement (bootstrap); the noise of the readings stays in
};

std::string_view type_a_key(TypeA type_a);  ///< "pooled", "t-scaled", "resampled"
std::optional<TypeA> find_type_a(std::string_view key);

struct MonteCarloOptions {
  uncertainty::PropagationOptions propagation;
  std::uint64_t seed = 1;
  TypeA type_a = TypeA::pooled;
  std::size_t contribution_trials = 50'000;  ///< trials for each input alone, at most what was asked for; 0: none
};

/// What an input, alone, contributes to the standard uncertainty of each parameter, the others at their
/// estimates. Squares add up to u² only where the model is linear and the inputs are independent. For this_machine the
/// noise of readings and runs is part of the sampling, and 0 here.
struct Contribution {
  std::string key;  ///< key of the input, or "sampling"
  std::string title;
  std::array<double, std::size(parameters)> u{};  ///< native unit; 0 where the parameter does not exist
};

/// One parameter, in the order of `parameters`; numbers in the native deviation unit.
struct ParameterDistribution {
  double value = 0.0;  ///< measured, clause 3
  /// Of the hypothesis with the largest u: y, u(y), histogram; stable only where all are, to the digits of what is
  /// stated
  uncertainty::OutputSummary summary;
  double bias() const { return value - summary.mean; }      ///< what noise has added to the measured value
  std::vector<uncertainty::OutputSummary> by_hypothesis{};  ///< summaries of the hypotheses not refuted, in their order
  /// The interval that is stated: lowest lower and highest upper end of all hypotheses, and of each moved by
  /// shift_of(). Of a parameter, which is no less than 0 unless it is B̄, neither is its lower end.
  double low = 0.0;
  double high = 0.0;
  std::size_t low_from = 0;  ///< the hypotheses, among those not refuted, that give these ends …
  std::size_t high_from = 0;
  std::size_t summary_from = 0;  ///< … and the summary
  std::string refusal{};         ///< why no interval is stated; empty where one is

  /// By how much the mean of a hypothesis lies below that of the first, "none". Noise of a size between nothing and
  /// what the hypothesis says moves the value by less, with no larger spread: the distribution moved back by all of it
  /// is held possible too.
  double shift_of(std::size_t hypothesis) const { return by_hypothesis.front().mean - by_hypothesis[hypothesis].mean; }
};

/// What a refusal reads like as a sentence of its own.
inline constexpr std::string_view refusal_sentence =
    "No interval is stated, since no normal scatter explains a reading: ";

/// A mean deviation at a target, numbers in the native deviation unit.
struct MeanInterval {
  double value = 0.0;  ///< measured, clause 3
  double mean = 0.0;   ///< mean of the trials of the hypothesis with the largest u
  double u = 0.0;
  double low = 0.0;  ///< the interval that is stated, as of a ParameterDistribution
  double high = 0.0;
};

/// Absent where the mean is, and where nothing that is known acts on it.
struct MeanDistribution {
  Position target;
  std::optional<MeanInterval> up;    ///< x̄_i↑, 3.13
  std::optional<MeanInterval> down;  ///< x̄_i↓
  std::optional<MeanInterval> mean;  ///< x̄_i, 3.14
};

struct MonteCarlo {
  Measurand measurand = Measurand::this_test;
  TypeA type_a = TypeA::pooled;  ///< means something for this_machine only
  std::uint64_t seed = 0;
  std::size_t trials = 0;
  bool adaptive = false;
  bool stable = false;  ///< every numerical tolerance is met (JCGM 101, 7.9)
  double coverage = 0.95;
  /// In the order of `parameters`. Absent where the parameter does not exist, and where nothing that is known acts on
  /// it: ±0 would be a false claim, as in uncertainty/gum.h.
  std::array<std::optional<ParameterDistribution>, std::size(parameters)> distributions;
  std::vector<UncertaintyInput> inputs;
  std::vector<Contribution> contributions;
  std::vector<std::string> notes;
  std::vector<NoiseHypothesis> hypotheses;  ///< all hypotheses about the noise that were considered, those refuted too
  /// Of at most 120 targets, from the first to the last; empty where a refusal stands, and where
  /// MonteCarloOptions::contribution_trials is 0.
  std::vector<MeanDistribution> means{};
  std::size_t mean_trials = 0;  ///< how many trials each hypothesis has
};

/// Nothing when no input was given and the measurand is this test: then nothing is known about its uncertainty.
/// Fails on inputs that make no sense (inputs/inputs.h), on an input without a finite variance that acts as
/// noise, on this_machine with a single approach per direction (its scatter cannot be known), and when stopped.
Result<std::optional<MonteCarlo>> monte_carlo(const Test& test, const Evaluation& evaluation,
                                              const MonteCarloOptions& options);

}  // namespace axiometry::iso230_2
