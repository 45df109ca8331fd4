// SPDX-License-Identifier: Apache-2.0
//
// Tables that move another axis than the one at whose positions they stand.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "axiometry/language/language.h"
#include "axiometry/nc/axis_table.h"

namespace axiometry::nc {
namespace {

AxisCorrection leaning(std::vector<double> down) {
  return AxisCorrection::make(AxisKind::linear, {0.0, 100.0, 200.0}, {0.0, 5.0, 12.0}, std::move(down)).value();
}

std::string why_refused(const Result<std::string>& text) {
  if (text) return "written: " + *text;
  EXPECT_TRUE(language::is_known(text.error().message, language::Language::german)) << text.error().message;
  return text.error().message;
}

TEST(CrossTables, OfPmacNameSourceAndTarget) {
  const AxisTable& pmac = **axis_table_named("pmac");
  AxisTableOptions options;
  options.number = 1;
  options.output_axis = "2";
  options.resolution = 0.5;
  const AxisCorrection correction = leaning({0.0, 5.0, 12.0});
  const std::string text = write_table(pmac, correction, options).value();
  // Entries of 1/16 count: 5 µm are 10 counts of 0.5 µm, 160; home at 0, three sections of 100 mm, 200 000 counts each.
  EXPECT_NE(text.find("\n#2 DEFINE COMP 3,#1,#2,600000\n160\n384\n0\nI51=1\n"), std::string::npos) << text;
  const AxisCorrection back = read_table(pmac, text, options).value();
  EXPECT_NEAR(back.at(100.0, Direction::down), 5.0, 0.02);
  EXPECT_NEAR(back.at(200.0, Direction::up), 12.0, 0.02);

  AxisTableOptions own = options;
  own.output_axis.clear();
  EXPECT_FALSE(read_table(pmac, text, own)) << "a table that moves another motor is none of this axis";
  EXPECT_FALSE(read_table(pmac, write_table(pmac, correction, own).value(), options));
  options.output_axis = "3";
  EXPECT_FALSE(read_table(pmac, text, options));
}

TEST(CrossTables, OfPmacAreRefusedWhereNoMotorCouldDoIt) {
  const AxisTable& pmac = **axis_table_named("pmac");
  AxisTableOptions options;
  options.number = 1;
  options.output_axis = "#2";
  EXPECT_NE(why_refused(write_table(pmac, leaning({0.0, 4.0, 12.0}), options)).find("expected one for both"),
            std::string::npos);
  for (const char* motor : {"Y", "0", "1", "33", "#", "2.0"}) {
    options.output_axis = motor;
    EXPECT_NE(why_refused(write_table(pmac, leaning({0.0, 5.0, 12.0}), options)).find("number of its motor"),
              std::string::npos)
        << motor;
  }
}

TEST(CrossTables, OfMarlinAreSquarenessAlone) {
  const AxisTable& skew = **axis_table_named("marlin-skew");
  const AxisCorrection line = AxisCorrection::make(AxisKind::linear, {-50.0, 150.0}, {-3.0, 9.0}, {-3.0, 9.0}).value();
  for (const auto& [along, moved, letter] :
       {std::tuple("Y", "X", 'I'), std::tuple("Z", "X", 'J'), std::tuple("z", "y", 'K')}) {
    AxisTableOptions options;
    options.axis = along;
    options.output_axis = moved;
    const std::string text = write_table(skew, line, options).value();
    // 12 µm over 200 mm is 0.00006; the firmware takes factor × position off, so that more of X is a negative factor.
    EXPECT_NE(text.find(std::string("\nM852 ") + letter + "-0.00006000\nM500\n"), std::string::npos) << text;
    const AxisCorrection back = read_table(skew, text, options).value();
    EXPECT_NEAR(back.at(150.0, Direction::up) - back.at(-50.0, Direction::up), 12.0, 1e-9);
    EXPECT_NEAR(back.at(100.0, Direction::down), 6.0, 1e-9) << "it counts from 0";
  }
  AxisTableOptions wrong;
  wrong.axis = "X";
  wrong.output_axis = "Y";
  EXPECT_NE(why_refused(write_table(skew, line, wrong)).find("expected X by Y, X by Z or Y by Z"), std::string::npos);
  wrong.output_axis.clear();
  EXPECT_NE(why_refused(write_table(skew, line, wrong)).find("expected X by Y"), std::string::npos);
  AxisTableOptions options;
  options.axis = "Y";
  options.output_axis = "X";
  options.reference = 10.0;
  EXPECT_NE(why_refused(write_table(skew, line, options)).find("expected 0, from where M852 counts"),
            std::string::npos);
  options.reference = 0.0;
  options.in_inch = true;
  EXPECT_NE(why_refused(write_table(skew, line, options)).find("inch given"), std::string::npos);
  options.in_inch = false;
  const AxisCorrection steep = AxisCorrection::make(AxisKind::linear, {0.0, 1.0}, {0.0, 1500.0}, {0.0, 1500.0}).value();
  EXPECT_NE(why_refused(write_table(skew, steep, options)).find("expected -1 to 1"), std::string::npos);
  for (const char* bad : {"M852 I0.1\n", "M852 J0.1\nM500\n", "M852 I0.1 J0.2\nM500\n", "M852 I0.1\nM852 I0.1\nM500\n",
                          "M500\n", "; range 5 to 1\nM852 I0.1\nM500\n", "M852 Ix\nM500\n", "M852 I5\nM500\n"})
    EXPECT_FALSE(read_table(skew, bad, options)) << bad;
}

}  // namespace
}  // namespace axiometry::nc
