// SPDX-License-Identifier: Apache-2.0
#include "server/access/security_log.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace axiometry::server {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::HasSubstr;

const SecurityLog::Clock::time_point midday{std::chrono::sys_days{std::chrono::year{2026} / 11 / 23} + 12h};
constexpr SecurityLog::Entry guess{SecurityEvent::token_refused, "192.0.2.1", "GET", "/api/tests", 401};

struct Written {
  std::vector<std::string> lines;
  std::unique_ptr<SecurityLog> log =
      std::make_unique<SecurityLog>([this](std::string_view line) { lines.emplace_back(line); });

  void flood(std::size_t count, SecurityLog::Clock::time_point now) {
    for (std::size_t k = 0; k < count; ++k) log->tell(guess, now);
  }
};

TEST(SecurityLog, has_one_line_in_one_format_for_every_event) {
  Written written;
  written.log->tell(guess, midday);
  written.log->tell({SecurityEvent::signed_in, "::1", "POST", "/api/login", 204}, midday + 61s);
  written.log->tell({SecurityEvent::none, "::1", "GET", "/", 200}, midday);
  EXPECT_THAT(
      written.lines,
      ElementsAre("axiometry: security 2026-11-23T12:00:00Z token-refused peer=192.0.2.1 method=GET path=/api/tests "
                  "status=401",
                  "axiometry: security 2026-11-23T12:01:01Z signed-in peer=::1 method=POST path=/api/login "
                  "status=204"));
}

TEST(SecurityLog, is_visible_ASCII_of_bounded_length_whatever_was_asked) {
  Written written;
  const std::string path = "/\r\nforged \x1b[2J \u202E" + std::string(100'000, '\xff');
  written.log->tell({SecurityEvent::host_refused, "a", std::string(5000, 'M'), path, 421}, midday);
  ASSERT_EQ(written.lines.size(), 1U);
  EXPECT_LT(written.lines[0].size(), 400U);
  EXPECT_TRUE(std::ranges::all_of(written.lines[0], [](char c) { return c >= ' ' && c <= '~'; })) << written.lines[0];
  EXPECT_THAT(written.lines[0], HasSubstr("path=/%0D%0Aforged%20"));
}

TEST(SecurityLog, says_once_how_much_it_left_out_where_the_process_is_to_be_cut_off) {
  Written written;
  written.flood(SecurityLog::burst + 10, midday);
  written.log->tell_left_out(midday);
  ASSERT_EQ(written.lines.size(), SecurityLog::burst + 1);
  EXPECT_THAT(written.lines.back(), HasSubstr("left-out event=token-refused count=10"));
  written.log->tell_left_out(midday);
  written.log.reset();
  EXPECT_EQ(written.lines.size(), SecurityLog::burst + 1);
}

TEST(SecurityLog, leaves_out_what_floods_it_and_says_how_much) {
  Written written;
  written.flood(1000, midday);
  EXPECT_EQ(written.lines.size(), SecurityLog::burst);
  written.flood(1, midday + SecurityLog::pause - 1s);
  EXPECT_EQ(written.lines.size(), SecurityLog::burst);
  written.flood(3, midday + SecurityLog::pause);
  ASSERT_EQ(written.lines.size(), SecurityLog::burst + 2);
  EXPECT_THAT(written.lines[SecurityLog::burst], HasSubstr("Z left-out event=token-refused count=981"));
  EXPECT_THAT(written.lines.back(), HasSubstr(" token-refused peer="));
  written.log.reset();
  EXPECT_THAT(written.lines.back(), HasSubstr("left-out event=token-refused count=2"));
}

TEST(SecurityLog, tells_an_event_though_another_floods_it_and_what_was_left_out_with_it) {
  Written written;
  written.flood(100, midday);
  written.log->tell({SecurityEvent::signed_in, "::1", "POST", "/api/login", 204}, midday);
  EXPECT_THAT(written.lines.back(), HasSubstr(" signed-in "));
  written.log->tell({SecurityEvent::signed_out, "::1", "POST", "/api/logout", 204}, midday + 1h);
  EXPECT_THAT(written.lines[SecurityLog::burst + 1], HasSubstr("left-out event=token-refused count=80"));
}

TEST(SecurityLog, is_bounded_in_a_day_of_flooding_and_by_a_clock_that_goes_back) {
  Written written;
  for (auto now = midday; now < midday + 24h; now += 1s) written.flood(3, now);
  EXPECT_LT(written.lines.size(), 2 * (24h / SecurityLog::pause) + 2 * SecurityLog::burst);
  const std::size_t before = written.lines.size();
  for (auto now = midday; now > midday - 24h; now -= 1s) written.flood(1, now);
  EXPECT_LT(written.lines.size(), before + SecurityLog::burst);
}

}  // namespace
}  // namespace axiometry::server
