// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/error_motions/motion_evaluation.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <variant>
#include <vector>

#include "axiometry/app/error_motions/motion_tables.h"
#include "axiometry/language/language.h"

namespace axiometry::app {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

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
  EXPECT_THAT(square_fault("# positive: +Y\n# axis.name: Z\n", "# positive: -X\n"), HasSubstr("the axis \"Z\""))
      << "the senses name the errors";
}

TEST(MotionEvaluation, SaysThatSensesTellAnotherErrorThanTheFile) {
  const std::string rows(straight_rows), one = "# error: EYX\n" + rows, two = "# error: EXY\n" + rows;
  SquarenessRequest request;
  request.first = "a.csv";
  request.second = "b.csv";
  request.bytes = {one, two};
  request.senses = std::array{reading_sense("+Y").value(), reading_sense("+Z").value()};
  const auto measured = measure_squareness(request);
  ASSERT_FALSE(measured);
  EXPECT_EQ(measured.error().message, "found the error EYX in the file, expected EYZ by the senses of both lines");
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
              HasSubstr("found the machines \"M5\" and \"M6\", expected files of one"));
  EXPECT_THAT(square_fault("# machine.name: M5\n# machine.serial_number: 1\n",
                           "# machine.name: m5 \n# machine.serial_number: 2\n"),
              HasSubstr("serial numbers \"1\" and \"2\""));
  EXPECT_EQ(square_fault("# machine.name: M5\n# machine.serial_number: 1\n", "# machine.name: m5\n"), "");
  EXPECT_EQ(square_fault("# machine.name: DMU 50\n# machine.serial_number: 12a\n",
                         "# machine.name: DMU50\n# machine.serial_number: 12A \n"),
            "")
      << "one serial number is one machine";
  EXPECT_THAT(square_fault("# machine.name: M5\n# machine.serial_number: 1\n", "# machine.name: M6\n"),
              HasSubstr("the machines \"M5\" and \"M6\""));
  EXPECT_EQ(square_fault("# machine.name: M5\n", ""), "");
  const std::string one = "# machine.name: M5\nposition_mm,EAX_urad\n0,1\n400,2\n";
  const std::string two = "# machine.name: M6\nposition_mm,EBX_urad\n0,1\n400,2\n";
  AnglesRequest request;
  request.files = {{.file = "a.csv", .options = {}, .bytes = one}, {.file = "b.csv", .options = {}, .bytes = two}};
  const auto measured = measure_angles(request);
  ASSERT_FALSE(measured);
  EXPECT_THAT(measured.error().message, HasSubstr("expected files of one"));
}

/// Cells of the first row whose first is `name`, in any table; empty without one.
std::vector<std::string> row_of(const report::Document& document, std::string_view name) {
  for (const report::Section& section : document.sections)
    for (const report::Block& block : section.blocks)
      if (const auto* table = std::get_if<report::Table>(&block))
        for (const auto& row : table->rows)
          if (report::plain_text(row.front().text) == name) {
            std::vector<std::string> cells;
            for (const report::TableCell& cell : row) cells.push_back(report::plain_text(cell.text));
            return cells;
          }
  return {};
}

report::Document straight_document(const std::string& bytes) {
  const auto measured = measure_straightness({.file = "/home/me/a.csv", .options = {}, .bytes = bytes});
  if (!measured) throw std::logic_error(measured.error().message);
  return present(*measured, {}, {.report = true, .json = false}).document;
}

TEST(MotionReport, SaysWhatItIsOf) {
  const auto document = straight_document(
      "# machine.name: M5\n# machine.serial_number: 11\n# axis.name: X\n# test.date: 2026-11-26\n"
      "# test.inspector: A. Tester\n" +
      std::string(straight_rows));
  EXPECT_EQ(row_of(document, "File").at(1), "a.csv");
  EXPECT_EQ(row_of(document, "SHA-256 of the file").at(1).size(), 64u);
  EXPECT_EQ(row_of(document, "Date of test").at(1), "2026-11-26");
  EXPECT_THAT(row_of(document, "Program").at(1), HasSubstr("Axiometry "));
  std::string identity;
  for (const report::Fact& fact : document.identity)
    identity += report::plain_text(fact.name) + ": " + report::plain_text(fact.value.text) + "\n";
  EXPECT_THAT(identity, HasSubstr("Machine: M5\nSerial number: 11\nAxis: X\nDate of test: 2026-11-26\nInspector: A. "
                                  "Tester\n"));
  EXPECT_EQ(document.date, "2026-11-26");
}

