// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/cases/case_model.h"

#include <fmt/format.h>

#include <algorithm>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"

namespace axiometry::app {
namespace {

using uncertainty::Correlation;
using uncertainty::Distribution;

Result<void> expect_end(const Statement& s, std::size_t index) {
  if (index < s.words.size()) return unexpected_word(s, index, "the end of the line");
  return {};
}

/// The one number of a statement.
Result<double> only_number(const Statement& s) {
  AXIOMETRY_TRY(const double x, read_number(s, 1));
  AXIOMETRY_TRY_VOID(expect_end(s, 2));
  return x;
}

Result<std::size_t> read_count(const Statement& s, std::size_t index) {
  if (index < s.words.size())
    if (const auto n = parse_count(s.words[index].text)) return static_cast<std::size_t>(*n);
  return unexpected_word(s, index, "a whole number");
}

/// The text from the word of this index to the end of the one before `end`.
std::string_view span_text(const Statement& s, std::size_t first, std::size_t end) {
  const std::string_view begin = s.words[first].text, last = s.words[end - 1].text;
  return {begin.data(), static_cast<std::size_t>(last.data() + last.size() - begin.data())};
}

Result<Correlation> correlation_of(const ModelStatements& said) {
  const std::size_t n = said.inputs.size();
  std::vector<double> matrix(n * n, 0.0);
  for (std::size_t i = 0; i < n; ++i) matrix[i * n + i] = 1.0;
  for (const auto& pair : said.correlations)
    matrix[pair.first * n + pair.second] = matrix[pair.second * n + pair.first] = pair.coefficient;
  return Correlation::make(n, std::move(matrix));
}

Result<uncertainty::LawResult> carry_out_law(const ModelStatements& said) {
  AXIOMETRY_TRY(const Correlation correlation, correlation_of(said));
  std::vector<uncertainty::InputQuantity> inputs;
  for (const auto& input : said.inputs) {
    inputs.push_back(uncertainty::InputQuantity::of(input.name, input.distribution));
    if (input.degrees_of_freedom) inputs.back().degrees_of_freedom = *input.degrees_of_freedom;
  }
  return uncertainty::law_of_propagation(said.model->function(), said.formulas.size(), inputs, correlation,
                                         {.coverage = said.options.coverage, .second_order = true});
}

Result<uncertainty::MonteCarloResult> carry_out_trials(const ModelStatements& said) {
  AXIOMETRY_TRY(const Correlation correlation, correlation_of(said));
  std::vector<Distribution> marginals;
  for (const auto& input : said.inputs) marginals.push_back(input.distribution);
  const uncertainty::JointDistribution joint(std::move(marginals), correlation);
  return uncertainty::propagate(said.model->blocks(joint, said.seed), said.formulas.size(), said.options);
}

}  // namespace

std::optional<std::size_t> ModelStatements::input(std::string_view name) const {
  const auto found = std::ranges::find(inputs, name, &Input::name);
  if (found == inputs.end()) return std::nullopt;
  return static_cast<std::size_t>(found - inputs.begin());
}

std::optional<std::size_t> ModelStatements::output(std::string_view name) const {
  const auto found = std::ranges::find(formulas, name, &Formula::output);
  if (found == formulas.end()) return std::nullopt;
  return static_cast<std::size_t>(found - formulas.begin());
}

const Result<uncertainty::LawResult>& ModelOutcome::law(const ModelStatements& said) {
  if (!law_) law_ = carry_out_law(said);
  return *law_;
}

const Result<uncertainty::MonteCarloResult>& ModelOutcome::monte_carlo(const ModelStatements& said) {
  if (!monte_carlo_) monte_carlo_ = carry_out_trials(said);
  return *monte_carlo_;
}

Result<void> ModelCase::read(const Statement& s) {
  const Word& verb = s.words.front();
  if (expected_) return unexpected_word(s, 0, "'expect', or a new 'operation' before other data");
  if (verb.is("input")) return input(s);
  if (verb.is("correlation")) return correlation(s);
  if (verb.is("model")) return model(s);
  if (verb.is("trials")) return trials(s);
  if (verb.is("coverage")) {
    AXIOMETRY_TRY(said_.options.coverage, only_number(s));
    if (said_.options.coverage > 0.0 && said_.options.coverage < 1.0) return {};
    return unexpected_word(s, 1, "a probability between 0 and 1");
  }
  if (verb.is("seed") || verb.is("digits")) {
    AXIOMETRY_TRY(const std::size_t n, read_count(s, 1));
    if (verb.is("seed")) said_.seed = n;
    if (verb.is("digits") && (n < 1 || n > 4)) return unexpected_word(s, 1, "1 to 4 significant digits");
    if (verb.is("digits")) said_.options.digits = static_cast<int>(n);
    return expect_end(s, 2);
  }
  const auto near = text::nearest(verb.text, {"title", "operation", "expect", "input", "correlation", "model", "trials",
                                              "seed", "coverage", "digits"});
  return unexpected_word(s, 0,
                         near ? fmt::format("perhaps '{}'", *near) : "a word that docs/conformance-cases.md lists");
}

/// input X1 normal 0 1 [degrees 12]
Result<void> ModelCase::input(const Statement& s) {
  if (said_.model) return unexpected_word(s, 0, "inputs before the model");
  if (s.words.size() < 2 || !is_formula_name(s.words[1].text))
    return unexpected_word(s, 1, "a name of letters, digits and _ that is no function");
  if (said_.input(s.words[1].text)) return unexpected_word(s, 1, "another name for another input");
  if (s.words.size() < 3) return unexpected_word(s, 2, "a distribution such as 'normal 0 1'");
  std::size_t end = s.words.size();
  std::optional<double> degrees;
  if (const auto word = std::ranges::find_if(s.words, [](const Word& w) { return w.is("degrees"); });
      word != s.words.end()) {
    end = static_cast<std::size_t>(word - s.words.begin());
    if (end < 3) return unexpected_word(s, 2, "a distribution such as 'normal 0 1'");
    AXIOMETRY_TRY(degrees, read_number(s, end + 1));
    if (!(*degrees > 0.0)) return unexpected_word(s, end + 1, "more than 0 degrees of freedom");
    AXIOMETRY_TRY_VOID(expect_end(s, end + 2));
  }
  auto distribution = Distribution::parse(span_text(s, 2, end));
  if (!distribution) return fail(distribution.error().message, s.words[2].at);
  said_.inputs.push_back({std::string(s.words[1].text), std::move(*distribution), degrees});
  return {};
}

/// correlation X1 X2 0.9
Result<void> ModelCase::correlation(const Statement& s) {
  ModelStatements::Pair pair;
  for (const std::size_t word : {std::size_t{1}, std::size_t{2}}) {
    const auto index = word < s.words.size() ? said_.input(s.words[word].text) : std::nullopt;
    if (!index) return unexpected_word(s, word, "the name of an input");
    (word == 1 ? pair.first : pair.second) = *index;
  }
  if (pair.first == pair.second) return unexpected_word(s, 2, "another input");
  AXIOMETRY_TRY(pair.coefficient, read_number(s, 3));
  AXIOMETRY_TRY_VOID(expect_end(s, 4));
  said_.correlations.push_back(pair);
  return {};
}

/// model Y = X1 + X2
Result<void> ModelCase::model(const Statement& s) {
  if (said_.inputs.empty()) return unexpected_word(s, 0, "'input' before the model");
  if (s.words.size() < 2 || !is_formula_name(s.words[1].text))
    return unexpected_word(s, 1, "a name of letters, digits and _ that is no function");
  if (said_.output(s.words[1].text) || said_.input(s.words[1].text))
    return unexpected_word(s, 1, "another name for another quantity");
  if (s.words.size() < 4 || !s.words[2].is("=")) return unexpected_word(s, 2, "'model NAME = FORMULA'");
  const std::string_view formula = span_text(s, 3, s.words.size());
  said_.formulas.push_back({std::string(s.words[1].text), std::string(formula), s.words[3].at});
  std::vector<std::string> names;
  for (const auto& input : said_.inputs) names.push_back(input.name);
  AXIOMETRY_TRY(said_.model, FormulaModel::make(said_.formulas, std::move(names)));
  return {};
}

/// trials 200000, trials adaptive
Result<void> ModelCase::trials(const Statement& s) {
  if (s.words.size() > 1 && s.words[1].is("adaptive")) {
    said_.options.trials.reset();
  } else {
    AXIOMETRY_TRY(said_.options.trials, read_count(s, 1));
    if (*said_.options.trials < 100) return unexpected_word(s, 1, "adaptive, or at least 100");
  }
  return expect_end(s, 2);
}

Result<CaseComparison> ModelCase::expect(const Statement& s) {
  if (!said_.model) return unexpected_word(s, 0, "'input' and 'model' before 'expect'");
  expected_ = true;
  return check_model_expectation(s, said_, outcome_);
}

}  // namespace axiometry::app
