// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/comparison_slack.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

namespace axiometry::iso230_2 {
namespace {

/// A test whose readings are whole steps, its parameters in whole parts of a step, and the same as doubles.
struct SteppedTest {
  std::int64_t E = 0;       // n times, in steps
  std::int64_t B = 0;       // n times
  std::int64_t B_mean = 0;  // n·m times
  Evaluation evaluation;
  ComparisonSlack slack;
};

SteppedTest stepped_test(std::mt19937_64& random, int places, std::size_t targets, std::size_t runs) {
  const double steps_per_um = std::pow(10.0, places);
  std::vector<Position> positions;
  std::vector<double> deviations;
  for (std::size_t i = 0; i < targets; ++i) positions.push_back(Position::native(50.0 * static_cast<double>(i)));
  std::vector<std::int64_t> sums;
  for (std::size_t cell = 0; cell < 2 * targets; ++cell) {
    std::int64_t sum = 0;
    for (std::size_t j = 0; j < runs; ++j) {
      const auto steps = static_cast<std::int64_t>(random() % 2001) - 1000;
      sum += steps;
      deviations.push_back(static_cast<double>(steps) / steps_per_um);
    }
    sums.push_back(sum);
  }
  SteppedTest test;
  test.E = *std::ranges::max_element(sums) - *std::ranges::min_element(sums);
  for (std::size_t i = 0; i < targets; ++i) {
    test.B = std::max(test.B, std::abs(sums[i] - sums[targets + i]));
    test.B_mean += sums[i] - sums[targets + i];
  }
  const Series series = Series::make_dense(positions, runs, deviations).value();
  test.evaluation = evaluate(series);
  test.slack = comparison_slack(series);
  return test;
}

// Validation: sums of whole numbers decide, doubles must agree at the limit and one step of the limit to either side.
TEST(ComparisonSlack, DecidesAsWholeNumbersDo) {
  std::mt19937_64 random(230);
  std::size_t moved_by_rounding = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    const int places = 1 + trial % 3;  // 0.1, 0.01, 0.001 µm
    const SteppedTest test = stepped_test(random, places, 2 + random() % 12, trial % 2 == 0 ? 5 : 10);
    const AxisParameters& p = test.evaluation.parameters;
    const std::int64_t runs = trial % 2 == 0 ? 5 : 10;
    const auto check = [&](const char* key, double y, std::int64_t whole, std::int64_t parts) {
      // Limits have one place more than the readings; the value is whole / parts steps.
      const double limit_steps_per_um = std::pow(10.0, places + 1);
      const std::int64_t below = 10 * whole / parts;
      for (std::int64_t limit = below - 1; limit <= below + 1; ++limit) {
        const double T = static_cast<double>(limit) / limit_steps_per_um;
        if (T < 0) continue;
        const bool kept = 10 * whole <= limit * parts;
        EXPECT_EQ(at_most(y, T, test.slack.of(*find_parameter(key), y)), kept) << key << " " << y << " " << T;
        moved_by_rounding += (y <= T) != kept;
      }
    };
    check("E", p.E->in_native(), test.E, runs);
    check("B", p.B->in_native(), test.B, runs);
    check("B_mean", std::abs(p.B_mean->in_native()), std::abs(test.B_mean),
          runs * static_cast<std::int64_t>(test.evaluation.positions.size()));
  }
  EXPECT_GT(moved_by_rounding, 100U);  // a plain comparison fails here
}

TEST(ComparisonSlack, KeepsARepeatabilityThatIsADecimal) {
  // 3, 3, 3, 3, 8 steps: s = √5 steps; −1, 1 about the mean with n = 2: s = √2; 0, 0, 0, 4 · n = 4: s = 2 steps.
  std::mt19937_64 random(4);
  for (int trial = 0; trial < 300; ++trial) {
    const auto offset = static_cast<double>(static_cast<int>(random() % 4000) - 2000);
    const auto a = static_cast<double>(1 + random() % 50);
    std::vector<double> deviations;
    for (const double step : {0.0, 0.0, 0.0, 2.0 * a}) deviations.push_back((offset + step) / 10.0);
    deviations.insert(deviations.end(), 4, offset / 10.0);
    deviations.insert(deviations.end(), 8, std::numeric_limits<double>::quiet_NaN());
    const std::vector<Position> targets = {Position::native(0), Position::native(500)};
    deviations[8] = deviations[12] = deviations[4];  // each target one reading from above
    const Series series = Series::make_dense(targets, 4, deviations).value();
    const double R = evaluate(series).parameters.R_up->in_native();  // 4 s, s = a steps
    const double slack = comparison_slack(series).of(*find_parameter("R_up"), R);
    EXPECT_TRUE(at_most(R, 4.0 * a / 10.0, slack)) << R;
    EXPECT_FALSE(at_most(R, 4.0 * a / 10.0 * (1.0 - 2e-9), slack)) << R;
  }
}

}  // namespace
}  // namespace axiometry::iso230_2