TEST(MotionReport, HasAnUncertaintyOfTheAngleOfALineAndNoRoundingForAValue) {
  const auto level = straight_document("position_mm,straightness_um\n0,1\n4,2\n8,1\n");
  const std::vector<std::string> angle = row_of(level, "Angle of the line, θ");
  ASSERT_EQ(angle.size(), 5u);
  EXPECT_FALSE(angle[2].contains("e")) << angle[2];
  EXPECT_TRUE(report::is_number(angle[3])) << angle[3];
  const auto straight = straight_document("position_mm,straightness_um\n0,0.1\n4,0.1\n8,0.1\n");
  EXPECT_EQ(row_of(straight, "Angle of the line, θ").at(2), "0");
  EXPECT_EQ(row_of(straight, "Straightness, range of the residuals").at(2), "0");
}

/// A second run that is the first one's copy knows no more than that, and nothing of the truth.
TEST(MotionReport, HasNoUncertaintyOfNothingWhereRunsAgreeToTheLastDigit) {
  const std::string rows = "position_mm,run,straightness_um\n0,1,1\n400,1,2\n800,1,3.5\n0,2,1\n400,2,2\n800,2,3.5\n";
  const auto copied = straight_document(rows);
  for (const char* row : {"Straightness, range of the residuals", "Slope of the line", "Line at position 0"})
    EXPECT_EQ(row_of(copied, row).at(3), "–") << row;
  const auto alone = measure_straightness({.file = "a.csv", .options = {}, .bytes = rows});
  ASSERT_TRUE(alone);
  const std::string why = "the runs agree to the last digit: they tell nothing of how far they are from the truth";
  EXPECT_EQ(std::ranges::count(alone->remarks, why), 1);
  EXPECT_TRUE(language::is_known(why, language::Language::german));
  MotionRequest request{.file = "a.csv", .options = {}, .bytes = rows};
  request.options.instrument = error_motions::InstrumentUncertainty{.a = 0.4};
  const auto measured = measure_straightness(request);
  ASSERT_TRUE(measured);
  EXPECT_TRUE(measured->motion.principal().slope_per_m.tells_U());
  EXPECT_EQ(std::ranges::count(measured->remarks, why), 0);
}

TEST(MeasuredMotion, DoesNotBelieveASquareWithoutUncertainty) {
  SquarenessRequest request;
  request.first = "a.csv";
  request.second = "b.csv";
  request.bytes = {straight_rows, straight_rows};
  const auto zeros = [&](double u) {
    request.square.square_uncertainty_arcsec = u;
    const auto measured = measure_squareness(request);
    EXPECT_TRUE(measured);
    const Experiment shown = present(*measured, {}, {});
    return std::ranges::count_if(shown.json.find("remarks")->items(), [](const json::Value& remark) {
      return remark.text().contains("square is stated as 0");
    });
  };
  EXPECT_EQ(zeros(0.0), 1);
  EXPECT_EQ(zeros(0.2), 0);
}

/// With it the range of the residuals of one run had U = 0.
TEST(MeasuredMotion, DoesNotBelieveAnInstrumentWithoutUncertainty) {
  const std::string rows = "position_mm,straightness_um\n0,1\n400,2\n800,3.5\n";
  MotionRequest request{.file = "a.csv", .options = {}, .bytes = rows};
  request.options.instrument = error_motions::InstrumentUncertainty{};
  const auto measured = measure_straightness(request);
  ASSERT_TRUE(measured);
  EXPECT_FALSE(measured->motion.principal().range.tells_U());
  EXPECT_EQ(std::ranges::count(measured->remarks, zero_instrument_remark), 1);
  EXPECT_EQ(std::ranges::count(measured->remarks, no_instrument_remark), 0);
  for (const language::Language language : {language::Language::german, language::Language::french})
    EXPECT_TRUE(language::is_known(zero_instrument_remark, language));
  request.options.instrument->b_per_m = 0.5;
  const auto growing = measure_straightness(request);
  ASSERT_TRUE(growing);
  EXPECT_TRUE(growing->motion.principal().range.tells_U());
  EXPECT_EQ(std::ranges::count(growing->remarks, zero_instrument_remark), 0);
}

