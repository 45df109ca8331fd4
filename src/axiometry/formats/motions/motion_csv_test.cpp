// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/motions/motion_csv.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace axiometry::formats {
namespace {

using namespace std::string_literals;
using ::testing::HasSubstr;

MotionFile read_motions(std::string_view text) {
  auto file = read_motion_csv(text);
  if (!file) throw std::logic_error(file.error().to_string());
  return *std::move(file);
}

std::string motion_fault(std::string_view text) {
  const auto file = read_motion_csv(text);
  return file ? "" : file.error().to_string();
}

TEST(MotionCsv, ReadsOneReadingInARow) {
  const auto file = read_motions(
      "# error: eyx\n# machine.name: Mill 5\n# a comment: of no key\nrun;position_m;Direction;Straightness [nm];note\n"
      "2;0,1;-;1500;x\n1;0,2;forward;-250,5;\n1;0,3;up;;\n");
  ASSERT_EQ(file.readings.size(), 2u);  // the third was not taken
  EXPECT_EQ(file.error->text(), "EYX");
  EXPECT_EQ(file.metadata.machine.name, "Mill 5");
  EXPECT_EQ(file.unit, MotionUnit::um);
  EXPECT_EQ(file.readings[0].position_mm, 100.0);
  EXPECT_EQ(file.readings[0].direction, Direction::down);
  EXPECT_EQ(file.readings[0].run, 2u);
  EXPECT_EQ(file.readings[0].value, 1.5);
  EXPECT_EQ(file.readings[1].value, -0.2505);
  ASSERT_EQ(file.remarks.size(), 2u);
  EXPECT_THAT(file.remarks[0].message, HasSubstr("\"note\""));
  EXPECT_THAT(file.remarks[1].message, HasSubstr("no reading was taken at 300 mm"));
}

TEST(MotionCsv, NamesRunsOfWhichNothingWasRead) {
  const auto file = read_motions(
      "position_mm,run,direction,straightness_um\n0,1,up,1\n100,1,up,2\n0,3,up,\n100,3,up,\n100,1,down,\n0,1,down,\n");
  ASSERT_EQ(file.remarks.size(), 1u);
  EXPECT_EQ(file.remarks[0].message, "found rows without any reading of the runs 1 ↓, 3 ↑: these count as not driven");
}

TEST(MotionCsv, SaysWhereAllRowsGoTheOtherWayThanTheirDirection) {
  const auto remarks = [](const std::string& rows) {
    const auto told = read_motions("position_mm,direction,straightness_um\n" + rows).remarks;
    return std::ranges::count_if(told, [](const SourceRemark& r) { return r.message.starts_with("the rows of"); });
  };
  EXPECT_EQ(remarks("0,down,1\n100,down,2\n100,up,2\n0,up,1\n"), 1);
  EXPECT_EQ(remarks("100,up,1\n0,up,2\n0,down,2\n100,down,1\n0,up,1\n100,up,2\n100,down,2\n0,down,1\n"), 1)
      << "the first run alone";
  EXPECT_EQ(remarks("0,up,1\n100,up,2\n100,down,2\n0,down,1\n"), 0);
  EXPECT_EQ(remarks("0,up,1\n100,up,2\n0,down,1\n100,down,2\n"), 0) << "sorted by positions";
}

TEST(MotionCsv, KeepsAnglesInTheUnitTheyAreStatedIn) {
  EXPECT_EQ(read_motions("position_mm,direction,EAX_urad\n0,up,0.1\n").readings[0].value, 0.1);
  EXPECT_EQ(read_motions("position_mm,direction,roll_mrad\n0,up,0.1\n").unit, MotionUnit::urad);
  EXPECT_EQ(read_motions("position_mm,direction,roll_mrad\n0,up,0.1\n").readings[0].value, 100.0);
  EXPECT_EQ(read_motions("position_mm,direction,deviation_arcsec\n0,up,0.1\n").unit, MotionUnit::arcsec);
  EXPECT_EQ(read_motions("position_mm,direction,angle_deg\n0,up,0.001\n").readings[0].value, 3.6);
}

TEST(MotionCsv, ReadsTheInclinationsThatLevelsShow) {
  for (const char* head : {"pitch_um/m", "pitch [µm/m]", "EBX (μm/m)", "roll µm/m", "angle_UM/M"}) {
    const auto file = read_motions("position_mm,direction," + std::string(head) + "\n0,up,0.1\n");
    EXPECT_EQ(file.unit, MotionUnit::urad) << head;
    EXPECT_EQ(file.readings.at(0).value, 0.1) << head;
  }
  EXPECT_EQ(read_motions("position_mm,direction,roll_mm/m\n0,up,0.1\n").readings.at(0).value, 100.0);
  EXPECT_THAT(motion_fault("position_mm,direction,straightness_um/m\n0,up,0.1\n"),
              HasSubstr("found the unit \"um/m\" of the column \"straightness_um/m\", expected one of length"));
  EXPECT_THAT(motion_fault("position_um/m,direction,roll_urad\n0,up,0.1\n"), HasSubstr("a unit of length"));
}

TEST(MotionCsv, ReadsWhichWayReadingsArePositive) {
  constexpr std::string_view rows = "position_mm,direction,deviation_um\n0,up,0.1\n";
  const auto file = read_motions("# positive: -y\n" + std::string(rows));
  EXPECT_EQ(file.sense->text(), "-Y");
  EXPECT_EQ(file.readings[0].value, 0.1);  // as it stands there
  EXPECT_EQ(read_motions("# Positive: −A\n" + std::string(rows)).sense->text(), "-A");
  EXPECT_FALSE(read_motions(rows).sense);
  for (const char* wrong : {"Y", "+", "+YZ", "+D", "", "up", "−"})
    EXPECT_THAT(motion_fault("# positive: " + std::string(wrong) + "\n" + std::string(rows)),
                HasSubstr("as the way readings are positive"))
        << wrong;
  EXPECT_THAT(motion_fault("# positive: +Y\n# positive: -Y\n" + std::string(rows)), HasSubstr("2:1: found readings"));
}

TEST(MotionCsv, AreNoDeviationsOfPositions) {
  const auto fault = [](std::string_view head) {
    const auto checked = check_no_other_error(head);
    return checked ? std::string() : checked.error().message;
  };
  EXPECT_THAT(fault("# error: eyx\ntarget_mm,run,direction,deviation_um\n0,1,up,1\n"),
              HasSubstr("found readings of the error EYX, expected deviations of positions; axiometry straightness"));
  EXPECT_THAT(fault("position_mm,run,direction,pitch_um/m\n0,1,up,1\n"), HasSubstr("axiometry angles evaluates these"));
  EXPECT_THAT(fault("position_mm;pitch_arcsec\n0;1\n"),
              HasSubstr("pitch, expected deviations of positions; axiometry an"));
  EXPECT_THAT(fault("position_mm,EYX_um\n0,1\n"), HasSubstr("EYX"));
  EXPECT_THAT(fault("a\xFF\n# Error: EAX\n"), "");  // below another line it is none
  EXPECT_THAT(fault("#\0 \0e\0r\0r\0o\0r\0:\0 \0E\0Y\0X\0\n\0p\0"s), HasSubstr("EYX"));
  for (const char* position :
       {"# error: EXX\ntarget_mm,run,direction,deviation_um\n0,1,up,1\n", "position_mm,EXX_um\n0,1\n",
        "position_mm,deviation_um\n0,1\n", "target_deg,angle_arcsec\n0,1\n",
        "position_mm,deviation_um,straightness_um\n0,1,2\n", "# errors: EYX and others\ntarget_mm,deviation_um\n", "",
        "{\"a\": 1}", "\x7f\x45\x4c\x46\0"})
    EXPECT_EQ(fault(position), "") << position;
}

Plan plan_of_two_targets() {
  Plan plan;
  plan.axis.name = "X";
  plan.machine = "Mill 5";
  plan.targets = {Position::native(0.0), Position::native(100.0)};
  plan.runs = 2;
  plan.overrun = Position::native(5.0);
  plan.feed = 1000.0;
  return plan;
}

TEST(MotionCsv, TakesPositionsFromAPlan) {
  const std::string rows = "note;EYX_um\na;1\n;2\n;3\n;4\n;5\n;6\n;\n;8\n";
  const auto file = read_planned_motion(rows, plan_of_two_targets());
  ASSERT_TRUE(file) << file.error().to_string();
  ASSERT_EQ(file->readings.size(), 7u);  // the seventh was not taken, and the eighth keeps its place
  // Figure 1 of the standard: up over all targets, then down, run by run.
  const double at[] = {0, 100, 100, 0, 0, 100, 0}, values[] = {1, 2, 3, 4, 5, 6, 8};
  for (std::size_t k = 0; k < 7; ++k) {
    EXPECT_EQ(file->readings[k].position_mm, at[k]) << k;
    EXPECT_EQ(file->readings[k].value, values[k]);
    EXPECT_EQ(file->readings[k].direction, k < 2 || (k > 3 && k < 6) ? Direction::up : Direction::down) << k;
    EXPECT_EQ(file->readings[k].run, k < 4 ? 1u : 2u);
  }
  EXPECT_EQ(file->metadata.machine.name, "Mill 5");
  ASSERT_EQ(file->remarks.size(), 1u);  // of the note, none of a direction that lacks
}

TEST(MotionCsv, RefusesReadingsThatDoNotFitThePlan) {
  const auto fault = [](const std::string& rows, const Plan& plan) {
    const auto file = read_planned_motion(rows, plan);
    return file ? std::string() : file.error().to_string();
  };
  const Plan plan = plan_of_two_targets();
  const std::string eight = "1\n2\n3\n4\n5\n6\n7\n8\n";
  EXPECT_EQ(fault("EYX_um\n" + eight, plan), "");
  EXPECT_THAT(fault("EYX_um\n1\n2\n3\n", plan), HasSubstr("found 3 readings, expected 8"));
  EXPECT_THAT(fault("EYX_um\n" + eight + "9\n", plan), HasSubstr("10:1: found more than 8 readings"));
  EXPECT_THAT(fault("EYY_um\n" + eight, plan), HasSubstr("EYY"));
  EXPECT_THAT(fault("EXY_um\n" + eight, plan), HasSubstr("found readings of EXY with a plan of the axis \"X\""));
  EXPECT_THAT(fault("EYX_um,run\n1,1\n", plan), HasSubstr("1:8: found the column \"run\" beside a plan"));
  EXPECT_THAT(fault("position_mm,EYX_um\n0,1\n", plan), HasSubstr("found the column \"position_mm\" beside a plan"));
  Plan rotary = plan;
  rotary.axis.kind = AxisKind::rotary;
  EXPECT_THAT(fault("EYX_um\n" + eight, rotary), HasSubstr("a rotary axis"));
  Plan several = plan;
  several.further = {plan};
  EXPECT_THAT(fault("EYX_um\n" + eight, several), HasSubstr("further plans"));
}

TEST(MotionCsv, CountsApproachesWhereNothingElseDoes) {
  const auto file = read_motions("position_mm,direction,straightness_um\n0,up,1\n0,down,2\n0,up,3\n");
  EXPECT_EQ(file.readings[1].run, 1u);
  EXPECT_EQ(file.readings[2].run, 2u);
}

TEST(MotionCsv, TakesReadingsWithoutADirectionAsPositiveAndSaysSo) {
  const auto file = read_motions("position_mm,straightness_um\n0,1\n10,2\n");
  EXPECT_EQ(file.readings[1].direction, Direction::up);
  ASSERT_EQ(file.remarks.size(), 1u);
  EXPECT_THAT(file.remarks[0].message, HasSubstr("no column direction"));
  EXPECT_THAT(motion_fault("position_mm,straightness_um\n0,1\n10,2\n10,2\n0,1\n"),
              HasSubstr("4:1: found a position a second"));
}

TEST(MotionCsv, TellsThePositionsOfWhichNoReadingWasTaken) {
  const auto file = read_motions("position_mm,direction,straightness_um\n0,up,1\n10,up,2\n20,up,\n30,up,NA\n");
  ASSERT_EQ(file.remarks.size(), 1u);
  EXPECT_EQ(file.remarks[0].message, "no reading was taken at 20, 30 mm: the figures are those of the other positions");
  std::string many = "position_mm,direction,straightness_um\n0,up,1\n";
  for (int k = 1; k < 9; ++k) many += std::to_string(k) + ",up,\n";
  EXPECT_THAT(read_motions(many).remarks.at(0).message, HasSubstr("at 1, 2, 3, 4, 5, 6, … mm"));
  EXPECT_TRUE(read_motions("position_mm,run,direction,EYX_um\n0,1,up,1\n9,1,up,1\n0,2,up,\n9,2,up,1\n").remarks.empty())
      << "one that another run has is the series' to refuse";
}

TEST(MotionCsv, HoldsTheOrderOfTheRowsAgainstReadingsWithoutADirection) {
  const auto falling = read_motions("position_mm,straightness_um\n20,1\n10,2\n0,3\n");
  ASSERT_EQ(falling.remarks.size(), 1u);
  EXPECT_THAT(falling.remarks[0].message, HasSubstr("the positions fall from row to row"));
  EXPECT_THAT(motion_fault("position_mm,run,straightness_um\n0,1,1\n10,1,2\n10,2,3\n0,2,4\n"),
              HasSubstr("found rising positions in run 1 and falling ones in run 2 and no column direction"));
  EXPECT_THAT(read_motions("position_mm,run,straightness_um\n0,1,1\n0,2,1\n10,2,2\n10,1,3\n").remarks.at(0).message,
              HasSubstr("no column direction: all readings"));
  EXPECT_EQ(motion_fault("position_mm,run,direction,straightness_um\n0,1,+,1\n10,1,+,2\n10,2,+,3\n0,2,+,4\n"), "");
}

TEST(MotionCsv, RefusesKeysThatAreMisspelt) {
  const auto with = [](const std::string& line) {
    return motion_fault("# " + line + "\nposition_mm,direction,straightness_um\n0,up,1\n");
  };
  EXPECT_EQ(with("postive: -Y"), "line 1:1: found the unknown key \"postive\", expected perhaps positive");
  for (const char* line : {"Errror: EYX", "Error2: EYX", "Error_1: eyx", "Error 1: EZX", "Errors: EYX"})
    EXPECT_THAT(with(line), HasSubstr("expected perhaps error")) << line;
  EXPECT_THAT(with("instrument.gian: 1.1"), HasSubstr("expected perhaps instrument.gain"));
  EXPECT_THAT(with("machine.nickname: Otto"), HasSubstr("found the unknown key \"machine.nickname\""));
  for (const char* comment : {"position: left of the table", "mirror: at the spindle", "sensor: LVDT 3", "v1.2: first",
                              "Note: in the evening", "http://example.org", "Error 1: spike at 300 mm",
                              "Errors 2+3: none", "error-log: kept", "Errors: none", "Terror: x", "postive: rising"})
    EXPECT_EQ(with(comment), "") << comment;
}

TEST(MotionCsv, RefusesWhatItCannotUse) {
  const std::pair<std::string_view, std::string_view> faults[] = {
      {"", "empty"},
      {"# error: EYX\n", "found no header"},
      {"position_mm,straightness_um\n", "found no readings"},
      {"position_mm,straightness\n0,1\n", "without a unit"},
      {"position,straightness_um\n0,1\n", "without a unit"},
      {"position_mm,straightness_arcsec\n0,1\n", "1:13: found the unit \"arcsec\""},
      {"position_mm,pitch_um\n0,1\n", "expected one of angle"},
      {"position_deg,straightness_um\n0,1\n", "a unit of length"},
      {"position_mm,EAX_um\n0,1\n", "expected one of angle"},
      {"position_mm,EYX_urad\n0,1\n", "expected one of length"},
      {"# error: EAX\nposition_mm,deviation_um\n0,1\n", "EAX in µm, expected readings of an angle"},
      {"# error: EYX\nposition_mm,deviation_urad\n0,1\n", "expected readings of a length"},
      {"# error: EYX\n# error: EZX\nposition_mm,deviation_um\n0,1\n", "EZX after EYX"},
      {"# error: EYX\nposition_mm,EZX_um\n0,1\n", "EZX after EYX"},
      {"# error: yaw\nposition_mm,deviation_um\n0,1\n", "1:1: found the error \"yaw\""},
      {"position_mm,straightness_um,pitch_urad\n0,1,2\n", "beside"},
      {"position_mm,run\n0,1\n", "no column straightness_um"},
      {"run,straightness_um\n0,1\n", "no column position_mm"},
      {"position_mm,direction,straightness_um\n0,,1\n", "2:3: found the direction \"\""},
      {"position_mm,direction,straightness_um\n0,sideways,1\n", "sideways"},
      {"position_mm,run,straightness_um\n0,0,1\n", "2:3"},
      {"position_mm,straightness_um\n0,one\n", "2:3"},
      {"position_mm,straightness_um\n0,nan\n", "2:3"},
      {"position_mm,straightness_um\nx,1\n", "2:1"},
      {"position_mm,straightness_um\n0,1,2\n", "3"},
      {"position_mm,run,straightness_um\n0,1", "2"},
  };
  for (const auto& [text, message] : faults) {
    const std::string fault = motion_fault(text);
    EXPECT_NE(fault, "") << text;
    EXPECT_THAT(fault, HasSubstr(std::string(message))) << text;
  }
}

TEST(MotionCsv, RefusesAPlanThatIsMadeForAnotherError) {
  Plan plan = plan_of_two_targets();
  const auto fault = [&](std::optional<MotionName> error, MotionUnit unit = MotionUnit::um) {
    const auto checked = check_error_of_plan(error, unit, plan);
    return checked ? std::string() : checked.error().message;
  };
  const MotionName eyx{'Y', 'X'}, ezx{'Z', 'X'}, eax{'A', 'X'};
  EXPECT_EQ(fault(eyx), "") << "a plan of positions fits";
  EXPECT_EQ(fault({}), "");
  plan.errors = {ezx, eax};
  EXPECT_EQ(fault(ezx), "");
  EXPECT_EQ(fault(eax, MotionUnit::arcsec), "");
  EXPECT_EQ(fault({}), "");
  EXPECT_EQ(fault(eyx), "found readings of EYX with a plan made for EZX, EAX, expected one made for EYX");
  EXPECT_EQ(error_of_plan(plan, MotionUnit::um), ezx);
  EXPECT_EQ(error_of_plan(plan, MotionUnit::urad), eax);
  plan.errors = {ezx, eyx};
  EXPECT_EQ(error_of_plan(plan, MotionUnit::um), std::nullopt) << "either";
  EXPECT_EQ(fault({}, MotionUnit::urad),
            "found readings in µrad with a plan made for EZX, EYX, expected one made for a rotation such as EAX");
  plan.errors = {eax, {'X', 'X'}};
  EXPECT_EQ(fault({}),
            "found readings in µm with a plan made for EAX, EXX, expected one made for a straightness such "
            "as EYX");
  const auto read = read_planned_motion("EYX_um\n1\n2\n3\n4\n5\n6\n7\n8\n", plan);
  ASSERT_FALSE(read);
  EXPECT_THAT(read.error().message, HasSubstr("found readings of EYX with a plan made for EAX, EXX"));
}

}  // namespace
}  // namespace axiometry::formats
