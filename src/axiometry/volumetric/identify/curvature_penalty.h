// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "axiometry/volumetric/curves/coefficients.h"
#include "axiometry/volumetric/identify/equations/normal_equations.h"

/// How far curves bend, as a sum of squares beside χ². Internal to identify().
///
/// With x from 0 to 1 over the range of an axis, the slope of each curve is taken for a random walk whose end departs
/// from its beginning by a normal deviate of standard deviation τ (the smoothing spline: Wahba 1978). Of cubic
/// B-splines and of straight lines between nodes, n spans to the range, the second derivative at a knot is n² Δ²c, and
/// the mean of white noise over a span has n times its density: D = n^{3/2} Δ²c are independent, each N(0, τ²) (the
/// differences of Eilers and Marx 1996). So the negative logarithm of what is known beforehand is half of
///   cᵀ S c = Σ D² φ/τ²,
/// in units of χ² before its residuals' variance factor φ. Straight lines cost nothing, so the gauge does not matter.
namespace axiometry::volumetric::detail {

inline constexpr std::size_t curve_count = axis_count * motion_count;
using PerCurve = std::array<double, curve_count>;  ///< numbers in the order of error_names()

/// τ of displacements, µm, and of rotations, µrad.
using Bends = std::array<double, 2>;
/// Of one of the 18 curves: 0 for a displacement, 1 for a rotation.
std::size_t bend_of(std::size_t curve);

class CurvaturePenalty {
 public:
  /// Contract: no polynomials. Errors that are left out cost nothing however they bend; with those that lengths do not
  /// tell left out, S is 0 along every null direction.
  CurvaturePenalty(const Coefficients& coefficients, std::span<const std::size_t> left_out);

  void set(const Bends& bends, double variance_factor);
  const Bends& bends() const { return bends_; }
  double variance_factor() const { return factor_; }

  double value(std::span<const double> raw) const;               ///< cᵀ S c
  std::vector<double> times(std::span<const double> raw) const;  ///< S c, as many as `raw` has
  NormalEquations added_to(NormalEquations equations) const;     ///< N + S

  PerCurve ranks() const;                               ///< how many D each curve has; 0: left out
  PerCurve squares(std::span<const double> raw) const;  ///< Σ D²

  /// Of a covariance V of raw coefficients before φ: F = 1 − (φ/τ²) ∂D V ∂Dᵀ of each curve. What D̂ scatters over all
  /// truths that the assumption allows is τ² F. Its trace is how many D lengths tell, and that of its square.
  struct Told {
    PerCurve trace{}, trace_of_square{};
  };
  Told told(const std::vector<double>& covariance) const;

 private:
  struct Difference {
    std::size_t first = 0;  ///< place of a raw coefficient; the others follow motion_count apart
    std::size_t curve = 0;
    double factor = 0.0;  ///< n^{3/2}
  };
  double weight(const Difference& d) const { return factor_ / (bends_[bend_of(d.curve)] * bends_[bend_of(d.curve)]); }
  void add(const CurveBasis& basis, std::size_t begin, std::size_t axis, const std::vector<bool>& is_left_out);

  std::vector<Difference> differences_;
  Bends bends_{1.0, 1.0};
  double factor_ = 1.0;
};

}  // namespace axiometry::volumetric::detail
