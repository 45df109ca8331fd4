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
  const std::size_t m = posterior.size(), each = posterior.normals_each();
  std::vector<double> choices(count), normals(count * each), curves(m * count);
  fill_uniform({seed, 0, 0}, choices);
  fill_normal({seed, 1, 0}, normals);
  posterior.draw({choices, normals, each}, Rows<double>{curves, count});
  Draws found;
  for (std::size_t i = 0; i < m; ++i)
    found.of_place.emplace_back(curves.begin() + static_cast<std::ptrdiff_t>(i * count),
                                curves.begin() + static_cast<std::ptrdiff_t>((i + 1) * count));
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

struct Measured {
  std::vector<double> places, values;
};

/// Uneven places, and values with a trend, a bend and something of their own.
Measured uneven(std::size_t m) {
  std::vector<double> z(2 * m);
  fill_normal({3, 1, m}, z);
  Measured found;
  for (std::size_t i = 0; i < m; ++i) {
    found.places.push_back(10.0 * double(i) + 3.0 * std::tanh(z[i]));
    found.values.push_back(100.0 + 0.3 * found.places[i] + 4.0 * std::sin(0.02 * found.places[i]) + z[m + i]);
  }
  return found;
}

/// Mean and covariance of the draws that follow a choice: those are linear in their normal numbers.
struct Moments2 {
  std::vector<double> mean, covariance;
};

Moments2 exact_moments(const CurvePosterior& posterior, double choice) {
  const std::size_t m = posterior.size(), each = posterior.normals_each(), count = each + 1;
  std::vector<double> choices(count, choice), normals(count * each, 0.0), curves(m * count);
  for (std::size_t k = 0; k < each; ++k) normals[(k + 1) * each + k] = 1.0;
  posterior.draw({choices, normals, each}, Rows<double>{curves, count});
  Moments2 found{std::vector<double>(m), std::vector<double>(m * m, 0.0)};
  for (std::size_t i = 0; i < m; ++i) found.mean[i] = curves[i * count];
  for (std::size_t i = 0; i < m; ++i)
    for (std::size_t j = 0; j < m; ++j)
      for (std::size_t k = 1; k < count; ++k)
        found.covariance[i * m + j] +=
            (curves[i * count + k] - found.mean[i]) * (curves[j * count + k] - found.mean[j]);
  return found;
}

/// Validation: axes and states are one distribution, of hypotheses and of curves under each of them.
TEST(CurvePosterior, IsTheSameByStatesAsByAxes) {
  for (std::size_t m : {3u, 7u, 40u})
    for (std::size_t terms : {1u, 2u})
      for (double noise : {1e-6, 0.04, 1.0, 25.0}) {
        const Measured data = uneven(m);
        const CurvePosterior by_axes({data.places, data.values, noise, terms, CurveForm::axes});
        const CurvePosterior by_states({data.places, data.values, noise, terms, CurveForm::states});
        for (double choice = 0.013; choice < 1.0; choice += 0.07) {
          const Moments2 axes = exact_moments(by_axes, choice), states = exact_moments(by_states, choice);
          for (std::size_t i = 0; i < m; ++i) ASSERT_NEAR(states.mean[i], axes.mean[i], 1e-8) << m << ' ' << noise;
          for (std::size_t k = 0; k < m * m; ++k)
            ASSERT_NEAR(states.covariance[k], axes.covariance[k], 1e-8 * noise) << m << ' ' << noise;
        }
      }
}

TEST(CurvePosterior, GivesTheSameCurveWhateverIsDrawnBesideIt) {
  const Measured data = uneven(100);
  const CurvePosterior posterior({data.places, data.values, 1.0, 2});
  const Draws many = draws(posterior, 37), few = draws(posterior, 5);
  for (std::size_t i = 0; i < 100; ++i)
    for (std::size_t t = 0; t < 5; ++t) EXPECT_EQ(many.of_place[i][t], few.of_place[i][t]);
}

TEST(CurvePosterior, IsTheSameBesideOneWithTheSamePlaces) {
  for (CurveForm form : {CurveForm::axes, CurveForm::states}) {
    const Measured data = uneven(20), other = uneven(21);
    const NoisyCurve asked{data.places, data.values, 1.0, 2, form};
    const Draws alone = draws(CurvePosterior(asked), 9);
    const CurvePosterior same({data.places, data.places, 0.1, 2, form});
    const CurvePosterior constant({data.places, data.places, 0.1, 1, form});
    const CurvePosterior elsewhere({other.places, other.values, 0.1, 2, form});
    for (const CurvePosterior* alike : {&same, &constant, &elsewhere})
      EXPECT_EQ(draws(CurvePosterior(asked, alike), 9).of_place, alone.of_place);
  }
}

TEST(CurvePosterior, OfManyPlacesKeepsToTheNoiseOfItsValues) {
  Measured data = uneven(5000);
  const auto truth_at = [&](std::size_t i) { return 40.0 * std::sin(data.places[i] / 6000.0); };
  std::vector<double> noise(5000);
  fill_normal({4, 2, 0}, noise);
  for (std::size_t i = 0; i < 5000; ++i) data.values[i] = truth_at(i) + noise[i];
  const auto found = draws(CurvePosterior({data.places, data.values, 1.0, 2}), 16);
  double squares = 0.0;
  for (std::size_t i = 0; i < 5000; ++i) {
    const Moments at = moments(found.of_place[i]);
    squares += std::pow(at.mean - truth_at(i), 2) / 5000.0;
  }
  EXPECT_LT(std::sqrt(squares), 0.2);  // 1 for the values alone
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
