// SPDX-License-Identifier: Apache-2.0
#include "axiometry/base/time/moment.h"

#include <gtest/gtest.h>

namespace axiometry {
namespace {

TEST(Moments, AreReadWithAndWithoutSecondsAndZone) {
  const auto plain = moment_of("2026-03-02T09:00");
  ASSERT_TRUE(plain);
  EXPECT_FALSE(plain->zoned);
  for (const char* same : {"2026-03-02 09:00:00", "02.03.2026 09:00", "2.3.2026 9:00:00,0", " 2026-03-02T09:00 "}) {
    const auto other = moment_of(same);
    ASSERT_TRUE(other) << same;
    EXPECT_EQ(other->ns, plain->ns) << same;
    EXPECT_FALSE(other->zoned) << same;
  }
  const auto zoned = moment_of("2026-03-02T09:00:00+02:00");
  ASSERT_TRUE(zoned);
  EXPECT_TRUE(zoned->zoned);
  EXPECT_EQ(zoned->seconds_since(*plain), -7200.0);
  EXPECT_TRUE(moment_of("2026-03-02T09:00:00Z")->zoned);
}

TEST(Moments, AreComparedHoweverFarApart) {
  const auto first = moment_of("1900-01-01T00:00"), last = moment_of("2199-12-31T00:00");
  constexpr double days = 109572.0;  // 299 years with 73 leap days, and 364 days
  EXPECT_EQ(last->seconds_since(*first), days * 86400.0) << "more than 2^63 ns";
  EXPECT_EQ(first->seconds_since(*last), -days * 86400.0);
}

TEST(Moments, AreNoOtherText) {
  for (const char* text : {"", "2026-03-02", "09:00", "30.02.2026 09:00", "2026-03-02T24:00", "02/03/2026 09:00",
                           "2026-03-02T09:60", "tomorrow", "2026-03-02T09"})
    EXPECT_FALSE(moment_of(text)) << text;
}

TEST(Moments, AreWrittenAsTheyAreRead) {
  for (const char* text : {"2026-03-02T09:00:00", "2026-12-31T23:59:59Z", "1999-01-01T00:00:00"}) {
    EXPECT_EQ(moment_text(*moment_of(text)), text);
    EXPECT_EQ(moment_of(moment_text(*moment_of(text)))->ns, moment_of(text)->ns);
  }
  EXPECT_EQ(moment_text(*moment_of("2026-12-31T23:59:59.7")), "2027-01-01T00:00:00");
}

TEST(TimesOfDay, AreSecondsSinceMidnight) {
  EXPECT_EQ(time_of_day_s("9:05"), 32700.0);
  EXPECT_EQ(time_of_day_s("09:05:10.5"), 32710.5);
  EXPECT_EQ(time_of_day_s("23:59:59,25"), 86399.25);
  for (const char* text : {"", "9", "9:5", "24:00", "12:60", "12:00:61.5", "a:00", "12:00:00:00", "-1:00"})
    EXPECT_FALSE(time_of_day_s(text)) << text;
}

TEST(Days, CountFrom1970) {
  EXPECT_EQ(day_of("1970-01-01"), 0);
  EXPECT_EQ(day_of("02.03.2026"), day_of("2026-03-02"));
  for (const char* text : {"", "2026-13-01", "31.04.2026", "26-03-02", "03/02/2026", "2026-03"})
    EXPECT_FALSE(day_of(text)) << text;
}

TEST(TimeStamps, CountsSecondsOfATimeStampAsOtherProgramsDo) {
  EXPECT_EQ(time_stamp_s("2026-03-07T23:30:43"), 1772926243.0);  // of Python's datetime
  EXPECT_EQ(time_stamp_s("2026-03-07 23:30:43"), 1772926243.0);
  EXPECT_NEAR(time_stamp_s("2022-04-06 12:48:22.148376").value_or(0), 1649249302.148376, 1e-6);
  EXPECT_EQ(time_stamp_s("1970-01-01T00:00:00Z"), 0.0);
  EXPECT_EQ(time_stamp_s("1970-01-01T01:30:00+01:30"), 0.0);
  EXPECT_EQ(time_stamp_s("1969-12-31T23:00:00-0100"), 0.0);
  EXPECT_EQ(time_stamp_s(" 1969-12-31T23:00:00.5-01 "), 0.5);
}

TEST(TimeStamps, KnowsNoOtherTextAsATimeStamp) {
  for (const char* text :
       {"", "2026", "2026-03-07", "2026-02-30T00:00:00", "2026-03-07T24:00:00", "2026-03-07T23:61:00",
        "07.03.2026 23:30:43", "2026-03-07T23:30:43 soon", "2026-03-07T23:30:43.", "-026-03-07T23:30:43",
        "2026-03-07T23:30:43+1:00", "2026-03-07T23:30:43+99:00", "2026/03/07 23:30:43", "2026-03-07 23:30"})
    EXPECT_EQ(time_stamp_s(text), std::nullopt) << text;
}

}  // namespace
}  // namespace axiometry
