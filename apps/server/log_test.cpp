// SPDX-License-Identifier: Apache-2.0
#include "server/log.h"

#include <gtest/gtest.h>

namespace axiometry::server {
namespace {

TEST(LogText, is_visible_ASCII_whatever_it_was) {
  EXPECT_EQ(log_text("/api/tests/12/report.pdf"), "/api/tests/12/report.pdf");
  EXPECT_EQ(log_text("/a 200 5 bytes"), "/a%20200%205%20bytes");
  EXPECT_EQ(log_text("/a\r\n\x1b[2J\x7f"), "/a%0D%0A%1B[2J%7F");
  EXPECT_EQ(log_text("/\u202Etxt.exe"), "/%E2%80%AEtxt.exe");
  EXPECT_EQ(log_text("/100%\xff"), "/100%25%FF");
}

TEST(LogText, of_nothing_stands_for_itself) { EXPECT_EQ(log_text(""), "-"); }

}  // namespace
}  // namespace axiometry::server
