// SPDX-License-Identifier: Apache-2.0
#include "axiometry/numeric/distributions/f_distribution.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "axiometry/numeric/distributions/normal_and_student_t.h"

namespace axiometry::numeric {
namespace {

// With two degrees of freedom above the tail is (1 + 2f/below)^(−below/2); below alike by 1/F.
TEST(FDistribution, HasItsClosedForms) {
  for (double below : {1.0, 3.0, 8.0, 40.0, 4000.0})
    for (double f : {0.01, 0.5, 1.0, 4.0, 30.0}) {
      const double exact = std::exp(-0.5 * below * std::log1p(2.0 * f / below));
      EXPECT_NEAR(f_tail(f, {2.0, below}) / exact, 1.0, 1e-10) << below << ' ' << f;
      EXPECT_NEAR(f_tail(1.0 / f, {below, 2.0}), 1.0 - exact, 1e-11) << below << ' ' << f;
    }
}

TEST(FDistribution, OfOneDegreeAboveIsTheSquareOfStudentsT) {
  for (double nu : {1.0, 3.0, 7.0, 100.0})
    for (double t : {0.2, 1.0, 2.5, 9.0})
      EXPECT_NEAR(f_tail(t * t, {1.0, nu}) / (2.0 * student_t_probability(-t, nu)), 1.0, 1e-10) << nu << ' ' << t;
}

// Fisher and Yates' tables: the 1 % points of F(4, 40) and F(20, 20).
TEST(FDistribution, MeetsPrintedTables) {
  EXPECT_NEAR(f_tail(3.828, {4.0, 40.0}), 0.01, 2e-5);
  EXPECT_NEAR(f_tail(2.938, {20.0, 20.0}), 0.01, 2e-5);
}

TEST(FDistribution, HasItsEnds) {
  EXPECT_EQ(f_tail(0.0, {3.0, 5.0}), 1.0);
  EXPECT_EQ(f_tail(std::numeric_limits<double>::infinity(), {3.0, 5.0}), 0.0);
}

// Never said where it is not so; said of nearly all that is above the level by a little where the degrees of freedom
// are even, so that the sum is the tail itself.
TEST(FDistribution, IsAboveALevelWhereThatIsSaidOnly) {
  int above = 0, said = 0;
  for (double degrees_above : {0.5, 1.0, 2.0, 3.0, 4.0, 7.0, 8.0, 40.0, 43.5, 80.0, 300.0})
    for (double degrees_below : {0.7, 1.0, 4.0, 33.0, 44.0, 84.0, 4000.0})
      for (double f : {0.0, 0.3, 1.0, 1.5, 2.25, 3.0, 5.0, 12.0, 400.0, 1e9})
        for (double level : {0.5, 0.01, 0.003, 0.003 / 84, 1e-12}) {
          const RatioDegrees degrees{degrees_above, degrees_below};
          const double tail = f_tail(f, degrees);
          const bool is_said = f_tail_is_above(level, f, degrees);
          EXPECT_TRUE(tail > level || !is_said) << f << ' ' << degrees_above << ' ' << degrees_below << ' ' << level;
          if (std::fmod(degrees_above, 2.0) != 0.0 || degrees_above > 100.0) continue;
          above += tail > 1.001 * level ? 1 : 0;
          said += is_said ? 1 : 0;
        }
  EXPECT_GT(said, 0.999 * above) << above;
}

TEST(FDistribution, OfAnInfiniteRatioIsAboveNothing) {
  EXPECT_FALSE(f_tail_is_above(1e-300, std::numeric_limits<double>::infinity(), {4.0, 40.0}));
}

}  // namespace
}  // namespace axiometry::numeric
