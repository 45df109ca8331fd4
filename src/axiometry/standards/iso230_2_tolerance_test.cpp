// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2_tolerance.h"

#include <gtest/gtest.h>

namespace axiometry::iso230_2 {
namespace {

Tolerance limit(std::string_view key, double um) {
  for (const ParameterInfo& info : parameters)
    if (info.key == key) return {&info, Deviation::native(um)};
  return {};
}

TEST(Judge, ComparesMagnitudesAndTakesTheLimitItselfForWithin) {
  AxisParameters p;
  p.A = Deviation::native(10);
  p.B_mean = Deviation::native(-3);
  const Tolerance limits[] = {limit("A", 10), limit("A", 9.99), limit("B_mean", 2), limit("B_mean", 3)};
  const auto judgements = judge(p, limits);
  ASSERT_EQ(judgements.size(), 4u);
  EXPECT_EQ(judgements[0].verdict, Verdict::within);
  EXPECT_EQ(judgements[1].verdict, Verdict::exceeded);
  EXPECT_EQ(judgements[2].verdict, Verdict::exceeded);
  EXPECT_EQ(judgements[3].verdict, Verdict::within);
}

TEST(Judge, HasNoVerdictOnWhatDoesNotExist) {
  const Tolerance limits[] = {limit("R", 1e9)};
  EXPECT_EQ(judge({}, limits)[0].verdict, Verdict::not_applicable);
}

}  // namespace
}  // namespace axiometry::iso230_2
