// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/text/time_stamp.h"

#include <gtest/gtest.h>

namespace axiometry::formats {
namespace {

TEST(TimeStamp, CountsSecondsAsOtherProgramsDo) {
  EXPECT_EQ(time_stamp_s("2026-03-07T23:30:43"), 1772926243.0);  // of Python's datetime
  EXPECT_EQ(time_stamp_s("2026-03-07 23:30:43"), 1772926243.0);
  EXPECT_NEAR(time_stamp_s("2022-04-06 12:48:22.148376").value_or(0), 1649249302.148376, 1e-6);
  EXPECT_EQ(time_stamp_s("1970-01-01T00:00:00Z"), 0.0);
  EXPECT_EQ(time_stamp_s("1970-01-01T01:30:00+01:30"), 0.0);
  EXPECT_EQ(time_stamp_s("1969-12-31T23:00:00-0100"), 0.0);
}

TEST(TimeStamp, KnowsNoOtherText) {
  for (const char* text : {"", "2026", "2026-03-07", "2026-02-30T00:00:00", "2026-03-07T24:00:00",
                           "2026-03-07T23:61:00", "07.03.2026 23:30:43", "2026-03-07T23:30:43 soon",
                           "2026-03-07T23:30:43.", "-026-03-07T23:30:43", "2026-03-07T23:30:43+1:00"})
    EXPECT_EQ(time_stamp_s(text), std::nullopt) << text;
}

}  // namespace
}  // namespace axiometry::formats
