// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "axiometry/uncertainty/budget.h"
#include "axiometry/uncertainty/monte_carlo.h"

/// Whether the law of propagation may be used for an output: JCGM 101:2008, clause 8.
namespace axiometry::uncertainty {

struct Validation {
  double low = 0.0;        ///< d_low = |y − U − y_low|, 8.2 c
  double high = 0.0;       ///< d_high = |y + U − y_high|
  double tolerance = 0.0;  ///< δ of u(y) from the law, 8.2 b
  bool holds() const { return low <= tolerance && high <= tolerance; }
};

/// `trials` is the coverage interval of the Monte Carlo method, for the same coverage probability.
inline Validation validate(const Interval& law, double standard_uncertainty, const Interval& trials, int digits) {
  return {std::abs(law.lower - trials.lower), std::abs(law.upper - trials.upper),
          numerical_tolerance(standard_uncertainty, digits)};
}

}  // namespace axiometry::uncertainty
