// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/uncertainty/budget.h"
#include "axiometry/uncertainty/correlation.h"
#include "axiometry/uncertainty/joint_distribution.h"

/// The law of propagation of uncertainty (GUM, clause 5) for models with any number of outputs.
namespace axiometry::uncertainty {

/// Writes ∂y_k/∂x_i at x, outputs one after another: jacobian[k · inputs + i].
using JacobianFunction = std::function<void(std::span<const double> inputs, std::span<double> jacobian)>;

struct LawOptions {
  double coverage = 0.95;
  bool second_order = false;
  JacobianFunction jacobian = {};  ///< exact derivatives; without it they are computed
};

struct LawResult {
  std::vector<Budget> outputs;
  std::vector<double> covariance;  ///< u(y_k, y_l), rows one after another (eq. H.9)

  /// r(y_k, y_l); 0 where one of them has no uncertainty.
  double correlation(std::size_t k, std::size_t l) const;
};

/// Derivatives are central differences with steps of u(x_i)/2^j, extrapolated to step 0 (Richardson), of which the one
/// with the least sum of extrapolation error and rounding error is taken; the sum is stated as sensitivity_error. It
/// supposes that the model computes y to its last digits; what it cancels inside itself nobody outside can know.
/// Second order: the same differences at u and u/2, extrapolated once.
/// Fails on a standard uncertainty that is negative or not finite, degrees of freedom that are not positive, a coverage
/// outside 0 to 1, and where the model has no finite value at the estimates or near them.
/// Contract: one row of the correlation per input.
Result<LawResult> law_of_propagation(const ModelFunction& model, std::size_t outputs,
                                     std::span<const InputQuantity> inputs, const Correlation& correlation,
                                     const LawOptions& options = {});

}  // namespace axiometry::uncertainty
