// SPDX-License-Identifier: Apache-2.0
#include "axiometry/uncertainty/conformity.h"

#include <gtest/gtest.h>

#include "axiometry/numeric/special_functions.h"

namespace axiometry::uncertainty {
namespace {

constexpr DecisionRule simple{DecisionRule::Kind::simple};
constexpr DecisionRule iso{DecisionRule::Kind::iso_14253_1};

Verdict verdict(double value, double u, const DecisionRule& rule) { return decide({value, u}, 10.0, rule).verdict; }

TEST(Conformity, IsDecidedAtTheLimitBySimpleAcceptance) {
  EXPECT_EQ(verdict(10.0, 1.0, simple), Verdict::conforms);
  EXPECT_EQ(verdict(10.001, 1.0, simple), Verdict::does_not_conform);
  EXPECT_EQ(decide({9.0}, 10.0, simple).verdict, Verdict::conforms);
  EXPECT_EQ(decide({9.0}, 10.0, simple).probability_conforming, std::nullopt);
}

TEST(Conformity, IsUndecidedWithinTheGuardBandOnEitherSide) {
  EXPECT_EQ(verdict(8.35, 1.0, iso), Verdict::conforms);
  EXPECT_EQ(verdict(8.36, 1.0, iso), Verdict::undecided);
  EXPECT_EQ(verdict(11.65, 1.0, iso), Verdict::undecided);
  EXPECT_EQ(verdict(11.66, 1.0, iso), Verdict::does_not_conform);
  EXPECT_DOUBLE_EQ(decide({9.0, 0.2}, 10.0, iso).guard_band, 0.33);
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
  const Decision accepted = decide({9.0, 0.5}, 10.0, simple);
  EXPECT_NEAR(*accepted.probability_conforming, 0.977249868051821, 1e-12);
  EXPECT_NEAR(*accepted.consumer_risk, 0.022750131948179, 1e-12);
  EXPECT_EQ(accepted.producer_risk, std::nullopt);
  const Decision rejected = decide({11.0, 0.5}, 10.0, simple);
  EXPECT_NEAR(*rejected.producer_risk, 0.022750131948179, 1e-12);
  EXPECT_EQ(rejected.consumer_risk, std::nullopt);
}

TEST(Conformity, TakesFivePercentRiskAtMostWithTheGuardBandOfISO14253) {
  EXPECT_LE(*decide({10.0 - 1.65, 1.0}, 10.0, iso).consumer_risk, 0.05);
  EXPECT_GE(*decide({10.0 - 1.65, 1.0}, 10.0, iso).consumer_risk, 0.049);
}

TEST(Conformity, IsCertainWithoutAnyUncertainty) {
  EXPECT_EQ(decide({10.0, 0.0}, 10.0, iso).probability_conforming, 1.0);
  EXPECT_EQ(decide({10.1, 0.0}, 10.0, iso).probability_conforming, 0.0);
  EXPECT_EQ(decide({10.1, 0.0}, 10.0, iso).verdict, Verdict::does_not_conform);
}

TEST(Conformity, TakesItsProbabilityFromTheTrialsWhereThereAreSome) {
  const SampledDistribution sampled({{8.0, 9.0, 0, 60}, {9.5, 10.5, 60, 40}});
  const Decision decision = decide({9.5, 0.5, sampled}, 10.0, iso);
  EXPECT_DOUBLE_EQ(*decision.probability_conforming, 0.8);
  EXPECT_EQ(decision.verdict, Verdict::undecided);
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
