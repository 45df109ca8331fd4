// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/drawing/html_text.h"

#include <gtest/gtest.h>

namespace axiometry::report::html {
namespace {

TEST(Escaped, LeavesNothingThatABrowserWouldRun) {
  EXPECT_EQ(escaped("<b a=\"1\" c='2'>&"), "&lt;b a=&quot;1&quot; c=&#39;2&#39;&gt;&amp;");
  EXPECT_EQ(escaped("\x01\xff"), "\uFFFD\uFFFD");
}

TEST(CssString, CannotLeaveItsQuotesOrTheStyleElement) {
  EXPECT_EQ(css_string("a\"b"), "\"a\\000022b\"");
  EXPECT_EQ(css_string("</style>\n"), "\"\\00003c\\00002fstyle\\00003e\\00000a\"");
  EXPECT_EQ(css_string("Ä 1"), "\"Ä 1\"");
}

TEST(Rich, NestsStyles) {
  EXPECT_EQ(rich({{.text = "i", .italic = true, .script = Script::sub}}), "<sub><i>i</i></sub>");
  EXPECT_EQ(rich({{.text = "x", .bar = true}}), "<span class=\"bar\" role=\"img\" aria-label=\"x bar\">x</span>");
}

TEST(Length, CountsCharactersNotBytes) {
  EXPECT_EQ(length("−1.5"), 4u);
  EXPECT_EQ(length("x̄"), 1u);
}

}  // namespace
}  // namespace axiometry::report::html
