// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "axiometry/volumetric/curves/curve_basis.h"
#include "axiometry/volumetric/machine/error_motion.h"

/// What no length can tell apart, fixed by construction. A constant of a displacement moves the whole machine; a
/// constant of a rotation turns what is behind the axis, which squareness and the stations take up; of the six slopes
/// of straightness three are squareness and three turn everything. So, over the travel of each axis,
/// - the mean of all 18 functions is 0, and
/// - the best straight line of the 6 straightness functions is level (least squares),
/// while positioning and rotations keep their slopes and the squareness errors stand apart.
namespace axiometry::volumetric {

/// Coefficients of one function that obey the gauge: an orthonormal basis of them. With c the coefficients that obey
/// it, H c has zeros in its first `removed` places; H is a product of Householder reflections.
class Gauge {
 public:
  Gauge(const CurveBasis& basis, ErrorMotion error);

  std::size_t removed() const { return reflections_.size(); }  ///< 1, of straightness 2

  /// H applied in place to as many numbers as the basis has functions, `stride` apart. H is the product of the
  /// reflections in order; transposed() is its inverse.
  void apply(double* numbers, std::size_t stride) const;
  void apply_transposed(double* numbers, std::size_t stride) const;

  /// What must be 0: the mean, of straightness also the slope, each a weight for each coefficient.
  const std::vector<std::vector<double>>& constraints() const { return constraints_; }

 private:
  std::vector<std::vector<double>> constraints_;
  std::vector<std::vector<double>> reflections_;  ///< v of 1 − v vᵀ, |v|² = 2
};

}  // namespace axiometry::volumetric
