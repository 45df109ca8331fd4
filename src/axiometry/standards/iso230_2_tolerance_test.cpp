// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2_tolerance.h"

#include <gtest/gtest.h>

#include "axiometry/model/fields.h"
#include "tests/support/series.h"

namespace axiometry::iso230_2 {
namespace {

using uncertainty::DecisionRule;
using uncertainty::Verdict;
using Kind = DecisionRule::Kind;

Tolerance limit(std::string_view key, double um) { return {find_parameter(key), Deviation::native(um)}; }

/// The same u for every parameter.
ParameterUncertainties all_with(double u) {
  ParameterUncertainties all;
  all.fill(ParameterUncertainty{{Deviation::native(u), UncertaintyMethod::annex_a}});
  return all;
}

AxisParameters measured() {
  AxisParameters p;
  p.A = Deviation::native(10);
  p.B_mean = Deviation::native(-3);
  return p;
}

Verdict verdict(std::string_view key, double um, DecisionRule rule, const ParameterUncertainties& uncertainties) {
  const Tolerance one[] = {limit(key, um)};
  return judge(measured(), one, rule, uncertainties).front().decision.verdict;
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

TEST(Judge, KeepsAGuardBandOf165StandardUncertaintiesOnBothSidesUnderIso14253) {
  const DecisionRule rule{Kind::iso_14253_1};
  EXPECT_EQ(verdict("A", 11.66, rule, all_with(1)), Verdict::conforms);
  EXPECT_EQ(verdict("A", 11.64, rule, all_with(1)), Verdict::undecided);
  EXPECT_EQ(verdict("A", 8.36, rule, all_with(1)), Verdict::undecided);
  EXPECT_EQ(verdict("A", 8.34, rule, all_with(1)), Verdict::does_not_conform);
  const Tolerance one[] = {limit("A", 12)};
  const Judgement judgement = judge(measured(), one, rule, all_with(2)).front();
  EXPECT_DOUBLE_EQ(judgement.acceptance_limit()->in_native(), 12 - 3.3);
  EXPECT_DOUBLE_EQ(judgement.rejection_limit()->in_native(), 12 + 3.3);
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
  EXPECT_EQ(judgement.decision.verdict, Verdict::does_not_conform);  // 10 > 3 + 6.6
  EXPECT_FALSE(judgement.acceptance_limit());
  EXPECT_DOUBLE_EQ(judgement.rejection_limit()->in_native(), 9.6);
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
  ParameterUncertainties uncertainties;
  uncertainties.fill(ParameterUncertainty{{Deviation::native(5.77), UncertaintyMethod::monte_carlo}, &uniform});
  const Tolerance limits[] = {limit("A", 12), limit("B_mean", 4)};
  const auto judgements = judge(measured(), limits, {}, uncertainties);
  EXPECT_NEAR(*judgements[0].decision.probability_conforming, 0.85, 1e-12);
  EXPECT_NEAR(*judgements[1].decision.probability_conforming, 0.4, 1e-12);  // −4 to 4 of 20
  EXPECT_NEAR(*judgements[1].decision.consumer_risk, 0.6, 1e-12);
}

TEST(Judge, HasNoLimitsToShowForAGuardBandWithoutUncertainty) {
  const Tolerance one[] = {limit("A", 1000)};
  const Judgement judgement = judge(measured(), one, {Kind::guard_band, 2.0}, {}).front();
  EXPECT_EQ(judgement.decision.verdict, Verdict::undecided);
  EXPECT_FALSE(judgement.acceptance_limit());
}

TEST(Judge, FindsTheWorstOfAllVerdicts) {
  const auto of = [](std::vector<Tolerance> limits) {
    return overall_verdict(judge(measured(), limits, {Kind::iso_14253_1}, all_with(1)));
  };
  EXPECT_EQ(of({}), std::nullopt);
  EXPECT_EQ(of({limit("R", 1)}), Verdict::not_applicable);
  EXPECT_EQ(of({limit("R", 1), limit("A", 20)}), Verdict::conforms);
  EXPECT_EQ(of({limit("A", 10), limit("A", 20)}), Verdict::undecided);
  EXPECT_EQ(of({limit("A", 10), limit("A", 20), limit("A", 2)}), Verdict::does_not_conform);
}

TEST(DecidingUncertainty, IsHalfTheExpandedOneOfAnnexA) {
  const auto assessment = assess(testing_support::table2::complete_test());
  const auto uncertainties = deciding_uncertainties(assessment);
  for (std::size_t k = 0; k < std::size(parameters); ++k) {
    ASSERT_TRUE(uncertainties[k]) << parameters[k].key;
    EXPECT_EQ(uncertainties[k]->standard.method, UncertaintyMethod::annex_a);
    EXPECT_DOUBLE_EQ(2 * uncertainties[k]->standard.u.in_native(),
                     (assessment.annex_a->U.*parameters[k].member)->in_native());
  }
}

TEST(DecidingUncertainty, PrefersMonteCarloToTheGumAndThatToAnnexA) {
  const axiometry::Test test = testing_support::table2::complete_test();
  Assessment assessment = assess(test);
  assessment.gum = gum(test.metadata, test.series, assessment.evaluation).value();
  for (const auto& uncertainty : deciding_uncertainties(assessment))
    EXPECT_EQ(uncertainty->standard.method, UncertaintyMethod::gum);
  MonteCarloOptions few;
  few.propagation.trials = 10'000;
  few.contribution_trials = 0;
  assessment.monte_carlo = monte_carlo(test.metadata, test.series, assessment.evaluation, few).value();
  assessment.monte_carlo->distributions[1].reset();  // as for a parameter that the method knows nothing about
  const auto uncertainties = deciding_uncertainties(assessment);
  EXPECT_EQ(uncertainties[0]->standard.method, UncertaintyMethod::monte_carlo);
  EXPECT_EQ(uncertainties[0]->distribution, &assessment.monte_carlo->distributions[0]->summary.distribution);
  EXPECT_EQ(uncertainties[0]->standard.u.in_native(), assessment.monte_carlo->distributions[0]->summary.sd);
  EXPECT_EQ(uncertainties[1]->standard.method, UncertaintyMethod::gum);
}

TEST(DecidingUncertainty, IsAbsentWhereNoneWasEstimated) {
  for (const auto& uncertainty : deciding_uncertainties(assess({{}, testing_support::table2::series(), {}})))
    EXPECT_FALSE(uncertainty);
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
