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

/// Σ_j w_j e^{2πi f x_j} of every frequency f, places x_j anywhere: a row of sums for each row of weights. In a time of
/// n + K log K instead of n K, n places and K frequencies.
///
/// Each place is spread over a grid as a Gaussian of 33 points, the grid is transformed, and what the Gaussian has made
/// smaller is made up for (Greengard & Lee, Accelerating the nonuniform fast Fourier transform, SIAM Review 46, 2004,
/// eqs. 5 to 10, R = 2, M_sp = 16). Within 1e-13 Σ|w_j| beside the rounding of the angles, which the direct sum has,
/// too.
std::vector<std::vector<std::complex<double>>> fourier_sums(std::span<const double> places,
                                                            std::span<const std::span<const double>> weights,
                                                            const FrequencyGrid& grid);

}  // namespace axiometry::numeric
