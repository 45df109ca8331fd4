// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <iterator>
#include <vector>

#include "axiometry/standards/iso230_2.h"

/// How the parameters of clause 3 change with the means and estimators at the targets.
namespace axiometry::iso230_2 {

/// The derivatives of a parameter by x̄_i and by s_i of one direction. Those by B_i, R_i and x̄_i follow.
struct CellTerm {
  std::size_t target = 0;
  Direction direction = Direction::up;
  double by_mean = 0.0;
  double by_s = 0.0;
};

/// Each target and direction at most once, those without influence left out; empty for a parameter that does not
/// exist.
using Gradient = std::vector<CellTerm>;

/// One per row of `parameters`. The parameters are extremes and hence only piecewise differentiable: these are the
/// derivatives where the extremes lie in this evaluation (at the first of equal ones). For A, at the extremes a and b:
/// A = (x̄_a + 2 s_a) − (x̄_b − 2 s_b).
std::array<Gradient, std::size(parameters)> parameter_gradients(const Evaluation& evaluation);

}  // namespace axiometry::iso230_2
