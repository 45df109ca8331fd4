// SPDX-License-Identifier: Apache-2.0
//
// Positioning errors in files of volumetric errors: Etalon's exchange format and ISG's tables.
#include <gtest/gtest.h>

#include <map>

#include "axiometry/formats/format.h"
#include "tests/support/pieces.h"

namespace axiometry::formats {
namespace {

const std::string etalon_x =
    "// Errors\n[C0B]\nVALUE = 0.000022355737\n[EYX]\nGridpoints = {\n 0 1\n 9 broken?\n}\n[EXX]\nGridpoints = {\n"
    "   -280.0 -0.001358635132\n   -270.0 -.0002 // second\n\n   260.0 1.5e-3\n}  // end of EXX\n";
const std::string etalon_z = "[EZZ]\r\nGridpoints = { 0 0\r\n 50 0.002 }\r\n";
const std::string isg =
    "// X axis\nX EXX EYX ECX\n0.0 0.001 5 5\n10.0 -.002 5 5\n# next\nZ;X;EXX\n0;0;0.001\n100;0;0.002\n"
    "0;5;0.003\n100;5;0.004\n";

const Format& format_of(const std::string& text) {
  const auto format = recognise(text);
  EXPECT_TRUE(format) << format.error().to_string();
  return **format;
}

std::map<std::string, Series> all_of(const std::string& text) {
  const Format& format = format_of(text);
  EXPECT_TRUE(format.holds_many(text));
  testing_support::Pieces pieces(text, 7);
  std::map<std::string, Series> found;
  const auto done = format.read_many(pieces, [&](NamedTest&& test) -> Result<void> {
    EXPECT_TRUE(!test.remarks.empty() && test.remarks[0].departs) << "an error table is no measurement";
    found.emplace(test.name, std::move(test.series));
    return {};
  });
  EXPECT_TRUE(done) << done.error().to_string();
  return found;
}

std::string curves_error(const std::string& text) {
  const auto test = format_of(text).read(text);
  return test ? "no error" : test.error().to_string();
}

TEST(EtalonExchange, ReadsThePositioningErrorOfAnAxis) {
  const Format& format = format_of(etalon_x);
  EXPECT_EQ(format.id, "etalon-exchange");
  EXPECT_FALSE(format.holds_many(etalon_x));
  const auto test = format.read(etalon_x);
  ASSERT_TRUE(test) << test.error().to_string();
  EXPECT_EQ(test->series.target_count(), 3u);
  EXPECT_EQ(test->series.targets()[0].in_native(), -280);
  EXPECT_NEAR(test->series.reading(0, Direction::up, 0)->in_native(), -1.358635132, 1e-12);
  EXPECT_NEAR(test->series.reading(2, Direction::up, 0)->in_native(), 1.5, 1e-12);
  EXPECT_EQ(test->metadata.axis.name, "X");
  EXPECT_TRUE(test->provenance.remarks[0].departs);
}

TEST(EtalonExchange, MakesATestOfEveryAxis) {
  const auto tests = all_of(etalon_x + etalon_z);
  ASSERT_EQ(tests.size(), 2u);
  EXPECT_NEAR(tests.at("EZZ").reading(1, Direction::up, 0)->in_native(), 2, 1e-12);
}

TEST(EtalonExchange, RefusesWhatIsBroken) {
  EXPECT_EQ(curves_error("[EXX]\nGridpoints = {\n 0 0\n 1 0\n"),
            "line 1:1: found no } behind the grid points of EXX, expected one; is the file cut off?");
  EXPECT_EQ(curves_error("[EXX]\nGridpoints = {\n 0 0\n 1\n}\n"),
            "line 4:2: found \"1\", expected two numbers: position and error");
  EXPECT_EQ(curves_error("[EXX]\nGridpoints = {\n 0 0\n 1 nan\n}\n"),
            "line 4:4: found \"nan\", expected a finite number");
  EXPECT_EQ(curves_error("[EYX]\nGridpoints = {\n 0 0\n 1 1\n}\n"),
            "found no positioning error of a linear axis, expected one of EXX, EYY and EZZ");
  EXPECT_EQ(curves_error("[EXX]\nGridpoints = {\n 0 0\n 0 1\n}\n"),
            "line 4:4: found a second reading of target 0↑ run 1, expected only that on line 3");
  EXPECT_EQ(curves_error(etalon_x + etalon_x), "line 24:1: found a second block EXX, expected only that on line 9");
  EXPECT_EQ(curves_error(etalon_x + etalon_z), "line 16:1: found 2 positioning errors (EXX, EZZ), expected one test");
}

TEST(IsgCsv, ReadsThePositioningErrorsAmongOthers) {
  const std::string one = isg.substr(0, isg.find('#'));
  EXPECT_EQ(format_of(one).id, "isg-csv");
  const auto test = format_of(one).read(one);
  ASSERT_TRUE(test) << test.error().to_string();
  EXPECT_NEAR(test->series.reading(1, Direction::up, 0)->in_native(), -2, 1e-12);
  EXPECT_TRUE(test->provenance.remarks[0].departs);
}

TEST(IsgCsv, MakesATestOfEveryValueOfAnotherArgument) {
  const auto tests = all_of(isg);
  ASSERT_EQ(tests.size(), 3u);
  EXPECT_NEAR(tests.at("EXX Z=100").reading(1, Direction::up, 0)->in_native(), 4, 1e-12);
  EXPECT_EQ(tests.at("EXX Z=0").targets()[1].in_native(), 5);
}

TEST(IsgCsv, RefusesWhatIsBroken) {
  EXPECT_EQ(curves_error("X EXX\n0 0\n1\n"), "line 3:1: found 1 number, expected 2 as in the header on line 1");
  EXPECT_EQ(curves_error("X EXX\n0 0\n1 one\n"), "line 3:3: found \"one\", expected a finite number");
  EXPECT_EQ(curves_error("X EXX EXX\n0 0 0\n"),
            "line 1:1: found \"EXX\" twice in the header, expected each column once");
  EXPECT_EQ(curves_error("Y EXX\n0 0\n"), "line 1:1: found EXX without a column X, expected its positions");
  EXPECT_EQ(curves_error("X EXX\n0 0\n#\n0 0\n"),
            "line 4:1: found \"0 0\", expected a header of arguments and errors such as X EXX EYX");
  EXPECT_EQ(curves_error("X EYX\n0 0\n1 1\n"),
            "found no positioning error of a linear axis, expected one of EXX, EYY and EZZ");
}

TEST(IsgCsv, TakesNoOtherTextForErrors) {
  for (const char* text : {"ABC\n1\n", "CAB X\n1 2\n", "X Y Z\n1 2 3\n", "#\n", "//\n"})
    EXPECT_EQ(find_format("isg-csv")->recognise(text), 0) << text;
}

}  // namespace
}  // namespace axiometry::formats
