// SPDX-License-Identifier: Apache-2.0
#include "axiometry/uncertainty/conformity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "axiometry/numeric/distributions/normal_and_student_t.h"

namespace axiometry::uncertainty {
namespace {

constexpr DecisionRule simple{DecisionRule::Kind::simple};
constexpr DecisionRule iso{DecisionRule::Kind::iso_14253_1};

MeasuredValue normal(double value, double u) { return {.value = value, .belief = Belief::normal(value, u)}; }

Verdict verdict(double value, double u, const DecisionRule& rule) {
  return decide(normal(value, u), 10.0, rule).verdict;
}

TEST(Conformity, IsDecidedAtTheLimitBySimpleAcceptance) {
  EXPECT_EQ(verdict(10.0, 1.0, simple), Verdict::conforms);
  EXPECT_EQ(verdict(10.001, 1.0, simple), Verdict::does_not_conform);
  EXPECT_EQ(decide({9.0}, 10.0, simple).verdict, Verdict::conforms);
  EXPECT_EQ(decide({9.0}, 10.0, simple).probability_conforming, std::nullopt);
}

TEST(Conformity, IsUndecidedWithinTheGuardBandOnEitherSide) {
  EXPECT_EQ(verdict(8.355, 1.0, iso), Verdict::conforms);
  EXPECT_EQ(verdict(8.356, 1.0, iso), Verdict::undecided);
  EXPECT_EQ(verdict(11.644, 1.0, iso), Verdict::undecided);
  EXPECT_EQ(verdict(11.645, 1.0, iso), Verdict::does_not_conform);
  EXPECT_NEAR(decide(normal(9.0, 0.2), 10.0, iso).guard_band, 0.2 * numeric::normal_quantile(0.95), 1e-14);
  const DecisionRule chosen{DecisionRule::Kind::guard_band, 0.5};
  EXPECT_EQ(verdict(9.5, 1.0, chosen), Verdict::conforms);
  EXPECT_EQ(verdict(9.6, 1.0, chosen), Verdict::undecided);
  EXPECT_EQ(verdict(10.6, 1.0, chosen), Verdict::does_not_conform);
}

TEST(Conformity, IsUndecidedWhereTheUncertaintyIsNotKnown) {
  const Decision decision = decide({1.0}, 10.0, iso);
  EXPECT_EQ(decision.verdict, Verdict::undecided);
  EXPECT_EQ(decision.probability_conforming, std::nullopt);
  EXPECT_EQ(decision.consumer_risk, std::nullopt);
}

TEST(Conformity, HasTheRiskOfWhoeverTheDecisionMayHurt) {
  // JCGM 106:2012, 7.3.2 and 9.3.2: Φ((T − y)/u).
  const Decision accepted = decide(normal(9.0, 0.5), 10.0, simple);
  EXPECT_NEAR(*accepted.probability_conforming, 0.977249868051821, 1e-12);
  EXPECT_NEAR(*accepted.consumer_risk, 0.022750131948179, 1e-12);
  EXPECT_EQ(accepted.producer_risk, std::nullopt);
  const Decision rejected = decide(normal(11.0, 0.5), 10.0, simple);
  EXPECT_NEAR(*rejected.producer_risk, 0.022750131948179, 1e-12);
  EXPECT_EQ(rejected.consumer_risk, std::nullopt);
}

TEST(Conformity, TakesFivePercentRiskAtMostUnderISO14253) {
  const double z = numeric::normal_quantile(0.95);
  EXPECT_LE(*decide(normal(10.0 - z, 1.0), 10.0 + 1e-12, iso).consumer_risk, 0.05);
  EXPECT_GE(*decide(normal(10.0 - z, 1.0), 10.0 + 1e-12, iso).consumer_risk, 0.0499);
}

TEST(Conformity, IsCertainWithoutAnyUncertainty) {
  EXPECT_EQ(decide(normal(10.0, 0.0), 10.0, iso).probability_conforming, 1.0);
  EXPECT_EQ(decide(normal(10.1, 0.0), 10.0, iso).probability_conforming, 0.0);
  EXPECT_EQ(decide(normal(10.1, 0.0), 10.0, iso).verdict, Verdict::does_not_conform);
}

MeasuredValue sampled(double value, const SampledDistribution& distribution) {
  return {.value = value, .belief = Belief::sampled(value, {{&distribution}})};
}

// A distribution that is skewed and shifted: a guard band of 1.645 u about the value would accept it.
TEST(Conformity, RestsOnTheDistributionThatIsStated) {
  const SampledDistribution skewed({{9.0, 9.6, 0, 80}, {9.6, 11.0, 80, 20}});
  const Decision decision = decide(sampled(9.2, skewed), 10.0, iso);
  EXPECT_NEAR(*decision.probability_conforming, 0.8 + 0.2 * 0.4 / 1.4, 1e-12);
  EXPECT_EQ(decision.verdict, Verdict::undecided);
  EXPECT_EQ(decide(sampled(9.2, skewed), 10.7, iso).verdict, Verdict::conforms);
}

// Noise that is taken out of a value may put its whole distribution below the limit that the value exceeds.
TEST(Conformity, IsNeverOfAValueBeyondItsLimit) {
  const SampledDistribution below({{5.0, 6.0, 0, 100}});
  const Decision decision = decide(sampled(6.55, below), 6.2, iso);
  EXPECT_EQ(decision.verdict, Verdict::undecided);
  EXPECT_EQ(decision.probability_range->least, 0.0);
  EXPECT_EQ(decision.probability_range->most, 1.0);
}

TEST(Conformity, AgreesWithItsProbabilityAndItsZonesInEveryCase) {
  for (double y = 6.0; y < 14.0; y += 0.013) {
    const SampledDistribution moved(
        {{y - 0.5, y + 0.1, 0, 300}, {y + 0.1, y + 0.3, 300, 500}, {y + 0.3, y + 2.0, 800, 200}});
    for (const MeasuredValue& measured : {normal(y, 0.7), sampled(y, moved)}) {
      const Decision decision = decide(measured, 10.0, iso);
      const double p = *decision.probability_conforming;
      const double accepted_to = 10.0 - decision.guard_band;
      const double rejected_from = 10.0 + decision.rejection_band;
      EXPECT_EQ(decision.verdict == Verdict::conforms, p >= 0.95) << y;
      EXPECT_EQ(decision.verdict == Verdict::does_not_conform, p <= 1.0 - 0.95) << y;
      if (std::abs(y - accepted_to) > 1e-9) EXPECT_EQ(decision.verdict == Verdict::conforms, y <= accepted_to) << y;
      if (std::abs(y - rejected_from) > 1e-9)
        EXPECT_EQ(decision.verdict == Verdict::does_not_conform, y > rejected_from);
    }
  }
}

TEST(Conformity, NeverTurnsOverWithMoreDoubt) {
  for (const DecisionRule& rule : {simple, iso}) {
    for (const double y : {4.0, 9.0, 9.99, 10.0, 10.01, 11.0, 16.0}) {
      bool accepted = false, rejected = false;
      for (double u = 0.0; u < 20.0; u = u * 1.3 + 0.01) {
        for (const bool either_sign : {false, true}) {
          MeasuredValue measured = normal(y, u);
          measured.either_sign = either_sign;
          const Verdict found = decide(measured, 10.0, rule).verdict;
          accepted = accepted || found == Verdict::conforms;
          rejected = rejected || found == Verdict::does_not_conform;
        }
      }
      EXPECT_FALSE(accepted && rejected) << y;
    }
  }
}

TEST(Conformity, OfAMagnitudeCountsBothSigns) {
  MeasuredValue measured = normal(-3.0, 3.0);
  measured.either_sign = true;
  // P(−3 ≤ Y ≤ 3) is Φ(2) − Φ(0).
  EXPECT_NEAR(*decide(measured, 3.0, iso).probability_conforming, 0.4772498681, 1e-10);
  measured = normal(-1.0, 1.0);
  measured.either_sign = true;
  const Decision decision = decide(measured, 3.0, iso);
  EXPECT_EQ(decision.verdict, Verdict::conforms);
  // At the ends of the zones the probability is the one that decides.
  for (const auto& [at, p] :
       {std::pair{3.0 - decision.guard_band, 0.95}, std::pair{3.0 + decision.rejection_band, 0.05}})
    EXPECT_NEAR(numeric::normal_probability(3.0 - at) - numeric::normal_probability(-3.0 - at), p, 1e-9);
}

TEST(Conformity, OfAMagnitudeHasNoZoneOfAcceptanceWhereTheDoubtIsTooLarge) {
  MeasuredValue measured = normal(0.1, 3.0);
  measured.either_sign = true;
  const Decision decision = decide(measured, 3.0, iso);
  EXPECT_EQ(decision.verdict, Verdict::undecided);
  EXPECT_GT(decision.guard_band, 3.0);
}

TEST(Conformity, TakesAValueThatRoundingHasMovedOverItsLimitForOneAtIt) {
  EXPECT_EQ(decide({.value = 0.1 + 0.2, .rounding = 1e-15}, 0.3, simple).verdict, Verdict::conforms);
  EXPECT_EQ(decide({.value = 0.3 + 1e-9, .rounding = 1e-15}, 0.3, simple).verdict, Verdict::does_not_conform);
}

TEST(Conformity, HasNamesForReports) {
  EXPECT_EQ(verdict_name(Verdict::conforms), "conforms");
  EXPECT_EQ(verdict_name(Verdict::does_not_conform), "does not conform");
  EXPECT_EQ(verdict_name(Verdict::undecided), "undecided");
  EXPECT_EQ(verdict_name(Decision{}.verdict), "not applicable");
  EXPECT_EQ(simple.id(), "simple");
  EXPECT_EQ(iso.id(), "iso14253-1");
  EXPECT_EQ((DecisionRule{DecisionRule::Kind::guard_band, 1.0}).id(), "guard-band");
}

}  // namespace
}  // namespace axiometry::uncertainty
