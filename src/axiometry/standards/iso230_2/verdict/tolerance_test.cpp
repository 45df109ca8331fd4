// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/verdict/tolerance.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "axiometry/model/fields.h"
#include "tests/support/series.h"

namespace axiometry::iso230_2 {
namespace {

using uncertainty::DecisionRule;
using uncertainty::Verdict;
using Kind = DecisionRule::Kind;

Tolerance limit(std::string_view key, double um) { return {find_parameter(key), Deviation::native(um)}; }

AxisParameters measured() {
  AxisParameters p;
  p.A = Deviation::native(10);
  p.B_mean = Deviation::native(-3);
  return p;
}

/// The same u for every parameter.
JudgedWith all_with(double u) {
  const AxisParameters values = measured();
  JudgedWith with;
  for (std::size_t k = 0; k < std::size(parameters); ++k) {
    const auto& value = values.*parameters[k].member;
    const double x = value ? value->in_native() : 0.0;
    with.uncertainties[k] = ParameterUncertainty{
        {UncertaintyMethod::annex_a, {}, Deviation::native(u), Deviation::native(2 * u), {x - 2 * u, x + 2 * u}},
        uncertainty::Belief::normal(x, u)};
  }
  return with;
}

Verdict verdict(std::string_view key, double um, DecisionRule rule, const JudgedWith& with) {
  const Tolerance one[] = {limit(key, um)};
  return judge(measured(), one, rule, with).front().decision.verdict;
}

TEST(Judge, ComparesMagnitudesAndTakesTheLimitItselfForConforming) {
  EXPECT_EQ(verdict("A", 10, {}, {}), Verdict::conforms);
  EXPECT_EQ(verdict("A", 9.99, {}, {}), Verdict::does_not_conform);
  EXPECT_EQ(verdict("B_mean", 2, {}, {}), Verdict::does_not_conform);
  EXPECT_EQ(verdict("B_mean", 3, {}, {}), Verdict::conforms);
}

TEST(Judge, HasNoVerdictOnWhatDoesNotExist) {
  const Tolerance limits[] = {limit("R", 1e6)};
  const auto judgements = judge({}, limits, {Kind::iso_14253_1}, all_with(1));
  EXPECT_EQ(judgements[0].decision.verdict, Verdict::not_applicable);
  EXPECT_FALSE(judgements[0].decision.probability_conforming);
  EXPECT_FALSE(judgements[0].acceptance_limit());
}

TEST(Judge, LeavesFivePercentOfRiskOnBothSidesUnderIso14253) {
  const DecisionRule rule{Kind::iso_14253_1};
  EXPECT_EQ(verdict("A", 11.645, rule, all_with(1)), Verdict::conforms);
  EXPECT_EQ(verdict("A", 11.644, rule, all_with(1)), Verdict::undecided);
  EXPECT_EQ(verdict("A", 8.356, rule, all_with(1)), Verdict::undecided);
  EXPECT_EQ(verdict("A", 8.355, rule, all_with(1)), Verdict::does_not_conform);
  const Tolerance one[] = {limit("A", 12)};
  const Judgement judgement = judge(measured(), one, rule, all_with(2)).front();
  EXPECT_NEAR(judgement.acceptance_limit()->in_native(), 12 - 3.2897072539, 1e-9);  // 2 · 1.6448536270
  EXPECT_NEAR(judgement.rejection_limit()->in_native(), 12 + 3.2897072539, 1e-9);
}

TEST(Judge, DecidesNothingUnderIso14253WithoutUncertainty) {
  const Tolerance one[] = {limit("A", 1000)};
  const Judgement judgement = judge(measured(), one, {Kind::iso_14253_1}, {}).front();
  EXPECT_EQ(judgement.decision.verdict, Verdict::undecided);
  EXPECT_FALSE(judgement.acceptance_limit());
  EXPECT_FALSE(judgement.rejection_limit());
}

TEST(Judge, HasNoAcceptanceLimitWhereTheGuardBandIsWiderThanTheTolerance) {
  const Tolerance one[] = {limit("A", 3)};
  const Judgement judgement = judge(measured(), one, {Kind::iso_14253_1}, all_with(4)).front();
  EXPECT_EQ(judgement.decision.verdict, Verdict::does_not_conform);  // 10 > 3 + 6.58
  EXPECT_FALSE(judgement.acceptance_limit());
  EXPECT_NEAR(judgement.rejection_limit()->in_native(), 9.5794145080, 1e-9);
}

// Φ(1) and Φ(−1) to ten digits, from tables.
TEST(Judge, GivesTheProbabilityOfConformityOfANormalDistribution) {
  const Tolerance limits[] = {limit("A", 12), limit("A", 8)};
  const auto judgements = judge(measured(), limits, {}, all_with(2));
  EXPECT_NEAR(*judgements[0].decision.probability_conforming, 0.8413447461, 1e-10);
  EXPECT_NEAR(*judgements[0].decision.consumer_risk, 0.1586552539, 1e-10);
  EXPECT_NEAR(*judgements[1].decision.producer_risk, 0.1586552539, 1e-10);
  EXPECT_FALSE(judgements[1].decision.consumer_risk);
}

// P(−3 ≤ X ≤ 3) for X normal about −3 with u = 3 is Φ(2) − Φ(0).
TEST(Judge, CountsBothSignsOfTheMeanReversalError) {
  const Tolerance one[] = {limit("B_mean", 3)};
  EXPECT_NEAR(*judge(measured(), one, {}, all_with(3)).front().decision.probability_conforming, 0.4772498681, 1e-10);
  EXPECT_EQ(judge(measured(), one, {}, all_with(0)).front().decision.probability_conforming, 1.0);
}

/// Uniform from −5 to 15 in two cells.
uncertainty::SampledDistribution uniform_from_minus_5_to_15() {
  return uncertainty::SampledDistribution({{-5, 5, 0, 1000}, {5, 15, 1000, 1000}});
}

TEST(Judge, TakesTheProbabilityFromADistributionWhereThereIsOne) {
  const auto uniform = uniform_from_minus_5_to_15();
  JudgedWith with = all_with(5.77);
  for (auto& known : with.uncertainties)
    known->belief = uncertainty::Belief::sampled(known->belief.value(), {{&uniform}});
  const Tolerance limits[] = {limit("A", 12), limit("B_mean", 4)};
  const auto judgements = judge(measured(), limits, {}, with);
  EXPECT_NEAR(judgements[0].decision.probability_range->least, 0.85, 1e-12);
  EXPECT_NEAR(judgements[1].decision.probability_range->least, 0.4, 1e-12);  // −4 to 4 of 20
  EXPECT_NEAR(*judgements[1].decision.consumer_risk, 0.6, 1e-12);
}

TEST(Judge, HasNoLimitsToShowForAGuardBandWithoutUncertainty) {
  const Tolerance one[] = {limit("A", 1000)};
  const Judgement judgement = judge(measured(), one, {Kind::guard_band, 2.0}, {}).front();
  EXPECT_EQ(judgement.decision.verdict, Verdict::undecided);
  EXPECT_FALSE(judgement.acceptance_limit());
}

TEST(Judge, DecidesNothingByAnUncertaintyThatDoesNotHoldWhatItStates) {
  JudgedWith with = all_with(0.1);
  for (auto& known : with.uncertainties) known->doubt = "it holds the truth less often";
  for (const double um : {5.0, 20.0}) {  // far from 10 on both sides
    const Tolerance one[] = {limit("A", um)};
    for (const DecisionRule rule : {DecisionRule{Kind::iso_14253_1}, DecisionRule{Kind::guard_band, 1.0}}) {
      const Judgement judgement = judge(measured(), one, rule, with).front();
      EXPECT_EQ(judgement.decision.verdict, Verdict::undecided);
      EXPECT_EQ(judgement.withheld, "it holds the truth less often");
      EXPECT_FALSE(judgement.decision.probability_range);
      EXPECT_FALSE(judgement.rejection_limit());
      EXPECT_TRUE(judgement.uncertainty) << "stated as before";
    }
    // Simple acceptance asks for no uncertainty; the probability beside it does.
    const Judgement simple = judge(measured(), one, {Kind::simple}, with).front();
    EXPECT_EQ(simple.decision.verdict, um > 10 ? Verdict::conforms : Verdict::does_not_conform);
    EXPECT_EQ(simple.withheld, "");
    EXPECT_FALSE(simple.decision.probability_range);
  }
}

TEST(Judge, FindsTheWorstOfAllVerdicts) {
  const auto of = [](std::vector<Tolerance> limits) {
    return overall_verdict(judge(measured(), limits, {Kind::iso_14253_1}, all_with(1)));
  };
  EXPECT_EQ(of({}), std::nullopt);
  EXPECT_EQ(of({limit("R", 1)}), Verdict::not_applicable);
  EXPECT_EQ(of({limit("A", 20)}), Verdict::conforms);
  EXPECT_EQ(of({limit("R", 1), limit("A", 20)}), Verdict::undecided);  // R does not exist
  EXPECT_EQ(of({limit("R", 1), limit("A", 2)}), Verdict::does_not_conform);
  EXPECT_EQ(of({limit("A", 10), limit("A", 20)}), Verdict::undecided);
  EXPECT_EQ(of({limit("A", 10), limit("A", 20), limit("A", 2)}), Verdict::does_not_conform);
}

/// 5 µm on lengths, nothing on what repeats.
UncorrectedEffect expansion(double um) {
  return {"expansion", "thermal expansion, about 5 µm over the travel,", Deviation::native(um), Deviation::native(0),
          "the correction for thermal expansion",
          {{"nde"}, {}}};
}

TEST(Judge, WithholdsEveryVerdictOnAValueThatHoldsAnUncorrectedEffect) {
  const UncorrectedEffect effects[] = {expansion(5)};
  JudgedWith with = all_with(0.1);
  with.uncorrected = effects;
  for (const double um : {2.0, 9.0, 20.0}) {
    for (const Kind kind : {Kind::simple, Kind::iso_14253_1, Kind::guard_band}) {
      const Tolerance one[] = {limit("A", um)};
      const Judgement judgement = judge(measured(), one, {kind}, with).front();
      EXPECT_EQ(judgement.decision.verdict, Verdict::undecided);
      EXPECT_FALSE(judgement.decision.probability_conforming);
      EXPECT_FALSE(judgement.decision.probability_range);
      EXPECT_FALSE(judgement.acceptance_limit());
      EXPECT_FALSE(judgement.rejection_limit());
      EXPECT_EQ(judgement.withheld,
                "thermal expansion, about 5 µm over the travel, is neither corrected nor in the uncertainty; the "
                "correction for thermal expansion mends that");
      EXPECT_THAT(judgement.remedy.corrections, ::testing::ElementsAre("nde"));
      EXPECT_TRUE(judgement.remedy.fields.empty());
    }
  }
  EXPECT_EQ(verdict("B_mean", 3.5, {Kind::iso_14253_1}, with), Verdict::conforms);  // does not act on it
}

/// Table 2 of the standard without the readings ↑ at its last target.
Evaluation without_last_up() {
  auto up = testing_support::table2::up;
  for (auto& run : up) run.back() = testing_support::none;
  return evaluate(testing_support::make_series(testing_support::table2::targets, up, testing_support::table2::down));
}

TEST(Judge, NeverFindsThatALowerBoundConforms) {
  const Evaluation part = without_last_up();
  JudgedWith with;
  with.lower_bounds = lower_bounds(part);
  for (const std::string_view key : {"A", "A_up", "E", "E_up", "M", "R", "R_up", "B", "B_mean"}) {
    for (const Kind kind : {Kind::simple, Kind::iso_14253_1, Kind::guard_band}) {
      const Tolerance one[] = {limit(key, 1000)};
      const Judgement judgement = judge(part.parameters, one, {kind}, with).front();
      EXPECT_EQ(judgement.decision.verdict, Verdict::undecided) << key;
      EXPECT_FALSE(judgement.decision.probability_range) << key;
      EXPECT_FALSE(judgement.acceptance_limit()) << key;
      EXPECT_TRUE(judgement.withheld.starts_with("readings are missing at 1 of 11 targets")) << judgement.withheld;
    }
  }
  for (const std::string_view key : {"A_down", "E_down", "R_down"}) {
    const Tolerance one[] = {limit(key, 1000)};
    EXPECT_EQ(judge(part.parameters, one, {}, with).front().decision.verdict, Verdict::conforms) << key;
  }
}

TEST(Judge, LetsALowerBoundExceedItsLimitButNotTheMeanOfAPart) {
  const Evaluation part = without_last_up();
  JudgedWith with;
  with.lower_bounds = lower_bounds(part);
  const Tolerance limits[] = {limit("A", 0.5), limit("E", 0.5), limit("B_mean", 0.5)};
  const auto judgements = judge(part.parameters, limits, {}, with);
  EXPECT_EQ(judgements[0].decision.verdict, Verdict::does_not_conform);
  EXPECT_EQ(judgements[1].decision.verdict, Verdict::does_not_conform);
  EXPECT_EQ(judgements[2].decision.verdict, Verdict::undecided);
  EXPECT_EQ(judgements[2].withheld, "readings are missing at 1 of 11 targets, and the others give the mean of a part");
}

TEST(LowerBounds, AreWhatLacksTheTermsThatItIsTakenFrom) {
  auto up = testing_support::table2::up;
  for (std::size_t run = 1; run < up.size(); ++run) up[run][3] = testing_support::none;  // a single reading is left
  const auto bounds = lower_bounds(
      evaluate(testing_support::make_series(testing_support::table2::targets, up, testing_support::table2::down)));
  for (std::size_t k = 0; k < std::size(parameters); ++k) {
    const std::string_view key = parameters[k].key;
    const bool is_one = key == "A" || key == "A_up" || key == "R" || key == "R_up";
    EXPECT_EQ(!bounds[k].empty(), is_one) << key;
  }
  for (const std::string& bound : lower_bounds(evaluate(testing_support::table2::series()))) EXPECT_EQ(bound, "");
  const auto up_only = testing_support::make_series(testing_support::table2::targets, testing_support::table2::up, {});
  for (const std::string& bound : lower_bounds(evaluate(up_only))) EXPECT_EQ(bound, "");
}

TEST(Judge, PassesOverAnEffectThatIsSmallAndCouldTurnNothing) {
  const UncorrectedEffect effects[] = {expansion(0.09)};
  JudgedWith with = all_with(0.1);
  with.uncorrected = effects;
  EXPECT_EQ(verdict("A", 20, {}, with), Verdict::conforms);
  EXPECT_EQ(verdict("A", 10.05, {}, with), Verdict::undecided);  // 10.09 would not conform
  EXPECT_EQ(verdict("A", 9.95, {}, with), Verdict::undecided);
  const UncorrectedEffect of_unknown_size[] = {
      {"sign", "the reversed sign of the instrument", {}, {}, "--correct sign"}};
  with.uncorrected = of_unknown_size;
  EXPECT_EQ(verdict("A", 20, {}, with), Verdict::undecided);
  EXPECT_EQ(verdict("B_mean", 20, {}, with), Verdict::undecided);
}

TEST(MergedLimits, AreOfEachParameterTheOneOfTheHighestAuthorityAndRememberTheOthers) {
  const auto from = [](std::string_view key, double um, ToleranceSource source) {
    return Tolerance{find_parameter(key), Deviation::native(um), source};
  };
  using enum ToleranceSource;
  std::vector<Tolerance> all = {from("A", 8, axis), from("B", 5, axis)};
  all = merged_limits(std::move(all), std::vector{from("A", 9, test), from("E", 4, test)});
  all = merged_limits(std::move(all), std::vector{from("A", 10, user)});
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0].limit.in_native(), 10);
  ASSERT_EQ(all[0].replaced.size(), 2u);
  EXPECT_EQ(all[0].replaced[0].source, axis);
  EXPECT_EQ(all[0].replaced[1].limit.in_native(), 9);
  EXPECT_EQ(all[1].limit.in_native(), 5);  // B of the axis stays
  EXPECT_EQ(all[1].source, axis);
  EXPECT_EQ(all[2].source, test);
}

TEST(StatedTolerances, FollowTheMetadataForEveryParameter) {
  Metadata metadata;
  EXPECT_TRUE(stated_tolerances(metadata).empty());
  for (const ParameterInfo& parameter : parameters)
    ASSERT_TRUE(set_field_text(metadata, std::string("tolerance.").append(parameter.key), "12.5"));
  const auto tolerances = stated_tolerances(metadata);
  ASSERT_EQ(tolerances.size(), std::size(parameters));
  for (std::size_t k = 0; k < tolerances.size(); ++k) {
    EXPECT_EQ(tolerances[k].parameter, &parameters[k]);
    EXPECT_EQ(tolerances[k].limit.in_native(), 12.5);
    EXPECT_EQ(tolerances[k].source, ToleranceSource::test);
  }
}

}  // namespace
}  // namespace axiometry::iso230_2
