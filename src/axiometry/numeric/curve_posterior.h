// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "axiometry/numeric/random/weighted_choice.h"
#include "axiometry/numeric/rows.h"

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
/// One distribution, computed in two ways.
///
/// CurveForm::axes, for few places. In an orthonormal basis of the trend and, beside it, the principal axes of the
/// smooth covariance, coordinates are independent: those of the trend are y's own ± √v, the others c_k shrunk by s =
/// p/(p + v), with p = a² d_k + k² the prior variance, and uncertain by √(s v). The axes take a time of m³, a draw of
/// m².
///
/// CurveForm::states, for many: times of m (matern_filter.h). With r = k² + v, λ = a²/r and M what is beside the trend
/// weighed by (λK + 1)⁻¹, the likelihood of a hypothesis is that of yᵀM y/r and of the determinant of r(λK + 1) beside
/// the trend. Of λ both are smooth: Σ ln(1 + λd_k) and Σ c_k²/(1 + λd_k) are analytic for |Im ln λ| < π, so that
/// Chebyshev's points in ln λ tell them for all hypotheses, within 1e-10 m. Given y the noise has the mean
/// (v/r) M y, the covariance v − v² M/r, and a draw of it is, by what the same model makes of a curve that it made
/// itself (Chilès & Delfiner, Geostatistics, 7.3.1),
///
///   e = (v/r)(n + M(y − a g − n)) + √(v k²/r) z,    f = y − e,
///
/// g a curve of the process, n noise of the variance r, z standard normal: all linear in normal numbers, the mean that
/// of e, the covariance (v/r)²(r − 2rM + M(rλK + r)M) + vk²/r = v − v²M/r, as M(λK + 1)M = M. Coordinates of the trend
/// are y's own ± √v here, too, since M has no part in them.
namespace axiometry::numeric {

enum class CurveForm { axes, states };

struct NoisyCurve {
  std::span<const double> places;      ///< ascending, all different
  std::span<const double> values;      ///< a value for each place
  double noise_variance = 0.0;         ///< v ≥ 0; without noise the curve is what was seen
  std::size_t trend_terms = 2;         ///< 1 constant, 2 straight line; m ≥ 1 places
  std::optional<CurveForm> form = {};  ///< the quicker one unless said; states need more places than terms
};

struct CurveFrame;  // what depends on the places alone

class CurvePosterior {
 public:
  /// What depends on the places alone is shared with `alike`, if that has the same ones.
  explicit CurvePosterior(const NoisyCurve& data, const CurvePosterior* alike = nullptr);

  std::size_t size() const { return values_.size(); }  ///< m

  /// Numbers that a draw of many curves is made from.
  struct Numbers {
    std::span<const double> choices;  ///< numbers from (0, 1), one for each curve, which pick the smoothness
    std::span<const double> normals;  ///< standard normal ones, `normals_each()` for each curve …
    std::size_t stride = 0;           ///< … which begin so far apart
  };
  std::size_t normals_each() const;

  /// A column for each curve, a row for each place.
  void draw(const Numbers& numbers, Rows<double> curves) const;

 private:
  /// One hypothesis about smoothness.
  struct Hypothesis {
    std::size_t length = 0;        ///< number of the smooth part's length
    double smooth_variance = 0.0;  ///< a²
    double rough_variance = 0.0;   ///< k²
  };
  class StatesLikelihood;

  void consider_hypotheses(const std::vector<double>& amplitudes);
  double log_likelihood(const Hypothesis& hypothesis) const;
  /// In the axes of a hypothesis, independent of each other: appends m means and as many standard deviations.
  void append_coordinates(const Hypothesis& hypothesis, std::vector<double>& numbers) const;
  void draw_by_axes(const Numbers& numbers, Rows<double> curves) const;
  void draw_by_states(const Numbers& numbers, Rows<double> curves) const;

  std::vector<double> values_;
  double noise_variance_ = 0.0;
  std::size_t trend_terms_ = 0;
  CurveForm form_ = CurveForm::axes;
  std::shared_ptr<const CurveFrame> frame_;
  std::vector<std::vector<double>> coordinates_;  ///< coordinates of the values, in the axes of each length
  std::vector<double> beside_trend_;              ///< the values without their trend; of states
  std::vector<Hypothesis> hypotheses_;
  static constexpr std::uint32_t not_kept = 0xffff'ffffu;
  std::vector<std::uint32_t> kept_;       ///< per hypothesis and axis the number of its coordinates, or not_kept
  std::vector<double> kept_coordinates_;  ///< as append_coordinates() leaves them, one after the other
  WeightedChoice choice_;
};

}  // namespace axiometry::numeric
