// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "axiometry/numeric/random/weighted_choice.h"

/// What a curve may be, given one noisy value of it at each of m places.
///
/// A value y_i = f_i + e_i, e_i normal with the known variance v. The curve f is a trend (constant, or straight
/// line; any height and slope equally likely) plus a smooth part (Gaussian process, Matérn 5/2, standard
/// deviation a, length l) plus a rough part (independent at each place, standard deviation k). How smooth and how
/// rough it is, the values themselves decide: a and k are equally likely in every octave from well below the
/// noise to well above what was seen, or absent; l runs from the spacing to over half the range.
///
/// Why not "each f_i within y_i ± √v": independent doubts make the extremes of m values too far apart, once in
/// the measurement and once more in the draws. Here neighbours tell about each other, and about how much the
/// values scatter at all (Rasmussen & Williams, Gaussian Processes for Machine Learning, 2006, 2.7 and 5.4.1).
///
/// In an orthonormal basis of the trend and, beside it, the principal axes of the smooth covariance, coordinates
/// are independent: those of the trend are y's own ± √v, the others c_k shrunk by s = p/(p + v), with
/// p = a² d_k + k² the prior variance, and uncertain by √(s v).
namespace axiometry::numeric {

struct NoisyCurve {
  std::span<const double> places;  ///< ascending, all different
  std::span<const double> values;  ///< as many
  double noise_variance = 0.0;     ///< v ≥ 0; without noise the curve is what was seen
  std::size_t trend_terms = 2;     ///< 1 constant, 2 straight line; m ≥ 1 places
};

class CurvePosterior {
 public:
  explicit CurvePosterior(const NoisyCurve& data);

  std::size_t size() const { return values_.size(); }  ///< m

  /// One draw: `choice` from (0, 1) picks the smoothness, m standard normal numbers the rest.
  void draw(double choice, std::span<const double> normals, std::span<double> curve) const;

 private:
  /// Orthonormal basis for one length of the smooth part: the first columns span the trend.
  struct Basis {
    std::vector<double> columns;      ///< m × m, one basis vector after the other
    std::vector<double> coordinates;  ///< of the values
    std::vector<double> smooth;       ///< d_k; 0 for the trend
  };
  /// One hypothesis about smoothness.
  struct Hypothesis {
    std::size_t basis = 0;
    double smooth_variance = 0.0;  ///< a²
    double rough_variance = 0.0;   ///< k²
  };

  void consider_hypotheses();
  double log_likelihood(const Hypothesis& hypothesis) const;

  std::vector<double> values_;
  double noise_variance_ = 0.0;
  std::size_t trend_terms_ = 0;
  std::vector<Basis> bases_;
  std::vector<Hypothesis> hypotheses_;
  WeightedChoice choice_;
};

}  // namespace axiometry::numeric
