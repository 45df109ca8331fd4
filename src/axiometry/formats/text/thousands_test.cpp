// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/text/thousands.h"

#include <gtest/gtest.h>

#include <initializer_list>

namespace axiometry::formats {
namespace {

std::string doubted(std::initializer_list<const char*> numbers) {
  ThousandsDoubt doubt(1);
  for (const char* number : numbers) doubt.look_at(0, number);
  const auto found = doubt.found();
  return found ? found->marked + " " + found->whole : "";
}

TEST(ThousandsDoubt, FindsMarksBeforeThreeDigitsBesideWholeNumbers) {
  EXPECT_EQ(doubted({"0", "500", "1.000", "1.500"}), "1.000 0");
  EXPECT_EQ(doubted({"120", "3,450", "980", "870"}), "3,450 120");
  EXPECT_EQ(doubted({"-250", "-1.250", "-2.125"}), "-1.250 -250");
  EXPECT_EQ(doubted({"\u2212"
                     "1.125",
                     "0", "2.125"}),
            "\u2212"
            "1.125 0");
}

TEST(ThousandsDoubt, LeavesDecimalsAlone) {
  EXPECT_EQ(doubted({"0.000", "250.000", "500.000", "1000.000"}), "") << "as many decimals in all";
  EXPECT_EQ(doubted({"0", "0.125", "1.125"}), "") << "no thousands begin with 0";
  EXPECT_EQ(doubted({"0", "1.125", "2.25"}), "");
  EXPECT_EQ(doubted({"0", "1.125", "1250"}), "") << "who parts thousands parts them all";
  EXPECT_EQ(doubted({"0", "1.125", "2"}), "") << "once, and no zero at its end";
  EXPECT_EQ(doubted({"1.125", "2.125"}), "");
  EXPECT_EQ(doubted({"0", "500", "1e3", "1.000e3"}), "");
  EXPECT_EQ(doubted({}), "");
}

TEST(ThousandsDoubt, IsSettledByAnyColumnOfTheFile) {
  ThousandsDoubt doubt(2);
  doubt.look_at(0, "500");
  doubt.look_at(0, "1.000");
  EXPECT_TRUE(doubt.found());
  doubt.look_at(1, "0.3");
  EXPECT_TRUE(doubt.settled());
  EXPECT_FALSE(doubt.found());
}

}  // namespace
}  // namespace axiometry::formats
