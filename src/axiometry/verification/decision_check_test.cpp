// SPDX-License-Identifier: Apache-2.0
#include "axiometry/verification/decision_check.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace axiometry::verification {
namespace {

/// A decision about a parameter with a value, as a result states it.
struct Stated {
  std::string_view parameter = "E";
  double value = 8.0;
  double limit = 10.0;
  double u = 1.0;
  std::string_view rule = "iso14253-1";
  std::string_view method = "annex_a";
  std::optional<double> guard_band{};
  std::optional<double> probability{};
  bool withheld = false;
  std::vector<ExactPosition> positions{};
  std::string_view type_a{};
};

bool agrees(const Stated& stated, std::string_view verdict, const Drawn& drawn = {}) {
  json::Value row = json::Value::object();
  row.add("parameter", stated.parameter);
  row.add("limit", stated.limit);
  row.add("verdict", verdict);
  row.add("rule", stated.rule);
  row.add("u", stated.u > 0.0 ? json::Value(stated.u) : json::Value());
  row.add("u_method", stated.method);
  if (stated.guard_band) row.add("guard_band", *stated.guard_band);
  if (stated.probability) row.add("probability_conforming", *stated.probability);
  if (stated.withheld) row.add("withheld", "uncorrected temperature");
  const json::Value rows = json::Value::array({row});
  ExactParameters measured;
  of(measured, *parameter_of_key(stated.parameter)) = Interval::of(stated.value);
  const Interval rounding = Interval::of(1e-13);
  Ledger ledger;
  check_decisions(rows, verdict, {measured, rounding, drawn, stated.positions, stated.type_a}, ledger);
  return ledger.agrees();
}

/// The only verdict that is accepted, or all of them.
std::string accepted(const Stated& stated, const Drawn& drawn = {}) {
  std::string all;
  for (const std::string_view verdict : {"conforms", "does not conform", "undecided", "not applicable"})
    if (agrees(stated, verdict, drawn)) all.append(all.empty() ? "" : ", ").append(verdict);
  return all;
}

TEST(DecisionCheck, AsksTheDistributionForNinetyFivePercent) {
  // One-sided 95 % of a normal distribution: 1.644854 u.
  EXPECT_EQ(accepted({.value = 10.0 - 1.6449}), "conforms");
  EXPECT_EQ(accepted({.value = 10.0 - 1.6448}), "undecided");
  EXPECT_EQ(accepted({.value = 10.0}), "undecided");
  EXPECT_EQ(accepted({.value = 10.0 + 1.6448}), "undecided");
  EXPECT_EQ(accepted({.value = 10.0 + 1.6449}), "does not conform");
  EXPECT_EQ(accepted({.value = 3.0, .u = 0.0}), "undecided");
}

TEST(DecisionCheck, KnowsTheProbability) {
  EXPECT_TRUE(agrees({.value = 8.0, .probability = 0.977249868051821}, "conforms"));
  EXPECT_FALSE(agrees({.value = 8.0, .probability = 0.977249868151821}, "conforms"));
}

TEST(DecisionCheck, CountsBothSidesOfTheMeanReversal) {
  EXPECT_EQ(accepted({.parameter = "B_mean", .value = -8.0}), "conforms");
  EXPECT_EQ(accepted({.parameter = "B_mean", .value = -12.0}), "does not conform");
  EXPECT_EQ(accepted({.parameter = "B_mean", .value = 0.0, .limit = 1.8}), "undecided");  // 92.8 %, not 96.4 %
  EXPECT_EQ(accepted({.parameter = "B_mean", .value = 0.0, .limit = 2.0}), "conforms");   // 95.4 %
  EXPECT_EQ(accepted({.parameter = "B_mean", .value = -10.0, .rule = "simple"}), "conforms");
  EXPECT_EQ(accepted({.parameter = "B_mean", .value = -10.0001, .rule = "simple"}), "does not conform");
}

Drawn between(double least, double most) {
  return [=](std::string_view, double, double) -> std::optional<ProbabilityRange> {
    return ProbabilityRange{least, most};
  };
}

TEST(DecisionCheck, TakesTheDistributionThatWasDrawn) {
  EXPECT_EQ(accepted({.value = 9.0, .method = "monte_carlo"}, between(0.969, 0.969)), "conforms");
  EXPECT_EQ(accepted({.value = 5.0, .method = "monte_carlo"}, between(0.907, 0.907)), "undecided");
  EXPECT_EQ(accepted({.value = 11.0, .method = "monte_carlo"}, between(0.03, 0.03)), "does not conform");
}

TEST(DecisionCheck, AsksEveryDistributionAndTheValueItself) {
  EXPECT_EQ(accepted({.value = 9.0, .method = "monte_carlo"}, between(0.6, 0.99)), "undecided");
  EXPECT_EQ(accepted({.value = 11.0, .method = "monte_carlo"}, between(0.01, 0.4)), "undecided");
  EXPECT_EQ(accepted({.value = 11.0, .method = "monte_carlo"}, between(0.969, 0.98)), "undecided");
  EXPECT_EQ(accepted({.value = 9.0, .method = "monte_carlo"}, between(0.01, 0.02)), "undecided");
}

TEST(DecisionCheck, DecidesValuesAtTheirLimit) {
  EXPECT_EQ(accepted({.value = 0.3, .limit = 0.3, .rule = "simple"}), "conforms");
  EXPECT_EQ(accepted({.value = 0.3, .limit = 0.299999999999999, .rule = "simple"}), "does not conform");
  EXPECT_EQ(accepted({.parameter = "A", .value = 0.3, .limit = 0.3, .rule = "simple"}), "conforms");
  // With roots what is within a billionth may count as at the limit.
  EXPECT_EQ(accepted({.parameter = "A", .value = 0.3, .limit = 0.2999999999, .rule = "simple"}),
            "conforms, does not conform");
  EXPECT_EQ(accepted({.parameter = "A", .value = 0.3, .limit = 0.29999, .rule = "simple"}), "does not conform");
}

TEST(DecisionCheck, KeepsAGuardBand) {
  const Stated chosen{.rule = "guard-band", .guard_band = 2.0};
  const auto at = [&](double value) {
    Stated stated = chosen;
    stated.value = value;
    return accepted(stated);
  };
  EXPECT_EQ(at(8.0), "conforms");
  EXPECT_EQ(at(8.0001), "undecided");
  EXPECT_EQ(at(12.0), "undecided");
  EXPECT_EQ(at(12.0001), "does not conform");
}

TEST(DecisionCheck, LeavesOpenWhatIsWithheld) {
  EXPECT_EQ(accepted({.value = 1.0, .withheld = true}), "undecided");
  EXPECT_EQ(accepted({.value = 100.0, .rule = "simple", .withheld = true}), "undecided");
}

TEST(DecisionCheck, DecidesNothingByAnIntervalThatHoldsTooLittle) {
  const auto by = [](std::string_view type_a, Stated stated, double probability) {
    stated.method = "monte_carlo";
    stated.type_a = type_a;
    return accepted(stated, between(probability, probability));
  };
  for (const std::string_view type_a : {"t-scaled", "resampled"}) {
    EXPECT_EQ(by(type_a, {.value = 1.0}, 0.99), "undecided") << type_a;
    EXPECT_EQ(by(type_a, {.value = 100.0}, 0.01), "undecided") << type_a;
    EXPECT_EQ(by(type_a, {.value = 1.0, .rule = "guard-band", .guard_band = 2.0}, 0.99), "undecided") << type_a;
    EXPECT_EQ(by(type_a, {.value = 1.0, .rule = "simple"}, 0.99), "conforms") << type_a;
    EXPECT_EQ(by(type_a, {.value = 1.0, .rule = "simple", .probability = 0.99}, 0.99), "") << type_a;
  }
  EXPECT_EQ(by("t-scaled", {.parameter = "B_mean", .value = 1.0}, 0.99), "conforms");
  EXPECT_EQ(by("resampled", {.parameter = "B_mean", .value = 1.0}, 0.99), "undecided");
  EXPECT_EQ(by("pooled", {.value = 1.0}, 0.99), "conforms");
  EXPECT_EQ(by("", {.value = 1.0}, 0.99), "conforms");
  EXPECT_EQ(accepted({.value = 1.0, .type_a = "resampled"}), "conforms") << "of another method";
}

TEST(DecisionCheck, LeavesOpenWhatOfWhichTermsAreMissing) {
  ExactPosition whole, part;
  whole.up.mean = whole.down.mean = part.down.mean = Interval(1);
  whole.up.s = whole.down.s = part.down.s = Interval(1);
  const std::vector<ExactPosition> gap = {whole, part};
  for (const std::string_view parameter : {"E", "E_up", "A", "R_up", "M", "B", "B_mean"})
    EXPECT_EQ(accepted({.parameter = parameter, .value = 1.0, .rule = "simple", .positions = gap}), "undecided");
  EXPECT_EQ(accepted({.value = 100.0, .rule = "simple", .positions = gap}), "does not conform");
  EXPECT_EQ(accepted({.parameter = "B_mean", .value = 100.0, .rule = "simple", .positions = gap}), "undecided");
  EXPECT_EQ(accepted({.parameter = "E_down", .value = 1.0, .rule = "simple", .positions = gap}), "conforms");
  EXPECT_EQ(accepted({.value = 1.0, .rule = "simple", .positions = {whole, whole}}), "conforms");
}

TEST(DecisionCheck, RefusesRulesThatItDoesNotKnow) { EXPECT_EQ(accepted({.rule = "lenient"}), ""); }

}  // namespace
}  // namespace axiometry::verification
