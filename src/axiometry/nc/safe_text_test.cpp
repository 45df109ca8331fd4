// SPDX-License-Identifier: Apache-2.0
#include "axiometry/nc/safe_text.h"

#include <gtest/gtest.h>

namespace axiometry::nc {
namespace {

using Parts = std::vector<std::string>;

TEST(SafeText, KeepsWhatAControlCanRead) {
  EXPECT_EQ(safe_text("Mill 3, X-axis.", ".,-"), "MILL 3, X-AXIS.");
  EXPECT_EQ(safe_text("Fräse Größe 5 µm 20°", ""), "FRAESE GROESSE 5 UM 20 DEG");
  EXPECT_EQ(safe_text("(new)", "[]"), "[NEW]");
  EXPECT_EQ(safe_text("(new)", "()"), "(NEW)");
  EXPECT_EQ(safe_text("(new)", ""), "-NEW-");
}

TEST(SafeText, LeavesNothingThatEndsACommentOrBeginsABlock) {
  EXPECT_EQ(safe_text("a)\nM30;%:\"'", ""), "A- M30-----");
  EXPECT_EQ(safe_text("\xff\xc3", ""), "--");
  EXPECT_EQ(safe_text("\xe6\xa9\x9f\xf0\x9f\x94\xa7", ""), "--");
  EXPECT_EQ(safe_text(std::string("\0\x7f\x1b", 3), ""), "---");
  EXPECT_EQ(safe_text("\xe6(", ""), "--");
  EXPECT_EQ(safe_text("\xc0\xa8", "("), "--");  // an overlong bracket
}

TEST(Wrapped, PartsAtBlanksAndCutsLongWords) {
  EXPECT_EQ(wrapped("", 5), Parts{""});
  EXPECT_EQ(wrapped("AB CD", 5), Parts{"AB CD"});
  EXPECT_EQ(wrapped("AB CDE", 5), (Parts{"AB", "CDE"}));
  EXPECT_EQ(wrapped("ABCDEFG", 5), (Parts{"ABCDE", "FG"}));
  EXPECT_EQ(wrapped("ABCDE FG", 5), (Parts{"ABCDE", "FG"}));
}

}  // namespace
}  // namespace axiometry::nc
