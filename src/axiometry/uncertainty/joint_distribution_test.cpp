// SPDX-License-Identifier: Apache-2.0
#include "axiometry/uncertainty/joint_distribution.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "axiometry/numeric/moments.h"

namespace axiometry::uncertainty {
namespace {

constexpr std::size_t n = 200'000;

JointDistribution joint(std::vector<std::string_view> texts, std::vector<double> matrix) {
  std::vector<Distribution> marginals;
  for (const std::string_view text : texts) marginals.push_back(Distribution::parse(text).value());
  return {marginals, Correlation::make(texts.size(), std::move(matrix)).value()};
}

std::vector<double> drawn(const JointDistribution& inputs) {
  std::vector<double> rows(inputs.size() * n);
  inputs.sample({5, 10, 2}, {rows, n});
  return rows;
}

double correlation_of(std::span<const double> a, std::span<const double> b) {
  const auto x = numeric::moments(a), y = numeric::moments(b);
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - x.mean) * (b[i] - y.mean);
  return sum / (static_cast<double>(a.size() - 1) * x.standard_deviation * y.standard_deviation);
}

TEST(JointDistribution, DrawsNormalInputsWithTheirCorrelation) {
  const auto inputs =
      joint({"normal 1 2", "normal 0 1", "normal -3 0.5"}, {1, -0.355, 0.858, -0.355, 1, -0.645, 0.858, -0.645, 1});
  const std::vector<double> rows = drawn(inputs);
  const BlockOutputs x{const_cast<std::vector<double>&>(rows), n};
  EXPECT_NEAR(correlation_of(x.row(0), x.row(1)), -0.355, 4 * (1 - 0.355 * 0.355) / std::sqrt(n));
  EXPECT_NEAR(correlation_of(x.row(0), x.row(2)), 0.858, 4 * (1 - 0.858 * 0.858) / std::sqrt(n));
  EXPECT_NEAR(correlation_of(x.row(1), x.row(2)), -0.645, 4 * (1 - 0.645 * 0.645) / std::sqrt(n));
  EXPECT_NEAR(numeric::moments(x.row(2)).mean, -3.0, 4 * 0.5 / std::sqrt(n));
  EXPECT_NEAR(numeric::moments(x.row(0)).standard_deviation, 2.0, 4 * 2 / std::sqrt(2 * n));
}

TEST(JointDistribution, CouplesOtherDistributionsAsItSays) {
  const auto inputs = joint({"uniform 0 1", "uniform 5 7"}, {1, 0.8, 0.8, 1});
  std::vector<double> rows = drawn(inputs);
  const BlockOutputs x{rows, n};
  EXPECT_NEAR(correlation_of(x.row(0), x.row(1)), 6 / std::numbers::pi * std::asin(0.4), 0.005);
  EXPECT_NEAR(numeric::moments(x.row(1)).standard_deviation, 2 / std::sqrt(12), 0.005);
}

TEST(JointDistribution, TakesInputsThatAreOneAndTheSame) {
  const auto inputs = joint({"normal 0 1", "normal 0 2", "arcsine -1 1"}, {1, 1, -1, 1, 1, -1, -1, -1, 1});
  std::vector<double> rows = drawn(inputs);
  const BlockOutputs x{rows, n};
  for (std::size_t t = 0; t < 100; ++t) {
    EXPECT_DOUBLE_EQ(x.row(1)[t], 2 * x.row(0)[t]);
    EXPECT_NEAR(x.row(2)[t], inputs.marginals()[2].from_normal(-x.row(0)[t]), 1e-12);
  }
}

TEST(JointDistribution, LeavesTheDrawsOfOtherInputsAsTheyAre) {
  std::vector<double> two = drawn(joint({"normal 0 1", "t 3 0 1"}, {1, 0, 0, 1}));
  std::vector<double> three = drawn(joint({"normal 0 1", "t 3 0 1", "normal 4 1"}, {1, 0, 0.7, 0, 1, 0, 0.7, 0, 1}));
  EXPECT_TRUE(std::ranges::equal(two, std::span(three).first(2 * n)));
}

TEST(BlockModel, EvaluatesAModelOfSingleTrials) {
  const auto inputs = joint({"normal 1 0.1", "uniform 0 1"}, {1, 0, 0, 1});
  const ModelFunction sum_and_product = [](std::span<const double> x, std::span<double> y) {
    y[0] = x[0] + x[1];
    y[1] = x[0] * x[1];
  };
  const auto result = propagate(block_model(sum_and_product, inputs, 3), 2, {.trials = 100'000});
  ASSERT_TRUE(result);
  EXPECT_NEAR(result->outputs[0].mean, 1.5, 4 * result->outputs[0].mean_error);
  EXPECT_NEAR(result->outputs[0].sd, std::sqrt(0.01 + 1 / 12.), 4 * result->outputs[0].sd_error);
  EXPECT_NEAR(result->outputs[1].mean, 0.5, 4 * result->outputs[1].mean_error);
  EXPECT_NEAR(result->outputs[1].sd, std::sqrt(1.01 / 3 - 0.25), 4 * result->outputs[1].sd_error);
}

}  // namespace
}  // namespace axiometry::uncertainty
