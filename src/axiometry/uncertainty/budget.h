// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/uncertainty/distribution.h"
#include "axiometry/uncertainty/sampled_distribution.h"

/// Uncertainty budgets: what each input quantity contributes to an output (GUM, clause 5 and annex G).
namespace axiometry::uncertainty {

/// An input as the law of propagation sees it.
struct InputQuantity {
  std::string name;
  double estimate = 0.0;                                                ///< x_i
  double standard_uncertainty = 0.0;                                    ///< u(x_i)
  double degrees_of_freedom = std::numeric_limits<double>::infinity();  ///< ν_i

  /// Mean and standard deviation, without limit of degrees of freedom. Of a t distribution location, scale and ν
  /// instead: the standard uncertainty of a mean of readings is s/√n (GUM 4.2.3), not the larger standard
  /// deviation of the t distribution that stands for it in JCGM 101.
  static InputQuantity of(std::string name, const Distribution& distribution);
};

struct InputContribution {
  double sensitivity = 0.0;        ///< c_i = ∂f/∂x_i
  double sensitivity_error = 0.0;  ///< bound of its numerical error; 0 where the caller gave the derivative
  double contribution = 0.0;       ///< c_i u(x_i), with the sign of c_i
};

/// With the terms of second order for normally distributed inputs (GUM 5.1.2, note): Σ (½ f_jk² + f_j f_jkk) u_j² u_k²
/// in the variance, ½ Σ f_jj u_j² in the estimate. Correlated inputs are first transformed into independent ones.
struct SecondOrder {
  double estimate = 0.0;
  double standard_uncertainty = 0.0;
  Interval interval;  ///< interval with the same coverage factor
};

/// The uncertainty of one output.
struct Budget {
  double estimate = 0.0;                         ///< y = f(x)
  double standard_uncertainty = 0.0;             ///< u_c(y), eq. 10 or 13
  std::vector<InputContribution> contributions;  ///< contributions in the order of the inputs
  /// ν_eff, G.2b; infinite where no degrees of freedom limit it. Absent where an input of limited degrees of freedom
  /// that counts is correlated with another that counts: the formula holds for independent inputs only.
  std::optional<double> degrees_of_freedom;
  double coverage_factor =
      0.0;  ///< k from t for ν_eff cut to a whole number (G.6.4); from the normal where ν_eff is absent
  double expanded_uncertainty = 0.0;  ///< U = k u_c
  Interval interval;                  ///< y ± U
  std::optional<SecondOrder> second_order;
};

}  // namespace axiometry::uncertainty
