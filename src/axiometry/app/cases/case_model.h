// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "axiometry/app/cases/case_text.h"
#include "axiometry/app/cases/check.h"
#include "axiometry/app/cases/expression.h"
#include "axiometry/uncertainty/monte_carlo.h"
#include "axiometry/uncertainty/propagate.h"

/// `operation model` of conformance cases (check.h): a measurement model with its inputs, and what the law of
/// propagation and the Monte Carlo method must give. Private to app/.
namespace axiometry::app {

/// What a case says of a model before its first expectation.
struct ModelStatements {
  struct Input {
    std::string name;
    uncertainty::Distribution distribution;
    std::optional<double> degrees_of_freedom;  ///< ν for the law of propagation
  };
  struct Pair {
    std::size_t first = 0;
    std::size_t second = 0;
    double coefficient = 0.0;
  };
  std::vector<Input> inputs;
  std::vector<Pair> correlations;
  std::vector<Formula> formulas;
  std::optional<FormulaModel> model;
  uncertainty::PropagationOptions options{.trials = 1'000'000};
  std::uint64_t seed = 1;

  /// Place of an input or output of this name.
  std::optional<std::size_t> input(std::string_view name) const;
  std::optional<std::size_t> output(std::string_view name) const;
};

/// The two methods, each carried out when it is first asked for.
class ModelOutcome {
 public:
  const Result<uncertainty::LawResult>& law(const ModelStatements& said);
  const Result<uncertainty::MonteCarloResult>& monte_carlo(const ModelStatements& said);

 private:
  std::optional<Result<uncertainty::LawResult>> law_;
  std::optional<Result<uncertainty::MonteCarloResult>> monte_carlo_;
};

class ModelCase {
 public:
  /// Any statement but title, operation and expect. Fails, with its place, on what it does not understand.
  Result<void> read(const Statement& statement);
  Result<CaseComparison> expect(const Statement& statement);

 private:
  Result<void> input(const Statement& statement);
  Result<void> correlation(const Statement& statement);
  Result<void> model(const Statement& statement);
  Result<void> trials(const Statement& statement);

  ModelStatements said_;
  ModelOutcome outcome_;
  bool expected_ = false;  ///< an expectation was read, what follows is too late
};

/// What an `expect` line says about a model.
Result<CaseComparison> check_model_expectation(const Statement& statement, const ModelStatements& said,
                                               ModelOutcome& outcome);

}  // namespace axiometry::app
