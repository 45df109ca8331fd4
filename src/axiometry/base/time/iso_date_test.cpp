// SPDX-License-Identifier: Apache-2.0
#include "axiometry/base/time/iso_date.h"

#include <gtest/gtest.h>

namespace axiometry {
namespace {

TEST(IsoDate, ReadsWhatIsCertainAndNothingElse) {
  EXPECT_EQ(iso_date("2014-05-15"), "2014-05-15");
  EXPECT_EQ(iso_date("2014-05-15T09:30:00Z"), "2014-05-15");
  EXPECT_EQ(iso_date(" 5.3.2026 "), "2026-03-05");
  EXPECT_EQ(iso_date("2014/5/15 10:00"), "2014-05-15");
  EXPECT_EQ(iso_date("20140515"), "2014-05-15");
  EXPECT_EQ(iso_date("20140515T093000Z"), "2014-05-15");
  EXPECT_EQ(iso_date("15052014"), "") << "no month 20";
  EXPECT_EQ(iso_date("20140231"), "");
  EXPECT_EQ(iso_date("15.5.14"), "");
  EXPECT_EQ(iso_date("2014-05"), "");
  EXPECT_EQ(iso_date("05/06/2014"), "");
  EXPECT_EQ(iso_date("2014-02-30"), "");
  EXPECT_EQ(iso_date("spring 2014"), "");
  EXPECT_EQ(iso_date("None: simulated"), "");
  EXPECT_EQ(iso_date(""), "");
}

TEST(IsoDay, HasTwoPlacesForMonthAndDay) {
  using namespace std::chrono;
  EXPECT_EQ(iso_day(year(2014) / 5 / 9), "2014-05-09");
  EXPECT_EQ(iso_day(sys_days{}), "1970-01-01");
}

TEST(IsNoDay, OfWhatIsWrittenAsOneAndDoesNotExist) {
  for (const char* none : {"2026-02-30", "2026-13-45", " 2026-02-30T09:00", "30.02.2026", "2026/2/30", "2026-00-10"})
    EXPECT_TRUE(is_no_day(none)) << none;
  for (const char* other : {"2026-02-28", "28.02.2026", "05/06/2014", "30/02/2026", "2026-02", "spring 2026",
                            "12-NOV-26", "None: simulated", "abcd-ef-gh", "15.5.14", ""})
    EXPECT_FALSE(is_no_day(other)) << other;
}

TEST(NamedDays, OfAMonthAreItsEnds) {
  const auto days = [](std::string_view text) {
    const NamedDays named = named_days(text);
    return named.first + ".." + named.last;
  };
  EXPECT_EQ(days("2013-06"), "2013-06-01..2013-06-30");
  EXPECT_EQ(days("2012/2"), "2012-02-01..2012-02-29");
  EXPECT_EQ(days("06/2013"), "2013-06-01..2013-06-30");
  EXPECT_EQ(days(" 12.2013 "), "2013-12-01..2013-12-31");
  EXPECT_EQ(days("2013-06-17"), "2013-06-17..2013-06-17");
  for (const char* none : {"2013-06-31", "2013-13", "expired", "06-13", "6/13", "2013", ""})
    EXPECT_EQ(days(none), "..") << none;
}

}  // namespace
}  // namespace axiometry
