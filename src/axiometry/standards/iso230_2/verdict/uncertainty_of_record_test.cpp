// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/verdict/uncertainty_of_record.h"

#include <gtest/gtest.h>

#include "tests/support/series.h"

namespace axiometry::iso230_2 {
namespace {

/// Table 2 by all three methods.
Assessment by_all_methods() {
  const axiometry::Test test = testing_support::table2::complete_test();
  Assessment assessment = assess(test);
  assessment.gum = gum(test, assessment.evaluation).value();
  MonteCarloOptions few;
  few.propagation.trials = 10'000;
  few.contribution_trials = 0;
  assessment.monte_carlo = monte_carlo(test, assessment.evaluation, few).value();
  return assessment;
}

TEST(MethodOfRecord, IsTheChosenOne) {
  Assessment assessment = by_all_methods();
  for (const auto method : {UncertaintyMethod::annex_a, UncertaintyMethod::gum, UncertaintyMethod::monte_carlo}) {
    assessment.method_of_record = method;
    EXPECT_EQ(method_of_record(assessment), method);
    for (const auto& known : uncertainties_of_record(assessment)) EXPECT_EQ(known->stated.method, method);
  }
}

TEST(MethodOfRecord, IsMonteCarloThenAnnexAThenTheGumWhereNobodyChose) {
  Assessment assessment = by_all_methods();
  EXPECT_EQ(method_of_record(assessment), UncertaintyMethod::monte_carlo);
  assessment.monte_carlo.reset();
  EXPECT_EQ(method_of_record(assessment), UncertaintyMethod::annex_a);
  assessment.annex_a.reset();
  EXPECT_EQ(method_of_record(assessment), UncertaintyMethod::gum);
  assessment.gum.reset();
  EXPECT_EQ(method_of_record(assessment), std::nullopt);
}

TEST(UncertaintyOfRecord, IsNeverFilledUpFromAnotherMethod) {
  Assessment assessment = by_all_methods();
  assessment.monte_carlo->distributions[1].reset();  // as for a parameter that the method knows nothing about
  const auto all = uncertainties_of_record(assessment);
  EXPECT_TRUE(all[0]);
  EXPECT_FALSE(all[1]);
  assessment.method_of_record = UncertaintyMethod::gum;
  assessment.gum.reset();
  for (const auto& known : uncertainties_of_record(assessment)) EXPECT_FALSE(known);
}

TEST(UncertaintyOfRecord, OfZeroIsNone) {
  axiometry::Test test = testing_support::table2::complete_test();
  test.metadata.uncertainty.environmental_variation = Deviation::native(0);
  const Assessment assessment = assess(test);
  ASSERT_EQ((assessment.annex_a->U.*find_parameter("R")->member)->in_native(), 0.0);
  const auto all = uncertainties_of_record(assessment);
  const std::size_t R = index_of(*find_parameter("R"));
  EXPECT_FALSE(all[R]);
  EXPECT_TRUE(all[index_of(*find_parameter("A"))]) << "the device acts on it";
  EXPECT_EQ(refusals_of_record(assessment)[R],
            "the method of record, Annex A, finds an uncertainty of 0 of R, which is none");
}

TEST(UncertaintyOfRecord, OfAnnexAIsTheValueAndItsExpandedUncertainty) {
  const Assessment assessment = assess(testing_support::table2::complete_test());
  for (const ParameterInfo& parameter : parameters) {
    const auto known = uncertainty_of_record(assessment, parameter);
    ASSERT_TRUE(known) << parameter.key;
    const double U = (assessment.annex_a->U.*parameter.member)->in_native();
    const double value = (assessment.evaluation.parameters.*parameter.member)->in_native();
    EXPECT_DOUBLE_EQ(known->u.in_native(), U / 2);
    EXPECT_DOUBLE_EQ(known->U->in_native(), U);
    EXPECT_DOUBLE_EQ(known->interval.lower, value - U);
    EXPECT_DOUBLE_EQ(known->interval.upper, value + U);
  }
}

TEST(UncertaintyOfRecord, OfMonteCarloIsAnIntervalThatHoldsTheMeasuredValue) {
  const Assessment assessment = by_all_methods();
  for (const ParameterInfo& parameter : parameters) {
    const auto known = uncertainty_of_record(assessment, parameter);
    const double value = (assessment.evaluation.parameters.*parameter.member)->in_native();
    EXPECT_FALSE(known->U);
    EXPECT_LE(known->interval.lower, value) << parameter.key;
    EXPECT_GE(known->interval.upper, value) << parameter.key;
  }
}

/// For which parameters a verdict by the Monte Carlo method is refused.
std::string undecided_by(Measurand measurand, TypeA type_a) {
  Assessment assessment = by_all_methods();
  assessment.monte_carlo->measurand = measurand;
  assessment.monte_carlo->type_a = type_a;
  const auto all = uncertainties_of_record(assessment);
  std::string keys;
  for (std::size_t k = 0; k < std::size(parameters); ++k)
    if (!all[k]->doubt.empty()) keys.append(keys.empty() ? "" : " ").append(parameters[k].key);
  return keys;
}

/// docs/studies/coverage.md, "This machine": what held the truth less often than in 95 % of tests at some s/u.
TEST(UncertaintyOfRecord, IsDoubtedOfParametersThatASamplingOfRunsWasSeenToMiss) {
  constexpr std::string_view all_but_B_mean = "A A_up A_down E E_up E_down M R R_up R_down B";
  EXPECT_EQ(undecided_by(Measurand::this_machine, TypeA::t_scaled), all_but_B_mean);
  EXPECT_EQ(undecided_by(Measurand::this_machine, TypeA::resampled), std::string(all_but_B_mean) + " B_mean");
  EXPECT_EQ(undecided_by(Measurand::this_machine, TypeA::pooled), "");
  EXPECT_EQ(undecided_by(Measurand::this_test, TypeA::t_scaled), "") << "nothing is sampled for a test that was made";
}

TEST(UncertaintyOfRecord, IsAbsentWhereNoneWasEstimated) {
  for (const auto& known : uncertainties_of_record(assess({{}, testing_support::table2::series(), {}})))
    EXPECT_FALSE(known);
}

}  // namespace
}  // namespace axiometry::iso230_2
