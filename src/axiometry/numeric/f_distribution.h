// SPDX-License-Identifier: Apache-2.0
#pragma once

/// The F distribution, of the ratio of two independent estimates of one variance.
namespace axiometry::numeric {

/// Degrees of freedom of both estimates.
struct RatioDegrees {
  double above = 1.0;
  double below = 1.0;
};

/// P(F > f), by the regularised incomplete beta function I_x(below/2, above/2), x = below/(below + above·f), with its
/// continued fraction (NIST DLMF 8.17.22). To a relative 1e-10 for degrees of freedom up to 1e6 and tails above 1e-200;
/// f_distribution_test.cpp holds figures. Contract: both degrees of freedom > 0; f ≥ 0, may be infinite.
double f_tail(double f, RatioDegrees degrees);

}  // namespace axiometry::numeric
