// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <iterator>
#include <vector>

#include "axiometry/standards/iso230_2/parameters.h"

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

/// Per row of `parameters`, the derivatives where the extremes lie in this evaluation: the parameters are extremes and
/// hence only piecewise differentiable. For A, at the extremes a and b: A = (x̄_a + 2 s_a) − (x̄_b − 2 s_b). Empty for
/// a parameter that does not exist.
///
/// Targets share an extreme when their values are within tie_bound(); then there is one gradient for every
/// combination of them, in the order of the targets, ↑ before ↓, so that no last bit of the data chooses among them. Of
/// more than 16 that share one the first and the last 8 stand for all: the levers are longest at the ends.
std::array<std::vector<Gradient>, std::size(parameters)> parameter_gradients(const Evaluation& evaluation);

/// What rounding can at most put between two figures of an evaluation that are equal, µm or ″: a mean of n readings is
/// off by n ε of the largest |x|, s by (n/2 + 2) ε and as much of what the mean is off, a boundary or R_i by less than
/// (4n + 16) ε of it, two of them by twice as much; readings that were given as positions bring ε of |P| each. Data
/// differ by 1e-5 µm at least, a million times more.
double tie_bound(const Evaluation& evaluation);

}  // namespace axiometry::iso230_2
