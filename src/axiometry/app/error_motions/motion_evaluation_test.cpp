// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/error_motions/motion_evaluation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace axiometry::app {
namespace {

using ::testing::HasSubstr;

constexpr std::string_view straight_rows = "position_mm,straightness_um\n0,1\n400,2\n800,3.5\n";

/// Why a file of straightness is refused; empty where it is not.
std::string straight_fault(const std::string& head, std::string_view rows = straight_rows) {
  const std::string bytes = head + std::string(rows);
  const auto measured = measure_straightness({.file = "a.csv", .options = {}, .bytes = bytes});
  return measured ? "" : measured.error().message;
}

std::string square_fault(const std::string& first, const std::string& second) {
  const std::string one = first + std::string(straight_rows), two = second + std::string(straight_rows);
  SquarenessRequest request;
  request.first = "a.csv";
  request.second = "b.csv";
  request.bytes = {one, two};
  const auto measured = measure_squareness(request);
  return measured ? "" : measured.error().message;
}

TEST(MotionEvaluation, RefusesAFileOfAnotherAxisThanThatOfItsError) {
  EXPECT_THAT(straight_fault("# error: EYX\n# axis.name: Z\n"),
              HasSubstr("found readings of EYX in a file of the axis"));
  EXPECT_THAT(straight_fault("# error: EYX\n# axis.name: z 2\n"), HasSubstr("expected one of X"));
  for (const char* name : {"X", "x", "X1", "X axis", "Table", "V"})
    EXPECT_EQ(straight_fault("# error: EYX\n# axis.name: " + std::string(name) + "\n"), "") << name;
  EXPECT_EQ(straight_fault("# axis.name: Z\n"), "") << "no error is named";
  EXPECT_THAT(square_fault("# positive: +Y\n# axis.name: Z\n", "# positive: -X\n"), HasSubstr("the axis 'Z'"))
      << "the senses name the errors";
}

TEST(MotionEvaluation, RefusesAGainAndASignThatItDoesNotApply) {
  EXPECT_THAT(straight_fault("# instrument.gain: 2\n"), HasSubstr("instrument.gain: 2"));
  EXPECT_THAT(straight_fault("# instrument.sign_reversed: yes\n"), HasSubstr("# positive: -Y"));
  EXPECT_EQ(straight_fault("# instrument.gain: 1\n# instrument.sign_reversed: no\n"), "");
}

TEST(MotionEvaluation, TakesNoDeviationsOfPositionsForAStraightness) {
  constexpr std::string_view rows = "target_mm,direction,run,deviation_um\n0,up,1,1\n400,up,1,2\n800,up,1,3.5\n";
  EXPECT_THAT(straight_fault("", rows), HasSubstr("may be those of positions"));
  EXPECT_EQ(straight_fault("# error: EYX\n", rows), "");
  EXPECT_EQ(straight_fault("# positive: +Y\n", rows), "");
  const std::string bytes(rows);
  EXPECT_TRUE(measure_straightness({.file = "a.csv", .error = MotionName{'Y', 'X'}, .options = {}, .bytes = bytes}));
}

TEST(MotionEvaluation, HasFilesOfOneMachine) {
  EXPECT_THAT(square_fault("# error: EYX\n# machine.name: M5\n", "# error: EXY\n# machine.name: M6\n"),
              HasSubstr("found the machines 'M5' and 'M6', expected files of one"));
  EXPECT_THAT(square_fault("# machine.name: M5\n# machine.serial_number: 1\n",
                           "# machine.name: m5 \n# machine.serial_number: 2\n"),
              HasSubstr("serial numbers '1' and '2'"));
  EXPECT_EQ(square_fault("# machine.name: M5\n# machine.serial_number: 1\n", "# machine.name: m5\n"), "");
  EXPECT_EQ(square_fault("# machine.name: M5\n", ""), "");
  const std::string one = "# machine.name: M5\nposition_mm,EAX_urad\n0,1\n400,2\n";
  const std::string two = "# machine.name: M6\nposition_mm,EBX_urad\n0,1\n400,2\n";
  AnglesRequest request;
  request.files = {{.file = "a.csv", .options = {}, .bytes = one}, {.file = "b.csv", .options = {}, .bytes = two}};
  const auto measured = measure_angles(request);
  ASSERT_FALSE(measured);
  EXPECT_THAT(measured.error().message, HasSubstr("expected files of one"));
}

}  // namespace
}  // namespace axiometry::app
