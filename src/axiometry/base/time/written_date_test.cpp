// SPDX-License-Identifier: Apache-2.0
#include "axiometry/base/time/written_date.h"

#include <gtest/gtest.h>

#include "axiometry/base/time/iso_date.h"

namespace axiometry {
namespace {

TEST(WrittenDate, IsReadInThreeLanguages) {
  for (const char* text : {"12 Nov 2026",
                           "Nov. 12, 2026",
                           "12. November 2026",
                           "12 novembre 2026",
                           "12-NOV-26",
                           "12-Nov-2026",
                           "12.Nov.2026",
                           "12/nov/2026",
                           "12NOV2026",
                           "12th November 2026",
                           "November 12th, 2026",
                           "November 12 2026",
                           "2026 Nov 12",
                           "2026-Nov-12",
                           " 12 nov. 2026 ",
                           "Thu Nov 12 09:30:00 2026",
                           "Thu Nov 12 09:30:00 UTC 2026",
                           "12 Nov 2026 09:30",
                           "12-NOV-26 09:30:15 AM",
                           "Donnerstag, den 12. November 2026",
                           "jeudi 12 novembre 2026",
                           "le 12 novembre 2026",
                           "Nov 12, 26",
                           "12 Nov 2026 10h30",
                           "12\u00A0novembre\u00A02026"})
    EXPECT_EQ(iso_date(text), "2026-11-12") << text;
  for (const char* text : {"1er août 2026", "1. August 2026", "AUG 1, 2026", "1 AOÛT 2026", "1 aout 2026"})
    EXPECT_EQ(iso_date(text), "2026-08-01") << text;
  for (const char* text : {"3. März 2026", "3 MAR 2026", "3 mars 2026", "MÄRZ 3, 2026", "3. Mrz. 2026", "3 Maerz 2026"})
    EXPECT_EQ(iso_date(text), "2026-03-03") << text;
  EXPECT_EQ(iso_date("mar. 3 nov. 2026"), "2026-11-03") << "a Tuesday";
  EXPECT_EQ(iso_date("3 févr. 2026"), "2026-02-03");
  EXPECT_EQ(iso_date("14 Juil. 1998"), "1998-07-14");
  EXPECT_EQ(iso_date("24. Dez. 2025"), "2025-12-24");
  EXPECT_EQ(iso_date("15-May-98"), "1998-05-15");
}

TEST(WrittenDate, IsNotGuessed) {
  for (const char* text : {"31 Nov 2026",
                           "0 Nov 2026",
                           "Nov 2026",
                           "Nov 26",
                           "12 Nov",
                           "12 Nov 10:30",
                           "12 Nov 10.30",
                           "12 Nov 10h30",
                           "12 Nov 1030",
                           "12-14 Nov 2026",
                           "12 Nov - 14 Nov 2026",
                           "Nov 12-14, 2026",
                           "12 Nov 2026 - 3 Dec 2026",
                           "12 Nov 2026 or 2027",
                           "12 Nov 026",
                           "12 Nov 26 7",
                           "98-Nov-12",
                           "3 jui 2026",
                           "12 noviembre 2026",
                           "spring 12 2026",
                           "before 12 Nov 2026",
                           "12 Nov 26th",
                           "12x Nov 2026",
                           "None: simulated",
                           "Nov",
                           "",
                           " , "})
    EXPECT_EQ(iso_date(text), "") << text;
}

TEST(WrittenDate, MayNameAMonthAlone) {
  for (const char* text : {"June 2013", "Juni 2013", "juin 2013", "JUN. 2013", "2013 June", "Jun-2013", "June, 2013"}) {
    EXPECT_EQ(named_days(text).first, "2013-06-01") << text;
    EXPECT_EQ(named_days(text).last, "2013-06-30") << text;
  }
  for (const char* text : {"June 13", "13 June", "June", "Summer 2013", "June 2013 to May 2014"})
    EXPECT_EQ(named_days(text).first, "") << text;
}

}  // namespace
}  // namespace axiometry
