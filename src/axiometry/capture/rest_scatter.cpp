// SPDX-License-Identifier: Apache-2.0
#include "axiometry/capture/rest_scatter.h"

#include <algorithm>
#include <cmath>

namespace axiometry::capture {
namespace {

constexpr std::size_t fewest_pairs = 20;
constexpr double most_alike = 0.95;  // ρ; beyond, a mean of few cells says nothing

}  // namespace

RestScatter& RestScatter::operator+=(const RestScatter& other) {
  cells += other.cells;
  pairs += other.pairs;
  pairs_over_one += other.pairs_over_one;
  squares += other.squares;
  squares_over_one += other.squares_over_one;
  return *this;
}

void RestScatterSums::add(double mean) {
  const double one = mean - before_, two = mean - before_that_;
  if (sums_.cells > 0) {
    ++sums_.pairs;
    sums_.squares += one * one;
  }
  if (sums_.cells > 1) {
    ++sums_.pairs_over_one;
    sums_.squares_over_one += two * two;
  }
  ++sums_.cells;
  before_that_ = before_;
  before_ = mean;
}

RestScatter RestScatterSums::without_drift(double slope_per_s, double duration_s) const {
  RestScatter scatter = sums_;
  if (scatter.cells == 0) return scatter;
  const double step = slope_per_s * duration_s / static_cast<double>(scatter.cells);
  scatter.squares = std::max(0.0, scatter.squares - static_cast<double>(scatter.pairs) * step * step);
  scatter.squares_over_one =
      std::max(0.0, scatter.squares_over_one - 4.0 * static_cast<double>(scatter.pairs_over_one) * step * step);
  return scatter;
}

/// Half the mean square of the differences is σ²(1 − ρ) of neighbours and σ²(1 − ρ²) of the next but one: their ratio
/// is 1 + ρ. The mean of m has the variance σ²/m · (1 + 2 Σ (1 − k/m) ρ^k).
double deviation_of_mean(const RestScatter& scatter, double cells) {
  if (scatter.pairs_over_one < fewest_pairs || cells < 1.0) return 0.0;
  const double near = 0.5 * scatter.squares / static_cast<double>(scatter.pairs);
  const double over_one = 0.5 * scatter.squares_over_one / static_cast<double>(scatter.pairs_over_one);
  if (!(near > 0.0)) return 0.0;
  const double alike = std::clamp(over_one / near - 1.0, 0.0, most_alike);
  double sum = 1.0, power = 1.0;
  for (double k = 1.0; k < cells && power > 1e-6; k += 1.0) {
    power *= alike;
    sum += 2.0 * (1.0 - k / cells) * power;
  }
  return std::sqrt(near / (1.0 - alike) * sum / cells);
}

}  // namespace axiometry::capture
