// SPDX-License-Identifier: Apache-2.0
#include "axiometry/uncertainty/monte_carlo.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <thread>

#include "axiometry/numeric/moments.h"
#include "axiometry/uncertainty/distribution.h"

namespace axiometry::uncertainty {
namespace {

BlockModel drawn_from(std::vector<std::string_view> texts, std::uint64_t seed = 1) {
  std::vector<Distribution> distributions;
  for (const std::string_view text : texts) distributions.push_back(Distribution::parse(text).value());
  return [distributions, seed](std::uint64_t block, BlockOutputs outputs) {
    for (std::size_t k = 0; k < distributions.size(); ++k) distributions[k].sample({seed, k, block}, outputs.row(k));
  };
}

MonteCarloResult run(const BlockModel& model, std::size_t outputs, const PropagationOptions& options) {
  auto result = propagate(model, outputs, options);
  EXPECT_TRUE(result) << result.error().to_string();
  return result ? std::move(*result) : MonteCarloResult{};
}

std::string error_of(const BlockModel& model, const PropagationOptions& options) {
  const auto result = propagate(model, 1, options);
  return result ? "no error" : result.error().message;
}

void expect_same(const MonteCarloResult& a, const MonteCarloResult& b) {
  ASSERT_EQ(a.trials, b.trials);
  for (std::size_t k = 0; k < a.outputs.size(); ++k) {
    const OutputSummary &x = a.outputs[k], &y = b.outputs[k];
    EXPECT_EQ(x.mean, y.mean);
    EXPECT_EQ(x.sd, y.sd);
    EXPECT_EQ(x.symmetric.lower, y.symmetric.lower);
    EXPECT_EQ(x.shortest.upper, y.shortest.upper);
    EXPECT_EQ(x.sd_error, y.sd_error);
    EXPECT_EQ(x.symmetric_error.upper, y.symmetric_error.upper);
    EXPECT_EQ(x.histogram.counts, y.histogram.counts);
  }
}

TEST(MonteCarlo, GivesTheSameToTheBitOnAnyNumberOfThreads) {
  const BlockModel model = drawn_from({"normal 3 2", "t 3 0 1", "uniform 0 1"});
  for (const auto& trials : {std::optional<std::size_t>{}, std::optional<std::size_t>{123'457}}) {
    const auto with = [&](unsigned threads) {
      return run(model, 3, {.trials = trials, .trials_max = 400'000, .digits = 1, .threads = threads});
    };
    const MonteCarloResult one = with(1);
    expect_same(one, with(2));
    expect_same(one, with(7));
  }
}

TEST(MonteCarlo, AgreesWithWhatIsKnownOfEachDistribution) {
  const std::vector<std::string_view> texts{"normal 3 2", "t 5 0 1", "uniform 0 1", "arcsine -1 1", "triangular 0 4"};
  const MonteCarloResult result = run(drawn_from(texts), texts.size(), {.trials = 300'000});
  for (std::size_t k = 0; k < texts.size(); ++k) {
    SCOPED_TRACE(texts[k]);
    const Distribution exact = Distribution::parse(texts[k]).value();
    const OutputSummary& out = result.outputs[k];
    EXPECT_NEAR(out.mean, exact.mean(), 4 * out.mean_error);
    EXPECT_NEAR(out.sd, *exact.standard_deviation(), 4 * out.sd_error);
    EXPECT_NEAR(out.symmetric.lower, exact.quantile(0.025), 4 * out.symmetric_error.lower);
    EXPECT_NEAR(out.symmetric.upper, exact.quantile(0.975), 4 * out.symmetric_error.upper);
    EXPECT_NEAR(out.distribution.probability_below(exact.quantile(0.3)), 0.3, 4 * std::sqrt(0.21 / 300'000));
    EXPECT_NEAR(out.shortest.upper - out.shortest.lower, out.symmetric.upper - out.symmetric.lower,
                0.04 * out.sd + (texts[k].starts_with("arcsine") ? 1.0 : 0.0));
  }
}

TEST(MonteCarlo, StatesStandardErrorsThatAreTrue) {
  // The scatter of forty runs against what each run states; 40 values give the scatter to 11 %.
  for (const bool adaptive : {false, true}) {
    std::vector<double> means, sds, lowers;
    OutputSummary last;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
      const BlockModel model = drawn_from({"uniform -1 1"}, seed);
      PropagationOptions options{.trials_max = 100'000, .threads = 1};
      if (!adaptive) options.trials = 20'000;
      MonteCarloResult result = run(model, 1, options);
      means.push_back(result.outputs[0].mean);
      sds.push_back(result.outputs[0].sd);
      lowers.push_back(result.outputs[0].symmetric.lower);
      if (seed == 1) last = std::move(result.outputs[0]);
    }
    const double blocks_are_few = adaptive ? 0.8 : 0.4;  // ten blocks give their scatter to 24 %
    const auto scatter = [](const std::vector<double>& x) { return numeric::moments(x).standard_deviation; };
    EXPECT_NEAR(last.mean_error / scatter(means), 1.0, blocks_are_few);
    EXPECT_NEAR(last.sd_error / scatter(sds), 1.0, blocks_are_few);
    EXPECT_NEAR(last.symmetric_error.lower / scatter(lowers), 1.0, blocks_are_few);
  }
}

TEST(MonteCarlo, GoesOnUntilTheDigitsAskedForAreStable) {
  const BlockModel model = drawn_from({"normal 0 1"});
  const MonteCarloResult one = run(model, 1, {.digits = 1});
  EXPECT_TRUE(one.adaptive);
  EXPECT_TRUE(one.outputs[0].stable);
  EXPECT_EQ(one.trials, 100'000u);
  const MonteCarloResult two = run(model, 1, {.digits = 2});
  EXPECT_TRUE(two.outputs[0].stable);
  EXPECT_EQ(two.trials % block_size, 0u);
  // An end point of the interval has a standard error of 2.67/√M: 2·2.67/√M = 0.05 at M = 11 400 for u = 1.0; u just
  // below 1 is 0.99 or so, with a δ of 0.005 and a hundred times as many trials.
  EXPECT_LE(two.trials, 3'000'000u);
}

TEST(MonteCarlo, EndsUnstableWhereItMayNotGoOn) {
  const MonteCarloResult result =
      run(drawn_from({"normal 0 0.5", "constant 4"}), 2, {.trials_max = 155'000, .digits = 3});
  EXPECT_EQ(result.trials, 155'000u);
  EXPECT_FALSE(result.outputs[0].stable);
  EXPECT_TRUE(result.outputs[1].stable);
}

TEST(MonteCarlo, TakesAnOutputThatIsConstant) {
  for (const std::string_view text : {"constant 0", "constant -7.25", "constant 1e-200", "constant 3e140"}) {
    const MonteCarloResult result = run(drawn_from({text}), 1, {.trials = 20'000});
    const OutputSummary& out = result.outputs[0];
    const double value = Distribution::parse(text)->mean();
    EXPECT_EQ(out.mean, value);
    EXPECT_EQ(out.sd, 0.0);
    EXPECT_EQ(out.symmetric.lower, value);
    EXPECT_EQ(out.shortest.upper, value);
    EXPECT_EQ(out.symmetric_error.lower, 0.0);
    EXPECT_EQ(out.histogram.counts, std::vector<std::uint64_t>{20'000});
    EXPECT_EQ(out.distribution.probability_below(value), 1.0);
    EXPECT_EQ(out.distribution.probability_below(std::nextafter(value, -1e300)), 0.0);
  }
}

TEST(MonteCarlo, TakesAnOutputWhoseFirstBlockTellsNothing) {
  const BlockModel late = [](std::uint64_t block, BlockOutputs outputs) {
    std::iota(outputs.values.begin(), outputs.values.end(), 1e4 * static_cast<double>(block));
    if (block == 0) std::ranges::fill(outputs.values, 0.0);
  };
  const MonteCarloResult result = run(late, 1, {.trials = 40'000});
  const OutputSummary& out = result.outputs[0];
  EXPECT_NEAR(out.symmetric.upper, 39'000, 0.03 * 39'000);  // outside the core cells are 3 % wide
  EXPECT_EQ(out.distribution.quantile(1.0), 39'999);
  EXPECT_NEAR(out.distribution.quantile(0.1), 0.0, 1e-200);
}

TEST(MonteCarlo, TakesValuesThatLieOnTheEdgesOfItsCells) {
  // As of resampled readings: few values, and beside them what the order of additions makes of them.
  for (int place = 1; place <= 200; ++place) {
    const double least = 0.1 * place, most = 0.3 * place;
    const std::array few{least, std::nextafter(least, most), std::nextafter(most, least), most};
    const BlockModel model = [&few](std::uint64_t, BlockOutputs outputs) {
      const std::span<double> values = outputs.row(0);
      for (std::size_t i = 0; i < values.size(); ++i) values[i] = few[i % few.size()];
    };
    const OutputSummary out = run(model, 1, {.trials = 400}).outputs[0];
    EXPECT_EQ(out.distribution.trials(), 400u);
    EXPECT_EQ(out.distribution.quantile(0.0), least);
    EXPECT_EQ(out.distribution.quantile(1.0), most);
  }
}

TEST(MonteCarlo, KeepsTailsThatAreFarAway) {
  const Distribution cauchy = Distribution::parse("t 1 0 1").value();
  const MonteCarloResult result = run(drawn_from({"t 1 0 1"}), 1, {.trials = 1'000'000, .coverage = 0.9999});
  const OutputSummary& out = result.outputs[0];
  EXPECT_NEAR(out.symmetric.upper / cauchy.quantile(0.99995), 1.0, 4 / std::sqrt(50));
  EXPECT_EQ(out.distribution.trials(), 1'000'000u);
}

TEST(MonteCarlo, FindsTheShortestIntervalOfASkewDistribution) {
  // Exponential: from 0 to −ln 0.05. Validation: closed form.
  const BlockModel exponential = [](std::uint64_t block, BlockOutputs outputs) {
    numeric::fill_uniform({1, 0, block}, outputs.values);
    for (double& x : outputs.values) x = -std::log(x);
  };
  const MonteCarloResult result = run(exponential, 1, {.trials = 500'000});
  EXPECT_NEAR(result.outputs[0].shortest.lower, 0.0, 1e-4);
  EXPECT_NEAR(result.outputs[0].shortest.upper, -std::log(0.05), 4 * std::sqrt(19 / 500'000.));
}

TEST(MonteCarlo, DrawsItsHistogramOverTheInterestingPart) {
  const MonteCarloResult result = run(drawn_from({"normal 0 1"}), 1, {.trials = 100'000});
  const Histogram& h = result.outputs[0].histogram;
  EXPECT_NEAR(h.lower, -3.3, 0.2);
  EXPECT_NEAR(h.lower + h.width * static_cast<double>(h.counts.size()), 3.3, 0.2);
  EXPECT_GE(h.counts.size(), 60u);
  EXPECT_LE(h.counts.size(), 81u);
  const auto sum = std::accumulate(h.counts.begin(), h.counts.end(), std::uint64_t{0});
  EXPECT_NEAR(static_cast<double>(sum), 99'900, 60);
}

TEST(MonteCarlo, StopsWhenItIsTold) {
  const BlockModel slow = [](std::uint64_t, BlockOutputs outputs) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    std::ranges::fill(outputs.values, 1.0);
  };
  std::size_t seen = 0;
  const auto result = propagate(slow, 1, {.trials = 100'000'000, .threads = 2, .on_progress = [&](const Progress& p) {
                                            seen = p.trials;
                                            EXPECT_EQ(p.of, 100'000'000u);
                                            return false;
                                          }});
  ASSERT_FALSE(result);
  EXPECT_TRUE(result.error().message.starts_with("stopped after ")) << result.error().message;
  EXPECT_GT(seen, 0u);
}

TEST(MonteCarlo, NamesTheFirstValueThatIsNotFinite) {
  const BlockModel spoils = [](std::uint64_t block, BlockOutputs outputs) {
    std::ranges::fill(outputs.values, 1.0);
    if (block >= 3) outputs.values[7] = block == 3 ? NAN : 1e200;
  };
  for (const unsigned threads : {1u, 4u})
    EXPECT_EQ(error_of(spoils, {.trials = 200'000, .threads = threads}),
              "found the value nan of output 1 in trial 30008, expected a finite one of at most 1e150");
  const BlockModel at_once = [](std::uint64_t, BlockOutputs outputs) { std::ranges::fill(outputs.values, INFINITY); };
  EXPECT_EQ(error_of(at_once, {}),
            "found the value inf of output 1 in trial 1, expected a finite one of at most 1e150");
}

TEST(MonteCarlo, HandsOnWhatTheModelThrows) {
  const BlockModel throws = [](std::uint64_t block, BlockOutputs outputs) {
    std::ranges::fill(outputs.values, 1.0);
    if (block == 5) throw std::runtime_error("no");
  };
  EXPECT_THROW(static_cast<void>(propagate(throws, 1, {.trials = 200'000, .threads = 3})), std::runtime_error);
}

TEST(MonteCarlo, RefusesOptionsThatMakeNoSense) {
  const BlockModel model = drawn_from({"constant 0"});
  EXPECT_EQ(error_of(model, {.trials = 99}), "found 99 trials, expected at least 100");
  EXPECT_EQ(error_of(model, {.trials = 5'000'000'000}), "found 5000000000 trials, expected at most 4000000000");
  EXPECT_EQ(error_of(model, {.trials_max = 10}), "found 10 trials, expected at least 100");
  EXPECT_EQ(error_of(model, {.coverage = 1.0}), "found the coverage probability 1, expected one between 0 and 1");
  EXPECT_EQ(error_of(model, {.digits = 5}), "found 5 significant digits, expected 1 to 4");
}

TEST(NumericalTolerance, IsHalfAUnitOfTheLastDigit) {
  EXPECT_DOUBLE_EQ(numerical_tolerance(0.00035, 2), 0.5e-5);  // the examples of 7.9.2: 0.35 g and 2 K
  EXPECT_DOUBLE_EQ(numerical_tolerance(2.0, 1), 0.5);
  EXPECT_DOUBLE_EQ(numerical_tolerance(9.94, 2), 0.05);
  EXPECT_DOUBLE_EQ(numerical_tolerance(9.96, 2), 0.5);
  EXPECT_DOUBLE_EQ(numerical_tolerance(1000.0, 2), 50.0);
  EXPECT_DOUBLE_EQ(numerical_tolerance(0.0, 2), 0.0);
}

}  // namespace
}  // namespace axiometry::uncertainty