/// A file in mm is evaluated in µm; what 0.0004 beside it means must not be guessed in silence.
TEST(MeasuredMotion, SaysInWhichUnitTheInstrumentWasTaken) {
  const auto told = [](const std::string& head) {
    const std::string rows = "position_mm," + head + "\n0,0\n400,0.002\n800,0.001\n";
    MotionRequest request{.file = "a.csv", .options = {}, .bytes = rows};
    request.options.instrument = error_motions::InstrumentUncertainty{.a = 0.4};
    const auto measured = measure_straightness(request);
    EXPECT_TRUE(measured);
    return std::ranges::count_if(measured->remarks, [](const std::string& remark) {
      return remark.contains("was taken as stated in µm") && language::is_known(remark, language::Language::german);
    });
  };
  EXPECT_EQ(told("straightness_mm"), 1);
  EXPECT_EQ(told("straightness_um"), 0);
}

TEST(MeasuredMotion, HasNoUncertaintyOfASquarenessWhereOneLineHasNone) {
  const std::string scatters =
      "position_mm,run,straightness_um\n0,1,1\n400,1,2\n800,1,3.5\n0,2,1\n400,2,2.1\n800,2,3.3\n";
  const std::string copied = "position_mm,run,straightness_um\n0,1,1\n400,1,2\n800,1,2\n0,2,1\n400,2,2\n800,2,2\n";
  const auto tells = [&](const std::string& second) {
    SquarenessRequest request{.first = "a.csv", .second = "b.csv", .options = {}, .square = {}};
    request.bytes = {scatters, second};
    request.senses = {*reading_sense("+Y"), *reading_sense("+X")};
    request.square.square_uncertainty_arcsec = 0.2;
    const auto measured = measure_squareness(request);
    EXPECT_TRUE(measured) << measured.error().message;
    EXPECT_EQ(measured->location->urad.tells_U(), measured->result.squareness_arcsec.tells_U());
    return measured->result.squareness_arcsec.tells_U();
  };
  EXPECT_TRUE(tells(scatters));
  EXPECT_FALSE(tells(copied));
}

/// Up and down the first line has other slopes, and the second was never read going down.
TEST(MeasuredMotion, HasTheSquarenessOfADirectionThatBothLinesHave) {
  const std::string both =
      "position_mm,direction,straightness_um\n0,up,0\n500,up,5\n1000,up,10\n1000,down,30\n500,down,15\n0,down,0\n";
  const auto line = [](const char* direction) {
    std::string rows = "position_mm,direction,straightness_um\n";
    for (const int mm : {0, 300, 600}) rows += fmt::format("{},{},{}\n", mm, direction, 0.005 * mm);
    return rows;
  };
  const auto measured = [&](const std::string& first, const std::string& second) {
    SquarenessRequest request{.first = "a.csv", .second = "b.csv", .options = {}, .square = {}};
    request.bytes = {first, second};
    request.senses = {*reading_sense("+Y"), *reading_sense("+X")};
    return measure_squareness(request);
  };
  const std::string up = line("up"), down = line("down");
  const auto found = measured(both, up);
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_NEAR(found->location->urad.value, -15.0, 1e-3);
  EXPECT_EQ(found->result.kind_1, error_motions::PathKind::up);
  EXPECT_THAT(json::dump(*present(*found, {}, {}).json.find("remarks")),
              HasSubstr("EXY was read in one direction alone: the squareness is that of ↑"));
  const auto courses = [](const SquarenessMeasurement& s) {
    return json::dump(*present(s, {}, {}).json.find("courses"), 0);
  };
  EXPECT_THAT(courses(*found), AllOf(HasSubstr("\"up\""), Not(HasSubstr("\"down\""))));
  const auto apart = measured(up, down);
  ASSERT_TRUE(apart) << apart.error().message;
  EXPECT_THAT(courses(*apart), AllOf(HasSubstr("\"up\""), HasSubstr("\"down\"")));
  EXPECT_THAT(json::dump(*present(*apart, {}, {}).json.find("remarks")),
              HasSubstr("the first line was read ↑ alone, the second ↓ alone"));
}

