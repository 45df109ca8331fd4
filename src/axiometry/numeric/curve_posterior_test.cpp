// SPDX-License-Identifier: Apache-2.0
#include "axiometry/numeric/curve_posterior.h"

#include <gtest/gtest.h>

#include <cmath>

#include "axiometry/numeric/moments.h"
#include "axiometry/numeric/random/random.h"

namespace axiometry::numeric {
namespace {

struct Draws {
  std::vector<std::vector<double>> of_place;  ///< values of every draw
};

Draws draws(const CurvePosterior& posterior, std::size_t count, std::uint64_t seed = 1) {
  const std::size_t m = posterior.size();
  std::vector<double> choices(count), normals(count * m), curve(m);
  fill_uniform({seed, 0, 0}, choices);
  fill_normal({seed, 1, 0}, normals);
  Draws found{std::vector<std::vector<double>>(m)};
  for (std::size_t t = 0; t < count; ++t) {
    posterior.draw(choices[t], std::span(normals).subspan(t * m, m), curve);
    for (std::size_t i = 0; i < m; ++i) found.of_place[i].push_back(curve[i]);
  }
  return found;
}

TEST(CurvePosterior, WithoutNoiseGivesBackWhatWasSeen) {
  const std::vector<double> places = {0, 1, 3}, values = {2.5, -1.0, 7.25};
  const CurvePosterior posterior({places, values, 0.0, 2});
  const Draws found = draws(posterior, 3);
  for (const auto& of_place : found.of_place) EXPECT_EQ(of_place[0], of_place[2]);
  EXPECT_EQ(draws(posterior, 1).of_place[2][0], 7.25);
}

TEST(CurvePosterior, KnowsNoMoreThanTheValueOfPlacesThatOnlyTheTrendJoins) {
  const std::vector<double> places = {0, 10}, values = {3.0, -4.0};
  const auto found = draws(CurvePosterior({places, values, 0.25, 2}), 20000);
  for (std::size_t i = 0; i < 2; ++i) {
    const Moments moment = moments(found.of_place[i]);
    EXPECT_NEAR(moment.mean, values[i], 4 * 0.5 / std::sqrt(20000.0));
    EXPECT_NEAR(moment.standard_deviation, 0.5, 0.01);
  }
}

TEST(CurvePosterior, LearnsFromNeighboursWhereTheCurveIsSmooth) {
  std::vector<double> places, values;
  for (int i = 0; i < 21; ++i) {
    places.push_back(i);
    values.push_back(10.0 * std::sin(0.2 * i) + (i % 2 == 0 ? 0.5 : -0.5));
  }
  const auto found = draws(CurvePosterior({places, values, 0.25, 2}), 5000);
  EXPECT_LT(moments(found.of_place[10]).standard_deviation, 0.35);  // 0.5 for the value alone
  EXPECT_NEAR(moments(found.of_place[10]).mean, 10.0 * std::sin(2.0), 0.4);
}

TEST(CurvePosterior, FollowsAValueThatStandsOutFarBeyondTheNoise) {
  std::vector<double> places, values(11, 0.0);
  for (int i = 0; i < 11; ++i) places.push_back(i);
  values[5] = 50.0;
  const auto found = draws(CurvePosterior({places, values, 0.01, 1}), 2000);
  EXPECT_NEAR(moments(found.of_place[5]).mean, 50.0, 0.1);
}

/// Validation: for curves drawn from the model, intervals hold the truth as often as they say.
TEST(CurvePosterior, HoldsTheRangeOfTheTrueCurveInNinetyFivePercent) {
  constexpr std::size_t simulations = 400, m = 9, count = 800;
  int held = 0;
  for (std::size_t k = 0; k < simulations; ++k) {
    std::vector<double> z(2 * m + 3), places, truth, seen;
    fill_normal({99, 7, k}, z);
    for (std::size_t i = 0; i < m; ++i) {
      const double x = static_cast<double>(i);
      places.push_back(x);
      truth.push_back(2.0 * z[0] * std::sin(0.7 * x + z[1]) + 0.3 * z[2] * x + 0.4 * z[3 + i]);
      seen.push_back(truth.back() + z[3 + m + i]);
    }
    const auto found = draws(CurvePosterior({places, seen, 1.0, 2}), count, k + 1);
    std::vector<double> ranges;
    for (std::size_t t = 0; t < count; ++t) {
      double low = 1e9, high = -1e9;
      for (std::size_t i = 0; i < m; ++i) {
        low = std::min(low, found.of_place[i][t]);
        high = std::max(high, found.of_place[i][t]);
      }
      ranges.push_back(high - low);
    }
    std::ranges::sort(ranges);
    const auto [low, high] = std::ranges::minmax(truth);
    held += ranges[count / 40] <= high - low && high - low <= ranges[count - count / 40];
  }
  EXPECT_NEAR(held / double(simulations), 0.95, 4 * std::sqrt(0.95 * 0.05 / double(simulations)));
}

}  // namespace
}  // namespace axiometry::numeric
