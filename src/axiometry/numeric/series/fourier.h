// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

namespace axiometry::numeric {

/// Σ_m x_m e^{2πi km/n} in place of x_k, n a power of two: Cooley and Tukey's transform in n log₂ n steps, the factors
/// of a table. Errors are below log₂ n ε of the root of the sum of squares.
class FourierTransform {
 public:
  /// Contract: a power of two.
  explicit FourierTransform(std::size_t size);

  /// Contract: of this size.
  void operator()(std::span<std::complex<double>> values) const;

 private:
  std::vector<std::complex<double>> turns_;  ///< e^{2πi k/n}, k < n/2
};

/// Equally spaced frequencies: first + k step.
struct FrequencyGrid {
  double first = 0.0;
  double step = 0.0;
  std::size_t count = 0;
};

/// Σ_j w_j e^{2πi f x_j} of frequencies f, places x_j anywhere: a row of sums for each row of weights. In a time of
/// n + K log K instead of n K, n places and K frequencies.
///
/// Each place is spread over a grid as a Gaussian of 33 points, the grid is transformed, and what the Gaussian has made
/// smaller is made up for (Greengard & Lee, Accelerating the nonuniform fast Fourier transform, SIAM Review 46, 2004,
/// eqs. 5 to 10, R = 2, M_sp = 16; the Gaussian in three factors of which one is a table: section 3). Within 1e-13
/// Σ|w_j| beside the rounding of the angles, which the direct sum has, too.
class FourierSums {
 public:
  static constexpr std::size_t most_at_once = 1 << 13;  ///< frequencies whose grids stay in a core's cache

  /// Of places and weights that stay where they are. Contract: a weight in each row for each place.
  FourierSums(std::span<const double> places, std::span<const std::span<const double>> weights);

  /// The sums of the row of weights with that number, one for each frequency, until the next call. Contract: at most
  /// most_at_once frequencies.
  std::span<const std::vector<std::complex<double>>> operator()(const FrequencyGrid& grid);

 private:
  void spread(double middle, double step);

  std::span<const double> places_;
  std::vector<std::span<const double>> weights_;
  FourierTransform transform_;
  std::vector<double> bell_, made_up_;
  std::vector<std::vector<std::complex<double>>> grids_, sums_;
};

}  // namespace axiometry::numeric
