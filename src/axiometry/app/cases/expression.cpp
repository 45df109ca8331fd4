// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/cases/expression.h"

#include <fmt/format.h>
#include <muParser.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <utility>

#include "axiometry/base/text/text.h"

namespace axiometry::app {
namespace {

/// Parsers that read their variables from one array. A parser may be used by one thread at a time, so each thread has
/// its own.
class Evaluator {
 public:
  Evaluator(const std::vector<Formula>& formulas, const std::vector<std::string>& inputs) : values_(inputs.size()) {
    for (const Formula& formula : formulas) {
      mu::Parser& parser = parsers_.emplace_back();
      for (std::size_t i = 0; i < inputs.size(); ++i) parser.DefineVar(inputs[i], &values_[i]);
      parser.SetExpr(formula.expression);
    }
  }
  Evaluator(const Evaluator&) = delete;  // the parsers hold addresses
  Evaluator& operator=(const Evaluator&) = delete;

  std::vector<double>& inputs() { return values_; }
  std::size_t outputs() const { return parsers_.size(); }
  double output(std::size_t k) const { return parsers_[k].Eval(); }

  /// The same where an expression cannot be computed for these inputs.
  double output_or_nan(std::size_t k) const {
    try {
      return output(k);
    } catch (const mu::ParserError&) {
      return std::numeric_limits<double>::quiet_NaN();
    }
  }

 private:
  std::vector<double> values_;
  std::vector<mu::Parser> parsers_;
};

std::string lower_first(std::string text) {
  if (!text.empty() && text.back() == '.') text.pop_back();
  if (text.size() > 1 && text[0] >= 'A' && text[0] <= 'Z' && !(text[1] >= 'A' && text[1] <= 'Z'))
    text[0] = static_cast<char>(text[0] - 'A' + 'a');
  return text;
}

}  // namespace

Result<FormulaModel> FormulaModel::make(std::vector<Formula> formulas, std::vector<std::string> inputs) {
  for (const Formula& formula : formulas) {
    try {
      Evaluator evaluator({formula}, inputs);
      static_cast<void>(evaluator.output(0));  // reads the expression
    } catch (const mu::ParserError& error) {
      if (error.GetCode() == mu::ecDOMAIN_ERROR || error.GetCode() == mu::ecDIV_BY_ZERO) continue;  // of these inputs
      TextPosition at = formula.at;
      if (error.GetPos() > 0) at.column += static_cast<std::size_t>(error.GetPos());
      return fail(fmt::format("found {}: {}, expected a formula of the inputs", text::quoted(formula.expression),
                              lower_first(error.GetMsg())),
                  at);
    }
  }
  return FormulaModel(std::move(formulas), std::move(inputs));
}

uncertainty::ModelFunction FormulaModel::function() const {
  return [evaluator = std::make_shared<Evaluator>(formulas_, inputs_)](std::span<const double> x, std::span<double> y) {
    std::ranges::copy(x, evaluator->inputs().begin());
    for (std::size_t k = 0; k < y.size(); ++k) y[k] = evaluator->output_or_nan(k);
  };
}

uncertainty::BlockModel FormulaModel::blocks(uncertainty::JointDistribution distributions, std::uint64_t seed) const {
  return [model = *this, distributions = std::move(distributions), seed](std::uint64_t block,
                                                                         uncertainty::BlockOutputs outputs) {
    // Reading the expressions anew costs microseconds, a block milliseconds.
    Evaluator evaluator(model.formulas_, model.inputs_);
    const std::size_t n = outputs.trials;
    std::vector<double> values(distributions.size() * n);
    const uncertainty::BlockOutputs draws{values, n};
    distributions.sample({seed, 0, block}, draws);
    for (std::size_t t = 0; t < n; ++t) {
      for (std::size_t i = 0; i < distributions.size(); ++i) evaluator.inputs()[i] = values[i * n + t];
      for (std::size_t k = 0; k < evaluator.outputs(); ++k) outputs.values[k * n + t] = evaluator.output_or_nan(k);
    }
  };
}

bool is_formula_name(std::string_view text) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const auto digit = [](char c) { return c >= '0' && c <= '9'; };
  if (text.empty() || !letter(text[0])) return false;
  if (!std::ranges::all_of(text, [&](char c) { return letter(c) || digit(c) || c == '_'; })) return false;
  return !mu::Parser().GetFunDef().contains(std::string(text));
}

}  // namespace axiometry::app
