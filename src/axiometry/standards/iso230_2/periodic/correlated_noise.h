// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

/// Noise whose values resemble those of their neighbours, as residuals of an axis that does more than a line and a
/// curve do: x_k = ρ x_(k−1) + white noise, a first-order autoregression. Such noise makes long periods by itself, far
/// more often than the white noise that the tests of a spectrum know.
namespace axiometry::iso230_2 {

struct NoiseCorrelation {
  double lag_one = 0.0;  ///< correlation of the residuals of neighbouring targets, corrected for what the fit took out
  double most = 0.0;     ///< ρ may be so large: two standard errors more; 0 to 1
  bool told = false;     ///< more than white noise shows in one test of twenty

  /// By how much such noise exceeds white noise of the same size at a period of so many targets, for the ρ up to `most`
  /// that makes the most of it: (1 − ρ²)/(1 − 2ρ cos ω + ρ²) with ω = 2π/targets; 1 or more, at most 1/|sin ω|.
  double power_beside_white(double targets_per_period) const;

  /// How many times as uncertain as by white noise an amplitude of such a period is: √ of that; 1 where none is told.
  double uncertain_beside_white(double targets_per_period) const;

  /// The part of a sum of squares that white noise would have to take away for the same ratio to its power as what was
  /// taken away has to that of this noise.
  double white_reduction(double reduction, double targets_per_period) const;
};

/// Of the residuals of a fit in the order of the targets, which are taken as evenly spaced. Contract: more residuals
/// than degrees of freedom.
NoiseCorrelation noise_correlation(std::span<const double> residuals, std::size_t degrees_of_freedom);

}  // namespace axiometry::iso230_2
