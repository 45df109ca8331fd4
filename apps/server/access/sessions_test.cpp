// SPDX-License-Identifier: Apache-2.0
#include "server/access/sessions.h"

#include <gtest/gtest.h>

#include <string>

namespace axiometry::server {
namespace {

using namespace std::chrono_literals;

constexpr Sessions::Clock::time_point dawn{};

TEST(Sessions, are_random_and_each_its_own) {
  Sessions sessions;
  const std::string a = sessions.begin(dawn).session;
  const std::string b = sessions.begin(dawn).session;
  EXPECT_EQ(a.size(), 64U);
  EXPECT_NE(a, b);
  EXPECT_TRUE(sessions.knows(a, dawn));
  EXPECT_TRUE(sessions.end(a));
  EXPECT_FALSE(sessions.end(a)) << "already";
  EXPECT_FALSE(sessions.knows(a, dawn));
  EXPECT_TRUE(sessions.knows(b, dawn));
  EXPECT_FALSE(sessions.knows("", dawn));
}

TEST(Sessions, end_when_they_are_old_however_much_they_are_used) {
  Sessions sessions;
  const std::string session = sessions.begin(dawn).session;
  auto now = dawn;
  for (; now < dawn + Sessions::longest; now += 24h) EXPECT_TRUE(sessions.knows(session, now));
  EXPECT_FALSE(sessions.knows(session, now));
  EXPECT_EQ(sessions.count(), 0U);
}

TEST(Sessions, end_when_nobody_shows_them_for_long) {
  Sessions sessions;
  const std::string session = sessions.begin(dawn).session;
  EXPECT_TRUE(sessions.knows(session, dawn + Sessions::unused - 1s));
  EXPECT_FALSE(sessions.knows(session, dawn + 2 * Sessions::unused));
}

TEST(Sessions, are_no_more_than_the_server_has_memory_for) {
  Sessions sessions;
  const std::string first = sessions.begin(dawn).session;
  const std::string second = sessions.begin(dawn + 1s).session;
  EXPECT_TRUE(sessions.knows(first, dawn + 2s));
  for (std::size_t k = 2; k <= Sessions::most; ++k)
    EXPECT_EQ(sessions.begin(dawn + 3s).ends_another, k == Sessions::most) << k;
  EXPECT_EQ(sessions.count(), Sessions::most);
  EXPECT_TRUE(sessions.knows(first, dawn + 3s));
  EXPECT_FALSE(sessions.knows(second, dawn + 3s)) << "was unused for longest";
}

}  // namespace
}  // namespace axiometry::server
