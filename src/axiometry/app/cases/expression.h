// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/uncertainty/joint_distribution.h"

/// Measurement models as text: "Ls + D - Ls*(da*t + as*dt)". Expressions are muParser's: + - * / ^, comparisons, a ? b
/// : c, sqrt, exp, ln, log10, sin, cos, tan, asin, acos, atan, atan2, abs, min, max and others, _pi.
namespace axiometry::app {

/// An output and what it is computed from.
struct Formula {
  std::string output;
  std::string expression;
  TextPosition at;  ///< place where the expression begins, for messages
};

class FormulaModel {
 public:
  /// Fails on an expression that cannot be read or names what is no input, with the place of the word.
  static Result<FormulaModel> make(std::vector<Formula> formulas, std::vector<std::string> inputs);

  uncertainty::ModelFunction function() const;  ///< a function that one thread may call
  uncertainty::BlockModel blocks(uncertainty::JointDistribution distributions, std::uint64_t seed) const;

 private:
  FormulaModel(std::vector<Formula> formulas, std::vector<std::string> inputs)
      : formulas_(std::move(formulas)), inputs_(std::move(inputs)) {}

  std::vector<Formula> formulas_;
  std::vector<std::string> inputs_;
};

/// A letter, then letters, digits and _; no name that expressions have for a function.
bool is_formula_name(std::string_view text);

}  // namespace axiometry::app
