// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <span>
#include <vector>

/// Whether two samples come from one distribution. Seeds are fixed: a bound that chance passes once in a million tests
/// is never passed, or always.
namespace axiometry::testing_support {

inline constexpr double million_to_one = 2.69;      ///< of two_sample_distance(): √(−ln(p/2)/2)
inline constexpr double million_to_one_of_z = 4.9;  ///< of a standard normal number, either side

/// Kolmogorov and Smirnov: the largest distance of both distribution functions, times √(NM/(N + M)).
inline double two_sample_distance(std::span<const double> first, std::span<const double> second) {
  std::vector<double> a(first.begin(), first.end()), b(second.begin(), second.end());
  std::ranges::sort(a);
  std::ranges::sort(b);
  const auto n = double(a.size()), m = double(b.size());
  double largest = 0.0;
  for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
    const double x = std::min(a[i], b[j]);
    while (i < a.size() && a[i] <= x) ++i;
    while (j < b.size() && b[j] <= x) ++j;
    largest = std::max(largest, std::abs(double(i) / n - double(j) / m));
  }
  return largest * std::sqrt(n * m / (n + m));
}

struct SampleMoments {
  double mean = 0.0, variance = 0.0, fourth = 0.0;  ///< the latter about the mean
};

inline SampleMoments sample_moments(std::span<const double> sample) {
  SampleMoments found;
  const auto n = double(sample.size());
  for (double x : sample) found.mean += x / n;
  for (double x : sample) {
    const double square = (x - found.mean) * (x - found.mean);
    found.variance += square / n;
    found.fourth += square * square / n;
  }
  return found;
}

/// How many of its standard deviations the difference of the means is away from 0, and that of the variances.
inline double mean_departure(const SampleMoments& a, const SampleMoments& b, std::size_t trials) {
  const double variance = (a.variance + b.variance) / double(trials);
  return variance > 0.0 ? std::abs(a.mean - b.mean) / std::sqrt(variance) : 0.0;
}
inline double variance_departure(const SampleMoments& a, const SampleMoments& b, std::size_t trials) {
  const auto of = [&](const SampleMoments& m) { return (m.fourth - m.variance * m.variance) / double(trials); };
  const double variance = of(a) + of(b);
  return variance > 0.0 ? std::abs(a.variance - b.variance) / std::sqrt(variance) : 0.0;
}

/// Ranks of a sample, about 0 and of the variance 1: products of two of them are correlations after Spearman, which
/// scatter by 1/√N for independent quantities of any distribution, and by little more for others.
inline std::vector<double> standard_ranks(std::span<const double> sample) {
  std::vector<std::size_t> order(sample.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t k) { return sample[k]; });
  const auto n = double(sample.size());
  std::vector<double> ranks(sample.size());
  for (std::size_t k = 0; k < order.size(); ++k)
    ranks[order[k]] = (double(k) - 0.5 * (n - 1.0)) / std::sqrt((n * n - 1.0) / 12.0);
  return ranks;
}

}  // namespace axiometry::testing_support
