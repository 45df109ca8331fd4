// SPDX-License-Identifier: Apache-2.0
#include "server/http/disconnect.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>

namespace axiometry::server {
namespace {

TEST(Departure, is_seen_behind_what_was_sent_ahead) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()), 0);
  EXPECT_FALSE(has_left(ends[0]));
  ASSERT_EQ(::write(ends[1], "GET", 3), 3);
  EXPECT_FALSE(has_left(ends[0]));
  ::close(ends[1]);
  EXPECT_TRUE(has_left(ends[0]));
  ::close(ends[0]);
}

}  // namespace
}  // namespace axiometry::server
