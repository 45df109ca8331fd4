// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>

#include "axiometry/numeric/harmonic_fit.h"

/// A sinusoid of a known period beside a smooth curve,
///
///     y(x) = Σ_{k ≤ d} a_k P_k(u) + s sin(2π (x − x₀)/P) + c cos(2π (x − x₀)/P),
///
/// by least squares with equal weights, all coefficients at once; P_k Legendre polynomials over the places, u from −1
/// to
/// 1. A line in place of the curve (harmonic_fit.h) would take the shape of a long axis for noise.
///
/// The degree d is that of 1, 2, … with the least AICc = n ln(S/n) + 2 q + 2 q (q + 1)/(n − q − 1), q = d + 4 (C. M.
/// Hurvich, C.-L. Tsai, Biometrika 76 (1989) 297), at most 8, at most the number of half periods over the places less
/// two, so that the curve cannot follow the sinusoid, and with four values more than coefficients.
namespace axiometry::numeric {

/// Units: those of places (x) and values (y).
struct SineBesideCurve {
  double origin = 0.0;  ///< x₀, the first place
  double period = 0.0;
  double sine = 0.0, cosine = 0.0;  ///< s, c
  double amplitude = 0.0;           ///< √(s² + c²); noise alone gives about 1.3 times its u
  double amplitude_u = 0.0;         ///< standard uncertainty, from the residuals
  double chance = 1.0;  ///< that noise alone makes it as large (F test with 2 and ν degrees of freedom): (S/S₀)^(ν/2),
                        ///< S₀ of the curve of that degree alone
  std::size_t degree = 0;
  std::size_t degrees_of_freedom = 0;  ///< ν

  double at(double x) const;  ///< value of the sinusoid alone
};

/// Nothing with fewer than eight places, a travel below two periods, and where the places cannot tell the sinusoid from
/// the curve: one of its half periods from each to the next, say. Contract: as HarmonicData; a period above 0.
std::optional<SineBesideCurve> fit_sine_beside_curve(const HarmonicData& data, double period);

}  // namespace axiometry::numeric
