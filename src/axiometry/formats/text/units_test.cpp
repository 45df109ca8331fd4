// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/text/units.h"

#include <gtest/gtest.h>

namespace axiometry::formats {
namespace {

TEST(Units, AreFoundByNameSymbolAndUsualSpelling) {
  for (std::string_view spelling : {"um", "UM", "µm", "\u03BCm", "micron", "Micrometres", "\u00C2\u00B5m"}) {
    ASSERT_NE(find_unit(spelling), nullptr) << spelling;
    EXPECT_EQ(find_unit(spelling)->name, "um") << spelling;
  }
  EXPECT_EQ(find_unit("°")->name, "deg");
  EXPECT_EQ(find_unit("″")->name, "arcsec");
  EXPECT_EQ(find_unit("furlong"), nullptr);
}

TEST(Units, AreUnderstoodAfterAWrongCodePage) {
  ASSERT_NE(find_unit("\u00C2\u00B0"), nullptr);
  EXPECT_EQ(find_unit("\u00C2\u00B0")->name, "deg");
  EXPECT_EQ(find_unit("\u00C2"), nullptr);
}

TEST(Units, KeepNativeNumbersAsTheyWereWritten) {
  for (double x : {0.1, 1234.304, 1e-9, 123456.789}) {
    EXPECT_EQ(position_in(*find_unit("mm"), x).in_native(), x);
    EXPECT_EQ(position_in(*find_unit("deg"), x).in_native(), x);
    EXPECT_EQ(deviation_in(*find_unit("um"), x).in_native(), x);
    EXPECT_EQ(deviation_in(*find_unit("arcsec"), x).in_native(), x);
  }
}

TEST(Units, AreConvertedByTheirDefinition) {
  EXPECT_EQ(deviation_in(*find_unit("mm"), 0.25).in_native(), 250.0);
  EXPECT_EQ(deviation_in(*find_unit("nm"), 250).in_native(), 0.25);
  EXPECT_EQ(deviation_in(*find_unit("uin"), 10).in_native(), 0.254);
  EXPECT_EQ(position_in(*find_unit("in"), 2).in_native(), 50.8);
  EXPECT_EQ(position_in(*find_unit("um"), 500).in_native(), 0.5);
  EXPECT_EQ(deviation_in(*find_unit("deg"), 0.5).in_native(), 1800.0);
  EXPECT_NEAR(deviation_in(*find_unit("mrad"), 1).in_native(), 206.264806247096355, 1e-13);
}

TEST(Units, GiveDeviationsFromMeasuredPositions) {
  const ReadingRule rule{Measured::position, find_unit("mm")};
  EXPECT_EQ(*native_deviation(rule, Position::native(100), 100.0012), 1.2);
  EXPECT_EQ(*native_deviation(rule, Position::native(100), 99.9988), -1.2);
  EXPECT_EQ(*native_deviation(rule, Position::native(1744.2), 1744.2003), 0.3);
  const ReadingRule turn{Measured::position, find_unit("deg")};
  EXPECT_EQ(*native_deviation(turn, Position::native(270), 270.0001), 0.36);
}

TEST(Units, KeepDecimalsDecimalsInEveryUnit) {
  EXPECT_NE(0.0041 * 1000.0, 4.1);
  EXPECT_EQ(deviation_in(*find_unit("mm"), 0.0041).in_native(), 4.1);
  EXPECT_EQ(deviation_in(*find_unit("mm"), 0.0003).in_native(), 0.3);
  EXPECT_EQ(deviation_in(*find_unit("m"), 1.1e-6).in_native(), 1.1);
  EXPECT_EQ(deviation_in(*find_unit("in"), 0.00001).in_native(), 0.254);
  EXPECT_EQ(deviation_in(*find_unit("deg"), 0.0001).in_native(), 0.36);
  EXPECT_EQ(position_in(*find_unit("um"), 100.3).in_native(), 0.1003);
  EXPECT_EQ(position_in(*find_unit("m"), 1.0003).in_native(), 1000.3);
}

TEST(Units, RefuseWhatNoMachineDoes) {
  const ReadingRule turn{Measured::position, find_unit("deg")};
  EXPECT_EQ(native_deviation(turn, Position::native(0), 359.5).error().message,
            "found a measured position 359.5° from its target, expected both within half a turn");
  const ReadingRule far{Measured::deviation, find_unit("mm")};
  EXPECT_EQ(native_deviation(far, Position::native(0), 2e6).error().message,
            "found a deviation of 2e+09 µm, expected a magnitude up to 1e9");
  EXPECT_EQ(kind_of(*find_unit("mm"), *find_unit("arcsec")).error().message,
            "found targets in mm and readings in arcsec, expected both as lengths or both as angles");
}

}  // namespace
}  // namespace axiometry::formats
