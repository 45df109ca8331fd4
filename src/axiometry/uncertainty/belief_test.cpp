// SPDX-License-Identifier: Apache-2.0
#include "axiometry/uncertainty/belief.h"

#include <gtest/gtest.h>

#include "axiometry/numeric/distributions/normal_and_student_t.h"

namespace axiometry::uncertainty {
namespace {

SampledDistribution evenly(double from, double to) { return SampledDistribution({{from, to, 0, 1000}}); }

TEST(Belief, OfANormalQuantityIsOneDistribution) {
  const Belief belief = Belief::normal(10.0, 2.0);
  const Range at_most = belief.probability_at_most(12.0);
  EXPECT_DOUBLE_EQ(at_most.least, numeric::normal_probability(1.0));
  EXPECT_EQ(at_most.least, at_most.most);
  EXPECT_DOUBLE_EQ(belief.quantile(0.95).most, 10.0 + 2.0 * numeric::normal_quantile(0.95));
  EXPECT_NEAR(belief.probability_within(12.0).least,
              numeric::normal_probability(1.0) - numeric::normal_probability(-11.0), 1e-15);
}

TEST(Belief, WithoutDoubtIsTheValueItself) {
  const Belief belief = Belief::normal(10.0, 0.0);
  EXPECT_EQ(belief.probability_at_most(10.0).least, 1.0);
  EXPECT_EQ(belief.probability_at_most(9.999).most, 0.0);
  EXPECT_EQ(belief.quantile(0.05).least, 10.0);
  EXPECT_EQ(belief.probability_within(9.0).most, 0.0);
  EXPECT_EQ(belief.probability_within(9.0, -2.0).least, 1.0);
}

TEST(Belief, OfSeveralDistributionsGivesTheLeastAndTheMostOfThem) {
  const SampledDistribution low = evenly(0.0, 10.0);
  const SampledDistribution high = evenly(5.0, 15.0);
  const Belief belief = Belief::sampled(8.0, {{&low}, {&high}});
  const Range at_most = belief.probability_at_most(9.0);
  EXPECT_NEAR(at_most.least, 0.4, 1e-12);
  EXPECT_NEAR(at_most.most, 0.9, 1e-12);
  EXPECT_NEAR(belief.quantile(0.95).most, 14.5, 1e-12);
  EXPECT_NEAR(belief.quantile(0.05).least, 0.5, 1e-12);
}

TEST(Range, SaysAsLittleAsItCan) {
  EXPECT_EQ((Range{0.96, 0.99}).cautious(), 0.96);
  EXPECT_EQ((Range{0.01, 0.04}).cautious(), 0.04);
  EXPECT_EQ((Range{0.01, 0.99}).cautious(), 0.5);
  EXPECT_EQ((Range{0.6, 0.99}).cautious(), 0.6);
}

}  // namespace
}  // namespace axiometry::uncertainty
