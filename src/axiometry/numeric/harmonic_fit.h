// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

/// A straight line and a periodic curve through values at places that may lie unevenly:
///
///     y(x) = a + b (x − x₀) + Σ_h [ s_h sin(2π h (x − x₀)/P) + c_h cos(2π h (x − x₀)/P) ]
///
/// over a list of orders h, such as 1, 2, 4.
///
/// Least squares with equal weights, line and curve at once: a line taken off first is tilted by the curve and takes a
/// part of it along (up to 15 % of the amplitude over two periods). By QR with column pivoting; the line's columns are
/// centred and scaled, so that places far from zero cost no digits.
///
/// Derivation: docs/theory/periodic-error.md. Independent figures: tests/periodic_oracle.py.
namespace axiometry::numeric {

/// One value per place. Contract wherever it is used: as many places as values, ascending, all different, finite.
struct HarmonicData {
  std::span<const double> places;
  std::span<const double> values;
};

/// Units: those of places (x) and values (y); angles in radians.
struct HarmonicFit {
  double origin = 0.0;              ///< x₀, the first place
  double period = 0.0;              ///< P
  std::vector<std::size_t> orders;  ///< ascending
  bool period_fitted = false;
  std::vector<double> coefficients;  ///< a, b, then s_h and c_h of each order and, where it was fitted, P
  std::vector<double> covariance;    ///< covariance of the coefficients, row by row, from the residuals' variance
  std::vector<double> residuals;     ///< y less the fit, at the places
  double sum_of_squares = 0.0;       ///< sum of the squares of the residuals
  std::size_t degrees_of_freedom = 0;

  /// Where s_h stands among the coefficients; c_h follows it. Contract: the order was fitted.
  std::size_t place_of(std::size_t order) const;
  double sine(std::size_t order) const { return coefficients[place_of(order)]; }        ///< s_h
  double cosine(std::size_t order) const { return coefficients[place_of(order) + 1]; }  ///< c_h
  double covariance_of(std::size_t row, std::size_t column) const {
    return covariance[row * coefficients.size() + column];
  }
  double line(double x) const { return coefficients[0] + coefficients[1] * (x - origin); }
  /// Probability that noise alone makes this harmonic as large (F test with 2 and ν degrees of freedom): (1 + 2F/ν) to
  /// the power −ν/2.
  double chance_of(std::size_t order) const;
};

/// The fit at a known period. Nothing where the columns are not independent (targets every half period show no sine),
/// or fewer than one value more than coefficients.
std::optional<HarmonicFit> fit_harmonics(const HarmonicData& data, double period, std::span<const std::size_t> orders);

/// The fit with the period as one more unknown, from a start within the main lobe (about ± P²/T) of the minimum:
/// Gauss-Newton on the period with the linear coefficients eliminated, steps halved until the sum of squares falls;
/// done when a step is below 1e-12 P or nothing falls any more. Nothing as above, or when the period leaves P/2 … 2P.
///
/// An order of which there is nothing in the values makes the period worse and its uncertainty too small: its noise
/// counts h times.
std::optional<HarmonicFit> fit_harmonics_and_period(const HarmonicData& data, double period,
                                                    std::span<const std::size_t> orders);

}  // namespace axiometry::numeric
