// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/base/quantity.h"
#include "axiometry/standards/readings/thermal_expansion.h"
#include "axiometry/uncertainty/distribution.h"

/// The alignment factor f_a = cos θ of a measurement at an angle θ to the axis, and its uncertainty. Lira & Cargill,
/// Precision Engineering 28 (2004) 232, eqs. 18 to 21. Derivation: docs/theory/uncertainty.md.
///
/// For θ uniform between ± θ_max the mean is sin θ_max/θ_max (21). The variance (20) is the difference of two
/// numbers near 1 and keeps no digit below 0.005°; its power series Σ (−1)^k (k − 1)(2θ)^2k/(2k + 2)!, k ≥ 2, keeps
/// all of them up to 90°.
namespace axiometry {

/// Mean and standard deviation of f_a − 1 in µm/m, for θ uniform between ± θ_max. Relative error below 1e-15 · 8
/// from 1e-9 rad to 90° (tests/golden/uncertainty/alignment.csv, 60 digits). Contract: 0 ≤ θ_max ≤ 90°.
FactorMoments alignment_moments(Angle angle_max);

/// The same for θ in degrees of any distribution: a symmetric uniform one as above, others by the trapezoidal rule
/// on the normal scale, to a relative 1e-4. Contract: it has a standard deviation.
FactorMoments alignment_moments(const uncertainty::Distribution& angle_deg);

}  // namespace axiometry
