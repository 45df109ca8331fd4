// SPDX-License-Identifier: Apache-2.0
#include "axiometry/verification/exact.h"

#include <gtest/gtest.h>

#include <random>

namespace axiometry::verification {
namespace {

Interval text(std::string_view digits) { return Interval::of(*decimal_of(digits)); }

/// Holds the value and is not wider than so many units of 10⁻⁴⁰.
void expect_holds(const Interval& got, std::string_view digits, int width) {
  const Interval right = text(digits);
  EXPECT_LE(got.lower(), right.upper()) << shown(got, 17) << " for " << digits;
  EXPECT_GE(got.upper(), right.lower()) << shown(got, 17) << " for " << digits;
  EXPECT_LE(Integer(got.upper() - got.lower()), width) << digits;
}

TEST(Exact, ReadsDecimalsAsTheyAreSpelled) {
  EXPECT_EQ(text("0.3").lower(), Integer(3) * power_of_ten(39));
  EXPECT_EQ(text("\u22124,1").lower(), Integer(-41) * power_of_ten(39));
  EXPECT_EQ(text("1e-09").lower(), power_of_ten(31));
  EXPECT_EQ(text("1.25E+2").lower(), Integer(125) * power_of_ten(40));
  EXPECT_EQ(text("0.000").lower(), 0);
  for (const char* none : {"", "-", ".", "abc", "1 2", "1e", "1e+", "nan", "1e40", "1.2.3", "--1"})
    EXPECT_FALSE(decimal_of(none)) << none;
}

TEST(Exact, TakesADoubleForTheDecimalThatItStandsFor) {
  EXPECT_EQ(Interval::of(0.1).lower(), power_of_ten(39));
  EXPECT_EQ(Interval::of(0.1).upper(), power_of_ten(39));
  EXPECT_EQ(Interval::of(-1e9).lower(), Integer(-1) * power_of_ten(49));
  EXPECT_EQ(Interval::of(5e-324).lower(), 0);
  EXPECT_EQ(Interval::of(5e-324).upper(), 1);
  EXPECT_EQ(Interval::of(-1e-100).lower(), -1);
}

TEST(Exact, RoundsOutwards) {
  const Interval third = Interval(1) / Interval(3);
  expect_holds(third, "0.3333333333333333333333333333333333333333", 1);
  EXPECT_LT(third.lower(), third.upper());
  expect_holds(Interval(-1) / Interval(3), "-0.3333333333333333333333333333333333333333", 1);
  expect_holds(third * Interval(3), "1", 3);
  expect_holds(Interval::of(-0.5) * Interval::of(0.5), "-0.25", 0);
  expect_holds(root(Interval(2)), "1.4142135623730950488016887242096980785696718753769", 1);
  EXPECT_EQ(root(Interval(4)).lower(), root(Interval(4)).upper());
  expect_holds(magnitude(Interval(-3)), "3", 0);
  expect_holds(Interval::root_of_squares(Integer(9) * power_of_ten(80), 4), "1.5", 0);
}

// Validation: sixty digits by another program.
TEST(Exact, GivesTheNormalDistributionToNineteenPlaces) {
  constexpr int narrow = 1'000'000'000;
  expect_holds(normal_distribution(0), "0.5", 10);
  expect_holds(normal_distribution(1), "0.8413447460685429485852325456320379224779", narrow);
  expect_holds(normal_distribution(-1), "0.1586552539314570514147674543679620775221", narrow);
  expect_holds(normal_distribution(text("1.959963984540054235524594430520551527956")), "0.975", narrow);
  const Interval far = normal_distribution(-5);
  EXPECT_TRUE(within(far, text("0.0000002866515718791939116737523"), text("1e-24")));
  EXPECT_GE(normal_distribution(12).lower(), text("0.9999999999999999998").lower());
  EXPECT_LE(normal_distribution(-40).upper(), text("1e-17").upper());
  EXPECT_GE(normal_distribution(-40).lower(), 0);
}

TEST(Exact, KnowsWhatAnIntervalDecides) {
  const Interval third = Interval(1) / Interval(3);
  EXPECT_TRUE(surely_at_most(third, text("0.34")));
  EXPECT_FALSE(surely_at_most(third, third));
  EXPECT_TRUE(possibly_at_most(third, third));
  EXPECT_TRUE(surely_at_most(text("0.3"), Interval::of(0.3)));
  EXPECT_TRUE(within(text("0.31"), text("0.3"), text("0.01")));
  EXPECT_FALSE(within(text("0.31"), text("0.3"), text("0.0099")));
}

}  // namespace
}  // namespace axiometry::verification
