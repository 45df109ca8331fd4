// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "axiometry/numeric/kernels/matern_kernel_types.h"

/// The Gaussian process with the covariance K of Matérn, ν = 5/2, variance 1, at m places along a line, in a time that
/// grows with m: what a matrix of m² numbers and its factors in m³ steps would say.
///
/// The process is the first of three numbers that follow a linear stochastic equation (Hartikainen & Särkkä, Kalman
/// filtering and smoothing solutions to temporal Gaussian process regression models, 2010). With κ = √5/length,
/// u = κ·(distance to the place before) and the state (f, f′/κ, f″/κ²):
///
///   A = e^{−u}(1 + N u + N² u²/2), N = (1 1 0; 0 1 1; −1 −3 −2)
///   Q = 16/3 ∫₀ᵘ φ φᵀ dt, φ(t) = e^{−t}(t²/2, t − t²/2, 1 − 2t + t²/2), by sums of positive terms of ∫ tᵏ e^{−2t} dt
///   covariance anywhere (1 0 −1/3; 0 1/3 0; −1/3 0 1)
///
/// A filter that goes along the places makes of λK + 1 the factors L F Lᵀ, F diagonal: the innovations L⁻¹x, their
/// variances F, and on its way back L⁻ᵀ of anything.
///
/// The trend is one or two columns T of any height (Rasmussen & Williams, Gaussian Processes for Machine Learning,
/// 2006, 2.7): what is said of values is said of what they are beside it, by M = S − S T (Tᵀ S T)⁻¹ Tᵀ S, S = (λK +
/// 1)⁻¹.
namespace axiometry::numeric {

class MaternFilter {
 public:
  static constexpr std::size_t lanes = matern_lanes;
  using Ratios = std::array<double, lanes>;  ///< λ ≥ 0, of each lane

  /// Contract: places ascend, all different; length > 0.
  MaternFilter(std::span<const double> places, double length);

  std::size_t size() const { return steps_.size(); }  ///< m

  /// One or two orthonormal columns, one after the other; refers to them.
  struct Trend {
    std::span<const double> columns;
    std::size_t terms = 1;
  };

  struct BesideTrend {
    double log_determinant = 0.0;  ///< ln det of λK + 1 in the space beside the trend
    double squares = 0.0;          ///< xᵀ M x
  };
  /// Of the same values for each ratio.
  std::array<BesideTrend, lanes> beside_trend(std::span<const double> values, const Trend& trend,
                                              const Ratios& ratios) const;

  /// Memory that passes leave to the next.
  struct Workspace {
    std::vector<double> products, kept;
  };
  /// M x of other values for each ratio, in place of x: a table of a row of `lanes` for each place.
  void weigh(const Trend& trend, const Ratios& ratios, std::span<double> values, Workspace& workspace) const;

  /// Curves of the process, of a row for each place, from three rows of standard normal numbers for each.
  void simulate(std::span<const double> normals, std::span<double> curves) const;

 private:
  MaternCurve curve(const Trend& trend) const;

  std::vector<MaternStep> steps_;
  std::vector<double> no_trend_;  ///< zeros in place of a column
};

}  // namespace axiometry::numeric
