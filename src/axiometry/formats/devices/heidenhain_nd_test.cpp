// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "axiometry/formats/format.h"

namespace axiometry::formats {
namespace {

Result<Test> read_nd(const std::string& text) {
  const auto format = recognise(text);
  EXPECT_TRUE(format && (*format)->id == "heidenhain-nd");
  return find_format("heidenhain-nd")->read(text);
}

TEST(HeidenhainNd, ReadsPositionsAndValues) {
  const auto test = read_nd(
      "#\r\nND-280             MM\r\nAXIS X1       =      0\r\nX1 FCT. X1    =      0\r\nDATUM         =  +     "
      "0.0000\r\n"
      "COMP. N0. 000 =  +     0.0000 =  +     0.0000\r\nCOMP. NO. 001 =  +    10.5000 =  -     0.0015\r\n"
      "COMP. NO. 002 =    ---------- =    ----------\r\n#\r\n");
  ASSERT_TRUE(test) << test.error().to_string();
  EXPECT_EQ(test->series.target_count(), 2u);
  EXPECT_EQ(test->series.targets()[1].in_native(), 10.5);
  EXPECT_NEAR(test->series.reading(1, Direction::up, 0)->in_native(), -1.5, 1e-12);
  EXPECT_FALSE(test->series.has(Direction::down));
  EXPECT_EQ(test->metadata.axis.name, "X1");
  EXPECT_EQ(test->metadata.conditions.comment, "Compensation table of ND-280");
  ASSERT_EQ(test->provenance.remarks.size(), 1u);
  EXPECT_TRUE(test->provenance.remarks[0].departs);
}

TEST(HeidenhainNd, CountsPositionsFromDatumAndSpacing) {
  const std::string tail =
      "DATUM X       =  +      5.000\nX     NR. 00  =  +      0.000\nX     NR. 01  =    ----------\n"
      "X     NR. 02  =  +      0.003\n*\n";
  const auto exponent =
      read_nd("*\nND-720       MM\nAXIS X        =      0\nX FCT. X      =      0\nSPACING X     =     16\n" + tail);
  ASSERT_TRUE(exponent) << exponent.error().to_string();
  EXPECT_DOUBLE_EQ(exponent->series.targets()[1].in_native(), 5 + 2 * 6.5536);
  EXPECT_NEAR(exponent->series.reading(1, Direction::up, 0)->in_native(), 3, 1e-12);
  const auto length = read_nd("*\nND-720       MM\nPKTABST.      =     20.0\n" + tail);
  ASSERT_TRUE(length) << length.error().to_string();
  EXPECT_EQ(length->series.targets()[1].in_native(), 45);
}

TEST(HeidenhainNd, ReadsInchesAndAngles) {
  const auto inch = read_nd("#\nND-287 INCH\nCOMP. NO. 000 = 0 = 0\nCOMP. NO. 001 = 1 = .0001\n#\n");
  ASSERT_TRUE(inch) << inch.error().to_string();
  EXPECT_DOUBLE_EQ(inch->series.targets()[1].in_native(), 25.4);
  EXPECT_NEAR(inch->series.reading(1, Direction::up, 0)->in_native(), 2.54, 1e-12);
  const auto dms = read_nd("*\nND-281 B DMS\nCMP. NR. 00 = + 0.00.00\nCMP. NR. 02 = - 0.01.03\n*\n");
  ASSERT_TRUE(dms) << dms.error().to_string();
  EXPECT_EQ(dms->metadata.axis.kind, AxisKind::rotary);
  EXPECT_EQ(dms->series.targets()[1].in_native(), 10);
  EXPECT_NEAR(dms->series.reading(1, Direction::up, 0)->in_native(), -63, 1e-9);
}

TEST(HeidenhainNd, RefusesWhatIsBroken) {
  const auto message = [](const std::string& text) {
    const auto test = read_nd(text);
    return test ? "no error" : test.error().to_string();
  };
  const std::string head = "*\nND-231 B MM\nSPACING = 14\n";
  EXPECT_EQ(message(head + "CMP. NR. 00 = 0\nCMP. NR. 01 = 1\n"),
            "found no end mark, expected # or * behind the last value; is the table cut off?");
  EXPECT_EQ(message(head + "CMP. NR. 00 = 0\nCMP. NR. 00 = 1\n*\n"),
            "line 5:1: found point 0 again, expected only that on line 4");
  EXPECT_EQ(message("*\nND-231 B MM\nX1 FCT. Y1 = 1\n*\n"),
            "line 3:1: found \"X1 FCT. Y1\", expected the error of an axis as a function of itself");
  EXPECT_EQ(message("*\nND-231 B MM\nCMP. NR. 01 = 1\n*\n"),
            "line 3:15: found point 1 without a position, expected a line SPACING");
  EXPECT_EQ(message("*\nND-231 B MM\nSPACING = 99\n*\n"),
            "line 3:11: found the spacing \"99\", expected a length with a decimal mark or an exponent up to 30");
  EXPECT_EQ(message(head + "*\n"), "found no compensation values, expected at least two");
  EXPECT_EQ(
      message(head + "*\n*\nND-231 B MM\n"),
      "line 6:1: found \"ND-231 B MM\" behind the end mark, expected one table; a file of several must be parted");
  EXPECT_EQ(message("*\nND-231 B\n"),
            "line 2:1: found \"ND-231 B\", expected model and unit of the read-out (MM, IN, DEC or DMS)");
  EXPECT_EQ(message("*\nND-281 B DMS\nCMP. NR. 00 = 0.75.00\n*\n"),
            "line 3:15: found \"0.75.00\", expected degrees.minutes.seconds");
}

TEST(HeidenhainNd, IsRecognisedByMarkAndModel) {
  const Format& format = *find_format("heidenhain-nd");
  EXPECT_EQ(format.recognise("#\nND 231 B MM\n"), 96);
  EXPECT_EQ(format.recognise("#\nNDA agreement\n"), 0);
  EXPECT_EQ(format.recognise("ND-280 MM\n"), 0);
}

}  // namespace
}  // namespace axiometry::formats
