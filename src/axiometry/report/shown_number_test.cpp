// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/shown_number.h"

#include <gtest/gtest.h>

namespace axiometry::report {
namespace {

TEST(ShownShort, WritesOutWhatAPersonWouldWriteOut) {
  EXPECT_EQ(shown_short(1744.209, {}), "1744.209");
  EXPECT_EQ(shown_short(1252.3839, {}, 3), "1250");
  EXPECT_EQ(shown_short(-99999.6, {}, 3), "\u2212100000");
  EXPECT_EQ(shown_short(0.0174, {}, 3), "0.0174");
  EXPECT_EQ(shown_short(1.25e9, {}, 3), "1.25e+09");
}

TEST(WithTrueMinus, TakesHyphensOfNumbersAlone) {
  EXPECT_EQ(with_true_minus("-1.5"), "−1.5");
  EXPECT_EQ(with_true_minus("Z -500 to 0 mm, at (-3; 0; -2) mm"), "Z −500 to 0 mm, at (−3; 0; −2) mm");
  EXPECT_EQ(with_true_minus("ISO 230-2, - , 2-3 a-1"), "ISO 230-2, - , 2-3 a-1");
}

}  // namespace
}  // namespace axiometry::report
