// SPDX-License-Identifier: Apache-2.0
#include "axiometry/base/text/rounded_text.h"

#include <gtest/gtest.h>

#include <limits>

namespace axiometry {
namespace {

TEST(RoundedText, LeavesOutWhatArithmeticLeft) {
  EXPECT_EQ(format_rounded(0.1 + 0.2), "0.3");
  EXPECT_EQ(format_rounded(489.34 * 25.4), "12429.236");
  EXPECT_EQ(format_rounded(-1e-12), "0");
  EXPECT_EQ(format_rounded(1.23456789), "1.234568");
  EXPECT_EQ(format_rounded(1.23456789, 2), "1.23");
  EXPECT_EQ(format_rounded(-100.0), "-100");
}

TEST(RoundedText, KeepsNumbersWithoutSuchDecimals) {
  EXPECT_EQ(format_rounded(1e300), "1e+300");
  EXPECT_EQ(format_rounded(std::numeric_limits<double>::max()), "1.7976931348623157e+308");
}

TEST(RoundedText, KeepsSignificantDigits) {
  EXPECT_EQ(format_significant(-0.123456, 3), "\u22120.123");
  EXPECT_EQ(format_significant(1234.5678, 3), "1235");
  EXPECT_EQ(format_significant(1234.5678, 6), "1234.57");
  EXPECT_EQ(format_significant(100.0, 6), "100");
  EXPECT_EQ(format_significant(0.0, 3), "0");
  EXPECT_EQ(format_significant(-1e-15, 3), "0");
}

TEST(RoundedText, StatesAProbabilityNoSmallerThanAnybodyKnows) {
  EXPECT_EQ(format_chance(0.003), "p = 0.0030");
  EXPECT_EQ(format_chance(1e-4), "p = 0.0001");
  EXPECT_EQ(format_chance(1e-22), "p < 0.0001");
  EXPECT_EQ(format_chance(0.0), "p < 0.0001");
}

}  // namespace
}  // namespace axiometry
