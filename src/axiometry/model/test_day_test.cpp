// SPDX-License-Identifier: Apache-2.0
#include "axiometry/model/test_day.h"

#include <gtest/gtest.h>

#include <chrono>

#include "axiometry/base/time/iso_date.h"

namespace axiometry {
namespace {

TEST(DayOfTest, IsADayOnWhichATestCanHaveBeenMade) {
  EXPECT_EQ(day_of_test("2014-05-15"), "2014-05-15");
  EXPECT_EQ(day_of_test("1950-01-01"), "1950-01-01");
  for (const char* none : {"", "1949-12-31", "0001-01-01", "2914-05-15", "2014-02-30", "unknown"})
    EXPECT_EQ(day_of_test(none), "") << none;
  using namespace std::chrono;
  const auto today = floor<days>(system_clock::now());
  EXPECT_EQ(day_of_test(iso_day(today + days(1))), iso_day(today + days(1))) << "east of Greenwich it may be so late";
  EXPECT_EQ(day_of_test(iso_day(today + days(3))), "");
}

}  // namespace
}  // namespace axiometry
