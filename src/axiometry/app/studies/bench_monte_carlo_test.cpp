// SPDX-License-Identifier: Apache-2.0
//
// Validation: the figures of the model were computed by another program (numpy); every trial is computed again by
// evaluate() from the same draws.
#include "axiometry/app/studies/bench_monte_carlo.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include "axiometry/numeric/random/random.h"
#include "axiometry/standards/iso230_2/parameters.h"

namespace axiometry::app {
namespace {

constexpr std::size_t parameter_count = 12;

std::vector<double> trials_of(const MonteCarloBench& bench, std::uint64_t block, std::size_t trials) {
  std::vector<double> values(parameter_count * trials);
  monte_carlo_bench_model(bench)(block, {values, trials});
  return values;
}

Series series_from_draws(std::span<const double> draws, std::size_t strip, std::size_t trial) {
  std::vector<Position> positions;
  std::vector<double> deviations;
  for (int i = 0; i < 11; ++i) positions.push_back(Position::native(50.0 + 90.0 * i));
  for (int direction = 0; direction < 2; ++direction)
    for (int i = 0; i < 11; ++i)
      for (std::size_t j = 0; j < 5; ++j) {
        const double base = 6 * std::sin(0.55 * i) + 0.4 * i + (direction == 0 ? 0 : 2.5 + 0.6 * std::cos(0.9 * i));
        const double z = draws[deviations.size() * strip + trial];
        const double d = draws[(110 + j) * strip + trial];
        const double c = draws[115 * strip + trial];
        deviations.push_back(base + std::sqrt(0.65) * z + 0.5 * d + 1.5 * (0.05 + 0.09 * i) * c);
      }
  return *Series::make_dense(std::move(positions), 5, std::move(deviations));
}

/// The readings of both differ by the rounding of their sums: 8 units of 2⁻⁵² at 16 µm, and A by six times that.
TEST(BenchMonteCarlo, EvaluatesEveryTrialFromAllItsDraws) {
  constexpr std::size_t strip = 64, count = 100;
  const MonteCarloBench bench{.seed = 42};
  const auto values = trials_of(bench, 7, count);
  numeric::RandomStream stream({42, 0, 7});
  std::vector<double> draws(116 * strip);
  for (std::size_t trial = 0; trial < count; ++trial) {
    if (trial % strip == 0) stream.fill_normal(draws);
    const auto expected = iso230_2::evaluate(series_from_draws(draws, strip, trial % strip)).parameters;
    for (std::size_t k = 0; k < parameter_count; ++k)
      EXPECT_NEAR(values[k * count + trial], (expected.*iso230_2::parameters[k].member)->in_native(), 2e-13);
  }
}

TEST(BenchMonteCarlo, GivesATrialTheSameDrawsInAnyNumberOfTrials) {
  for (Precision precision : {Precision::both_double, Precision::both_single}) {
    const MonteCarloBench bench{.precision = precision};
    const auto many = trials_of(bench, 3, 1000);
    const auto few = trials_of(bench, 3, 77);
    for (std::size_t k = 0; k < parameter_count; ++k)
      for (std::size_t t = 0; t < 77; ++t) ASSERT_EQ(few[k * 77 + t], many[k * 1000 + t]);
  }
}

json::Value run(const MonteCarloBench& bench) {
  auto result = bench_monte_carlo(bench);
  EXPECT_TRUE(result.has_value());
  return std::move(*result);
}

double figure(const json::Value& result, std::string_view parameter, std::string_view key) {
  return result.find(parameter)->find(key)->number();
}

struct Reference {
  const char* parameter;
  double mean, sd, q025, q975;
};

constexpr Reference references[] = {
    {"A", 15.804, 1.169, 13.657, 18.224},      {"A_up", 13.776, 1.169, 11.630, 16.194},
    {"A_down", 13.175, 1.202, 10.945, 15.650}, {"E", 11.801, 0.834, 10.231, 13.479},
    {"E_up", 9.822, 0.829, 8.260, 11.489},     {"E_down", 9.179, 0.884, 7.501, 10.958},
    {"M", 9.390, 0.799, 7.873, 10.999},        {"R", 7.900, 0.779, 6.569, 9.612},
    {"R_up", 5.658, 0.938, 4.053, 7.715},      {"R_down", 5.658, 0.938, 4.053, 7.717},
    {"B", 3.591, 0.335, 2.997, 4.309},         {"B_mean", -2.526, 0.154, -2.827, -2.224},
};

/// Tolerances: 5 standard errors of this run and 0.003 for those of the reference and its digits. A quantile's is
/// √(p(1 − p)/N)/f: for the normal density f at 2.5 %, 2.7 sd/√N; the right tails are longer, 4 sd/√N.
TEST(BenchMonteCarlo, AgreesWithTheFiguresOfAnotherProgram) {
  constexpr std::size_t trials = 100'000;
  const double root = std::sqrt(static_cast<double>(trials));
  for (Precision precision : {Precision::both_double, Precision::both_single}) {
    const auto result = run({.trials = trials, .threads = 2, .seed = 1, .precision = precision});
    for (const Reference& r : references) {
      EXPECT_NEAR(figure(result, r.parameter, "mean"), r.mean, 5 * r.sd / root + 0.003) << r.parameter;
      EXPECT_NEAR(figure(result, r.parameter, "sd"), r.sd, 5 * r.sd / root + 0.003) << r.parameter;
      EXPECT_NEAR(figure(result, r.parameter, "q025"), r.q025, 20 * r.sd / root + 0.003) << r.parameter;
      EXPECT_NEAR(figure(result, r.parameter, "q975"), r.q975, 20 * r.sd / root + 0.003) << r.parameter;
    }
  }
}

TEST(BenchMonteCarlo, GivesTheSameBitsOnAnyNumberOfThreads) {
  for (Precision precision : {Precision::both_double, Precision::both_single}) {
    const auto one = run({.trials = 45'000, .threads = 1, .seed = 5, .precision = precision});
    for (unsigned threads : {2u, 3u}) {
      const auto more = run({.trials = 45'000, .threads = threads, .seed = 5, .precision = precision});
      for (const Reference& r : references)
        EXPECT_EQ(json::dump(*one.find(r.parameter)), json::dump(*more.find(r.parameter))) << r.parameter;
    }
  }
}

TEST(BenchMonteCarlo, RefusesAsPropagateDoes) { EXPECT_FALSE(bench_monte_carlo({.trials = 10}).has_value()); }

}  // namespace
}  // namespace axiometry::app