TEST(Angles, DoAtAnotherPointWhatEachDirectionDoes) {
  const std::string both =
      "# error: EBX\nposition_mm,direction,pitch_urad\n0,up,10\n100,up,10\n100,down,-10\n0,down,-10\n";
  const std::string one = "# error: EAX\n# positive: +A\nposition_mm,direction,roll_urad\n0,up,1\n100,up,2\n";
  const std::string other = "# error: EAX\nposition_mm,direction,roll_urad\n0,down,1\n100,down,2\n";
  const auto measured =
      measure_angles({.files = {{.file = "b.csv", .options = {}, .bytes = both}}, .offset_mm = Vector3{0, 0, 250}});
  ASSERT_TRUE(measured);
  ASSERT_EQ(measured->abbe[0].courses.size(), 3u);
  EXPECT_DOUBLE_EQ(measured->abbe[0].courses[0].change_um[0], 2.5);
  EXPECT_DOUBLE_EQ(measured->abbe[0].courses[1].change_um[0], -2.5);
  EXPECT_DOUBLE_EQ(measured->abbe[0].courses[2].change_um[0], 0.0);
  const Experiment shown = present(*measured, {}, {});
  EXPECT_EQ(row_of(shown.document, "EXX"), (std::vector<std::string>{"EXX", "↑", "0.000", "2.500", ""}));
  EXPECT_EQ(shown.json.find("abbe")->find("change_down_um")->find("EXX")->items().size(), 2u);
  EXPECT_THAT(json::dump(*shown.json.find("remarks")), HasSubstr("which way the readings of EBX are positive"));

  const auto mixed = measure_angles(
      {.files = {{.file = "a.csv", .options = {}, .bytes = one}, {.file = "b.csv", .options = {}, .bytes = both}},
       .offset_mm = Vector3{0, 0, 250}});
  ASSERT_TRUE(mixed);
  ASSERT_EQ(mixed->abbe[0].courses.size(), 1u) << "roll was read in one direction";
  EXPECT_EQ(mixed->abbe[0].courses[0].kind, error_motions::PathKind::up);
  const auto apart = measure_angles({.files = {{.file = "a.csv", .options = {}, .bytes = other},
                                               {.file = "b.csv",
                                                .error = *motion_name("EBX"),
                                                .options = {},
                                                .bytes = "position_mm,direction,angle_urad\n0,up,1\n100,up,2\n"}},
                                     .offset_mm = Vector3{0, 0, 250}});
  ASSERT_FALSE(apart);
  EXPECT_THAT(apart.error().message, HasSubstr("expected a direction that all of them have"));
}

TEST(Angles, RefuseAColumnOfRollForAnErrorThatIsNone) {
  const auto fault = [](const char* column, const char* error) -> std::string {
    const std::string bytes = std::string("position_mm,") + column + "_urad\n0,1\n400,2\n";
    const auto measured = measure_angle({.file = "a.csv", .error = *motion_name(error), .options = {}, .bytes = bytes});
    return measured ? "" : measured.error().message;
  };
  EXPECT_EQ(fault("roll", "EBX"), "found a column of roll for EBX, expected EAX");
  EXPECT_EQ(fault("roll", "EBY"), "");
  EXPECT_EQ(fault("pitch", "ECZ"), "found a column of pitch for ECZ, which is the roll; expected EAZ or EBZ");
  EXPECT_EQ(fault("yaw", "EAX"), "found a column of yaw for EAX, which is the roll; expected EBX or ECX");
  for (const char* error : {"EBX", "ECX"}) EXPECT_EQ(fault("pitch", error), "") << "as the machine stands";
  EXPECT_EQ(fault("angle", "EBX"), "");
}

TEST(Angles, SayOfWhichOfThemARemarkIs) {
  const std::string two = "# error: EAX\nposition_mm,run,angle_urad\n0,1,1\n400,1,2\n0,2,1.1\n400,2,2.3\n";
  const std::string one = "# error: ECX\nposition_mm,angle_urad\n0,1\n400,2\n";
  auto measured = measure_angles(
      {.files = {{.file = "a.csv", .options = {}, .bytes = two}, {.file = "c.csv", .options = {}, .bytes = one}}});
  ASSERT_TRUE(measured);
  const auto told = all_remarks({&measured->angles[0], &measured->angles[1]});
  const std::string of_one =
      "ECX: one run: what does not repeat cannot be told from the shape, and there is no repeatability";
  EXPECT_EQ(std::ranges::count(told, of_one), 1);
  EXPECT_EQ(std::ranges::count(told, no_instrument_remark), 1) << "of both";
  for (const language::Language language : {language::Language::german, language::Language::french})
    EXPECT_TRUE(language::is_known(of_one, language));
  measured->angles[0].error = measured->angles[1].error = std::nullopt;
  measured->angles[0].file = "a/x.csv";
  measured->angles[1].file = "b/x.csv";
  EXPECT_EQ(
      std::ranges::count(all_remarks({&measured->angles[0], &measured->angles[1]}), "b/x.csv: " + of_one.substr(5)), 1);
  const auto alone = all_remarks({&measured->angles[1]});
  EXPECT_EQ(std::ranges::count(alone, of_one.substr(5)), 1);
}

}  // namespace
}  // namespace axiometry::app
