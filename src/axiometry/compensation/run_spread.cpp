// SPDX-License-Identifier: Apache-2.0
#include "axiometry/compensation/run_spread.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "axiometry/numeric/moments.h"

namespace axiometry::compensation::retest {
namespace {

/// Of each run a number, and what scatter alone makes of their variance.
struct NumbersOfRuns {
  std::vector<double> of;
  double of_scatter = 0.0;
};

/// `within`: standard deviation of the readings about target, run and slope.
NumbersOfRuns shifts_of(const Series& series, Direction direction, double within) {
  const std::size_t runs = series.run_count();
  NumbersOfRuns shifts{std::vector<double>(runs)};
  std::vector<double> counts(runs);
  for (std::size_t i = 0; i < series.target_count(); ++i) {
    const std::span<const double> cell = series.cell(i, direction);
    const double mean = numeric::moments(cell).mean;
    for (std::size_t j = 0; j < runs; ++j)
      if (!std::isnan(cell[j])) shifts.of[j] += cell[j] - mean, counts[j] += 1.0;
  }
  for (std::size_t j = 0; j < runs; ++j) shifts.of[j] = counts[j] > 0.0 ? shifts.of[j] / counts[j] : 0.0;
  if (const double readings = std::accumulate(counts.begin(), counts.end(), 0.0); readings > 0.0)
    shifts.of_scatter = within * within * static_cast<double>(runs) / readings;
  return shifts;
}

/// Cholesky's, of a matrix that may be of lower rank: what is no more than rounding counts as nothing.
RunSpread factor_of(const std::array<RunNumbers, numbers_of_run>& covariance) {
  constexpr double rounding = 1e-12;
  RunSpread L{};
  for (std::size_t k = 0; k < numbers_of_run; ++k) {
    double left = covariance[k][k];
    for (std::size_t m = 0; m < k; ++m) left -= L[k][m] * L[k][m];
    if (!(left > rounding * covariance[k][k])) continue;
    L[k][k] = std::sqrt(left);
    for (std::size_t i = k + 1; i < numbers_of_run; ++i) {
      double product = covariance[i][k];
      for (std::size_t m = 0; m < k; ++m) product -= L[i][m] * L[k][m];
      L[i][k] = product / L[k][k];
    }
  }
  return L;
}

}  // namespace

RunSpread run_spread(const Series& series, const iso230_2::TiltStudy& study, bool tilted) {
  const std::size_t runs = series.run_count();
  std::array<NumbersOfRuns, numbers_of_run> numbers{shifts_of(series, Direction::up, study.within),
                                                    shifts_of(series, Direction::down, study.within),
                                                    {std::vector<double>(runs)},
                                                    {std::vector<double>(runs)}};
  if (tilted) {
    std::array<std::vector<double>, 2> tilts = iso230_2::direction_tilts(series);
    for (std::size_t d = 0; d < 2; ++d) {
      std::ranges::replace_if(
          tilts[d], [](double tilt) { return std::isnan(tilt); }, 0.0);
      numbers[2 + d] = {std::move(tilts[d]), study.of_scatter_each};
    }
  }
  std::array<RunNumbers, numbers_of_run> covariance{};
  for (std::size_t i = 0; i < numbers_of_run; ++i)
    for (std::size_t k = 0; k < numbers_of_run; ++k) {
      const std::vector<double>&a = numbers[i].of, &b = numbers[k].of;
      const double mean_a = numeric::moments(a).mean, mean_b = numeric::moments(b).mean;
      for (std::size_t j = 0; j < runs; ++j)
        covariance[i][k] += (a[j] - mean_a) * (b[j] - mean_b) / static_cast<double>(runs - 1);
      if (i == k) covariance[i][k] = std::max(0.0, covariance[i][k] - numbers[i].of_scatter);
    }
  return factor_of(covariance);
}

RunNumbers drawn_run(const RunSpread& spread, std::span<const double> z, double share) {
  RunNumbers numbers{};
  for (std::size_t k = 0; k < numbers_of_run; ++k)
    for (std::size_t m = 0; m <= k; ++m) numbers[k] += share * spread[k][m] * z[m];
  return numbers;
}

}  // namespace axiometry::compensation::retest
