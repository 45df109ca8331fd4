// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

/// What of the noise at rest stays in the mean: samples that follow each other need not be independent (turbulence of
/// the air, vibration), and neither need the means of cells. Derivation: docs/theory/capture.md.
namespace axiometry::capture {

/// How the means of the cells of one or more standstills differ, without a steady drift. mm or °.
struct RestScatter {
  std::size_t cells = 0;           ///< m
  std::size_t pairs = 0;           ///< of cells next to each other
  std::size_t pairs_over_one = 0;  ///< of cells with one between them
  double squares = 0.0;            ///< sum of the squared differences of these pairs
  double squares_over_one = 0.0;

  RestScatter& operator+=(const RestScatter& other);
};

class RestScatterSums {
 public:
  void add(double mean);
  /// `slope_per_s` of a straight line through the means, of the cells that took that long.
  RestScatter without_drift(double slope_per_s, double duration_s) const;

 private:
  RestScatter sums_;
  double before_ = 0.0, before_that_ = 0.0;
};

/// Standard deviation of the mean of `cells` cells whose means scatter like that, as if each were as much like the one
/// before (first-order autocorrelation, 0 at least). 0 where fewer than 20 pairs tell it.
double deviation_of_mean(const RestScatter& scatter, double cells);

}  // namespace axiometry::capture
