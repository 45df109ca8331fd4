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
/// continued fraction (NIST DLMF 8.17.22). To a relative 1e-10 for degrees of freedom up to 1e5, 1e-9 up to 1e6, and
/// tails above 1e-200; f_distribution_test.cpp holds figures. Contract: both degrees of freedom > 0; f ≥ 0, may be
/// infinite.
double f_tail(double f, RatioDegrees degrees);

/// Whether f_tail() is surely above `level`, which costs a small part of it; false says nothing. A beta variate grows
/// smaller as its second parameter grows, so that the tail is at least that of ⌊above/2⌋ in place of above/2:
/// x^(below/2) Σ_j (below/2)_j (1 − x)^j / j!, j < ⌊above/2⌋ (DLMF 8.17.21), of which a few terms may do.
/// Contract: as f_tail().
bool f_tail_is_above(double level, double f, RatioDegrees degrees);

}  // namespace axiometry::numeric
