// SPDX-License-Identifier: Apache-2.0
#include "axiometry/capture/rest_scatter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace axiometry::capture {
namespace {

/// Cells of which each is like the one before by that factor, of standard deviation 1, over many standstills: what is
/// told of the deviation of their mean, and what it is.
struct Told {
  double told = 0.0;
  double true_one = 0.0;
};

Told told_of(double alike, double drift_per_cell) {
  constexpr int standstills = 2000, cells = 12;
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  RestScatter all;
  double squares = 0.0;
  for (int k = 0; k < standstills; ++k) {
    RestScatterSums sums;
    double x = normal(random), sum = 0.0;
    for (int c = 0; c < cells; ++c) {
      sums.add(x + drift_per_cell * c);
      sum += x;
      x = alike * x + std::sqrt(1.0 - alike * alike) * normal(random);
    }
    squares += sum * sum / (cells * cells);
    all += sums.without_drift(drift_per_cell, cells);
  }
  return {deviation_of_mean(all, cells), std::sqrt(squares / standstills)};
}

TEST(RestScatter, TellsTheDeviationOfAMeanOfCellsThatAreAlike) {
  for (const double alike : {0.0, 0.3, 0.6, 0.8})
    for (const double drift : {0.0, 0.2}) {
      SCOPED_TRACE(testing::Message() << alike << ", drift " << drift);
      const Told found = told_of(alike, drift);
      EXPECT_NEAR(found.told, found.true_one, 0.06 * found.true_one);
    }
}

TEST(RestScatter, SaysNothingOfFewCells) {
  RestScatterSums sums;
  for (const double x : {1.0, 2.0, 1.0, 3.0}) sums.add(x);
  EXPECT_EQ(deviation_of_mean(sums.without_drift(0.0, 4.0), 4.0), 0.0);
}

}  // namespace
}  // namespace axiometry::capture
