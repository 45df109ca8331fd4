// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "axiometry/uncertainty/joint_distribution.h"

/// Derivatives of models that can only be called. Private to uncertainty/.
namespace axiometry::uncertainty {

struct Derivative {
  double value = 0.0;
  double error = 0.0;  ///< bound: extrapolation and rounding; not finite when the model has no finite values near x
};

/// ∂y_k/∂x_i of every output at x, with steps from `step` downwards. Contract: step > 0.
std::vector<Derivative> first_derivatives(const ModelFunction& model, std::size_t outputs, std::span<const double> x,
                                          std::size_t input, double step);

/// In coordinates w with x = x0 + T w: what the terms of second order need of one output.
struct Curvature {
  double diagonal = 0.0;  ///< Σ_j f_jj
  double variance = 0.0;  ///< Σ_jk (½ f_jk² + f_j f_jkk)
};

/// Contract: transform holds the rows of T, x.size() × x.size().
std::vector<Curvature> curvatures(const ModelFunction& model, std::size_t outputs, std::span<const double> x,
                                  std::span<const double> transform);

}  // namespace axiometry::uncertainty
