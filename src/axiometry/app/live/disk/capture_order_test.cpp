// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/live/disk/capture_order.h"

#include <gtest/gtest.h>

namespace axiometry::app {
namespace {

std::optional<CaptureOrder> order_of(const char* plan, const char* part) {
  const std::string text = std::string(R"({"lengths": {"kind": "lines", "plan": "a"}, "plan": )") + plan +
                           R"(, "part": )" + part + R"(, "source": 7, "actor": "somebody"})";
  const auto value = json::parse(text);
  EXPECT_TRUE(value) << text;
  return value ? capture_order_from(*value) : std::nullopt;
}

/// An archive of another program may have brought it along.
TEST(CaptureOrder, TakesNoNumberThatNoneCanBe) {
  const auto usual = order_of("12", "3");
  ASSERT_TRUE(usual);
  EXPECT_EQ(usual->plan, 12);
  EXPECT_EQ(usual->part, 3u);
  EXPECT_EQ(usual->source, "") << "a number is no text";
  EXPECT_EQ(usual->actor, "somebody");
  for (const char* number : {"1e300", "-1", "null", "\"1\""}) {
    const auto odd = order_of(number, number);
    ASSERT_TRUE(odd) << number;
    EXPECT_EQ(odd->plan, 0) << number;
    EXPECT_EQ(odd->part, 0u) << number;
  }
}

}  // namespace
}  // namespace axiometry::app
