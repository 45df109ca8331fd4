// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/monte_carlo/mean_distributions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "axiometry/standards/iso230_2/uncertainty/gum.h"
#include "tests/support/series.h"

namespace axiometry::iso230_2 {
namespace {

using testing::ElementsAre;

axiometry::Test table2_of_inputs(std::vector<InputDistribution> distributions) {
  Metadata metadata;
  metadata.gum.distributions = std::move(distributions);
  return {metadata, testing_support::table2::series(), {}};
}

MonteCarlo drawn(const axiometry::Test& test) {
  MonteCarloOptions options;
  options.propagation.trials = 40'000;
  options.propagation.threads = 1;
  options.contribution_trials = 1000;
  auto result = monte_carlo(test, evaluate(test.series), options);
  if (!result || !*result) throw std::logic_error(result ? "nothing" : result.error().message);
  return **std::move(result);
}

TEST(MeanDistributions, AgreeWithTheLawOfPropagationWhereAllIsLinear) {  // Lira & Cargill, eqs 8 and 10
  const axiometry::Test test = table2_of_inputs({{"scale:laser", "normal 0 2"}, {"reading:noise", "normal 0 0.5"}});
  const MonteCarlo found = drawn(test);
  const auto propagated = gum(test, evaluate(test.series));
  ASSERT_TRUE(propagated && *propagated);
  ASSERT_EQ(found.means.size(), test.series.target_count());
  EXPECT_EQ(found.mean_trials, 20'000u);
  const auto& positions = (*propagated)->positions;
  for (std::size_t i = 0; i < found.means.size(); ++i) {
    ASSERT_TRUE(found.means[i].mean && positions[i].mean) << i;
    const MeanInterval& own = *found.means[i].mean;
    EXPECT_NEAR(own.value, evaluate(test.series).positions[i].mean->in_native(), 1e-12);
    EXPECT_LE(own.low, own.value);
    EXPECT_GE(own.high, own.value);
  }
  // At the far end the length of the laser alone: 2 µm/m of 1.744 m.
  const MeanInterval& far = *found.means.back().mean;
  EXPECT_NEAR(far.u, positions.back().mean->u.in_native(), 0.1 * far.u);
  EXPECT_NEAR(0.5 * (far.high - far.low), 1.96 * far.u, 0.05 * far.u);
}

TEST(MeanDistributions, CountAnErrorBetweenTwoPlacesFromTheZero) {
  axiometry::Test test = table2_of_inputs({});
  test.metadata.uncertainty.device_calibration = Deviation::native(2.0);  // U, k = 2
  const MonteCarlo found = drawn(test);
  for (const MeanDistribution& position : found.means) {
    ASSERT_TRUE(position.up && position.down && position.mean);
    EXPECT_NEAR(position.mean->u, 1.0, 0.02);
  }
}

/// Shifts of whole runs move all means alike: u(d)/√n, of the long run s/√n of the shifts that were seen.
TEST(MeanDistributions, HaveShiftsOfWholeRuns) {
  const axiometry::Test clamped = table2_of_inputs({{"run:clamping", "normal 0 0.5"}});
  for (const MeanDistribution& position : drawn(clamped).means)
    EXPECT_NEAR(position.mean.value().u, 0.5 / std::sqrt(5.0), 0.02);
  axiometry::Test machine = table2_of_inputs({});
  machine.metadata.gum.measurand = Measurand::this_machine;
  const auto propagated = gum(machine, evaluate(machine.series));
  ASSERT_TRUE(propagated && *propagated);
  const MonteCarlo found = drawn(machine);
  for (std::size_t i = 0; i < found.means.size(); ++i) {
    const double u = (*propagated)->positions[i].up->total.u.in_native();  // s/√n; of Table 2 nearly all of s is shifts
    EXPECT_GT(found.means[i].up->u, 0.6 * u) << i;
    EXPECT_LT(found.means[i].up->u, 2.5 * u) << i;
  }
}

TEST(MeanDistributions, ClaimNothingWhereNothingActs) {
  const MonteCarlo found = drawn(table2_of_inputs({{"scale:laser", "normal 0 2"}}));
  EXPECT_GT(found.means.back().mean->u, 3.0);
  axiometry::Test at_zero = table2_of_inputs({{"scale:laser", "normal 0 2"}});
  const auto series =
      Series::make_dense({Position::native(0.0), Position::native(100.0)}, 1, std::vector{1.0, 2.0, 3.0, 4.0});
  ASSERT_TRUE(series);
  at_zero.series = *series;
  const MonteCarlo zero = drawn(at_zero);
  EXPECT_FALSE(zero.means.front().mean) << "an error of length does nothing at 0";
  EXPECT_TRUE(zero.means.back().mean);
}

TEST(MeanDistributions, StateNothingWhereNoScatterExplainsAReading) {
  axiometry::Test test = table2_of_inputs({});
  test.metadata.gum.measurand = Measurand::this_machine;
  EXPECT_FALSE(drawn(test).means.empty());
  std::vector<double> readings;
  for (const Direction direction : {Direction::up, Direction::down})
    for (std::size_t i = 0; i < test.series.target_count(); ++i)
      for (const double x : test.series.cell(i, direction)) readings.push_back(x);
  readings[3] += 60.0;
  test.series = *Series::make_dense({test.series.targets().begin(), test.series.targets().end()},
                                    test.series.run_count(), readings);
  const MonteCarlo refused = drawn(test);
  EXPECT_FALSE(refused.distributions[0]->refusal.empty());
  EXPECT_TRUE(refused.means.empty());
  EXPECT_EQ(refused.mean_trials, 0u);
}

TEST(MeanDistributions, AreOfTargetsFromTheFirstToTheLast) {
  EXPECT_THAT(targets_of_means(3, 120), ElementsAre(0u, 1u, 2u));
  EXPECT_THAT(targets_of_means(1, 120), ElementsAre(0u));
  EXPECT_THAT(targets_of_means(9, 3), ElementsAre(0u, 4u, 8u));
  const auto thinned = targets_of_means(20'000, 120);
  EXPECT_EQ(thinned.size(), 120u);
  EXPECT_EQ(thinned.back(), 19'999u);
}

}  // namespace
}  // namespace axiometry::iso230_2
