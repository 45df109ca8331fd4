// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/drawing/text_layout.h"

#include <gtest/gtest.h>

#include "axiometry/report/drawing/utf8.h"
#include "axiometry/report/pdf/font_metrics.h"

namespace axiometry::report {
namespace {

TEST(FontMetrics, AreThoseOfTheFace) {
  EXPECT_EQ(advance_width('x', FaceStyle::regular), 500);
  EXPECT_EQ(advance_width('M', FaceStyle::bold), 833);
  EXPECT_EQ(advance_width(U'↑', FaceStyle::regular), advance_width(U'↓', FaceStyle::regular));
  EXPECT_EQ(advance_width(U'\u0304', FaceStyle::regular), 0);
  EXPECT_EQ(advance_width(U'\n', FaceStyle::regular), 0);
  EXPECT_EQ(advance_width(U'机', FaceStyle::regular), 1000);
  EXPECT_GT(advance_width(U'א', FaceStyle::regular), 300);
}

TEST(TextWidth, AddsRunsInTheirSizes) {
  EXPECT_DOUBLE_EQ(text_width({{.text = "xx"}}, 10.0), 10.0);
  EXPECT_DOUBLE_EQ(text_width({{.text = "x"}, {.text = "x", .script = Script::sub}}, 10.0), 5.0 + 3.6);
}

TEST(TextLayout, DrawsABarOverASmallLetterLowerThanOverACapital) {
  const Text small{.runs = {{.text = "x", .italic = true, .bar = true}}, .size = 10};
  const Text capital{.runs = {{.text = "B", .italic = true, .bar = true}}, .size = 10};
  const TextLayout x = lay_out(small);
  const TextLayout B = lay_out(capital);
  ASSERT_EQ(x.bars.size(), 1u);
  ASSERT_EQ(B.bars.size(), 1u);
  EXPECT_LT(x.bars[0].rise, B.bars[0].rise);
  EXPECT_GT(x.bars[0].width, 3.0);
}

TEST(TextBox, FollowsAnchorAndRotation) {
  const Box level = text_box({.runs = {{.text = "xx"}}, .at = {100, 50}, .size = 10, .anchor = Anchor::end});
  EXPECT_NEAR(level.left, 90.0, 1e-9);
  EXPECT_NEAR(level.right, 100.0, 1e-9);
  EXPECT_LT(level.top, 44.0);
  const Box upright =
      text_box({.runs = {{.text = "xx"}}, .at = {100, 50}, .size = 10, .anchor = Anchor::start, .degrees = 90});
  EXPECT_NEAR(upright.top, 40.0, 1e-9);
  EXPECT_NEAR(upright.bottom, 50.0, 1e-9);
  EXPECT_LT(upright.left, 94.0);
}

TEST(Utf8, ReadsEveryLengthAndRefusesTheRest) {
  EXPECT_EQ(character_at("a", 0).code, U'a');
  EXPECT_EQ(character_at("µ", 0).code, U'µ');
  EXPECT_EQ(character_at("−", 0).code, U'−');
  EXPECT_EQ(character_at("😀", 0).length, 4u);
  for (const std::string_view invalid : {"\x80", "\xc0\x80", "\xe2\x88", "\xed\xa0\x80", "\xf5\x80\x80\x80", "\xff"}) {
    EXPECT_EQ(character_at(invalid, 0).code, char32_t{0xfffd});
    EXPECT_EQ(character_at(invalid, 0).length, 1u);
  }
}

}  // namespace
}  // namespace axiometry::report
