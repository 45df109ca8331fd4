// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/plan/nc_program.h"
#include "axiometry/standards/iso230_2/plan/plan.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace axiometry::app {
namespace {

constexpr std::string_view plan_text = R"({"axis": {"name": "X", "kind": "linear"}, "cycle": "standard",
 "targets": [0, 10, 20], "runs": 2, "overrun": 5, "feed": 1000, "dwell_s": 3, "further": [{"axis": {"name": "Y",
 "kind": "linear"}, "cycle": "step", "targets": [1, 2], "runs": 1, "overrun": 5, "feed": 1000, "dwell_s": 3}]})";

class NcProgram : public testing::Test {
 protected:
  std::string reason(NcRequest request) const {
    request.plan = plan_;
    const auto program = nc_program(request);
    return program ? "" : program.error().to_string();
  }

  testing_support::TemporaryFolder folder_;
  const std::string plan_ = folder_.written("plan.json", plan_text);
};

TEST_F(NcProgram, WalksThePartOfThePlanThatIsAskedFor) {
  const auto first = nc_program({.plan = plan_, .dialect = "grbl"});
  const auto second = nc_program({.plan = plan_, .dialect = "grbl", .part = 2});
  ASSERT_TRUE(first);
  ASSERT_TRUE(second);
  EXPECT_NE(first->find("AXIS X"), std::string::npos);
  EXPECT_NE(second->find("AXIS Y"), std::string::npos);
}

TEST_F(NcProgram, SaysWhatSpeaksAgainstThePlan) {
  const auto program = nc_program({.plan = plan_, .dialect = "grbl"});
  ASSERT_TRUE(program);
  EXPECT_NE(program->find("NOT IN ACCORDANCE, "), std::string::npos) << *program;
  EXPECT_NE(program->find("AT AN ACCELERATION OF 1000 MM/S2"), std::string::npos) << *program;
  iso230_2::PlanRequest request;
  request.axis.name = "X";
  request.axis.travel_begin = Position::native(0);
  request.axis.travel_end = Position::native(500);
  request.seed = 7;
  Plan plan = iso230_2::make_plan(request).value();
  const auto sound = nc_program_of(plan, {.dialect = "grbl"});
  ASSERT_TRUE(sound);
  EXPECT_NE(sound->find("(TEST ISO 230-2-2014, 5.3.2)"), std::string::npos) << *sound;
  EXPECT_EQ(sound->find("ACCORDANCE"), std::string::npos) << *sound;
  plan.errors = {motion_name("EYX").value()};
  const auto other = nc_program_of(plan, {.dialect = "grbl"});
  ASSERT_TRUE(other);
  EXPECT_NE(other->find("READINGS OF EYX"), std::string::npos) << *other;
  EXPECT_EQ(other->find("TEST ISO"), std::string::npos);
}

TEST_F(NcProgram, SaysWhatThereIsInsteadOfWhatIsNot) {
  EXPECT_EQ(reason({.dialect = "grbl", .part = 3}), plan_ + ": found part 3 asked for, expected 1 to 2");
  EXPECT_EQ(reason({.dialect = "grbl", .part = 0}), plan_ + ": found part 0 asked for, expected 1 to 2");
  EXPECT_EQ(reason({.dialect = "linuxnc"}), "found the unknown dialect \"linuxnc\", expected perhaps linuxcnc");
  EXPECT_EQ(reason({.dialect = "grbl", .options = {.trigger_m_code = 3}}),
            plan_ + ": found M3 as trigger, which steers the spindle, expected one of M7…M8");
  EXPECT_EQ(
      reason({.dialect = "grbl", .options = {.stop_at_lines = true}}),
      plan_ + ": found a stop before each line asked for, expected none: this is no tracking plan, which has lines");
  const volumetric::CalibrationPlan volume{.machine = {.chain = *volumetric::KinematicChain::make("XFYZ")}};
  const auto tour = nc_program_of(volume, {.dialect = "grbl", .options = {.stop_at_lines = true}});
  ASSERT_FALSE(tour);
  EXPECT_TRUE(tour.error().message.starts_with("found a stop before each line asked for, expected none: this is the"));
}

TEST_F(NcProgram, IsInTheFrameThatIsAskedFor) {
  const auto framed = nc_program({.plan = plan_, .dialect = "grbl", .options = {.frame = "G55"}});
  ASSERT_TRUE(framed);
  EXPECT_NE(framed->find(" G55\n"), std::string::npos) << *framed;
  EXPECT_EQ(reason({.dialect = "grbl", .options = {.rollover = true}}),
            plan_ + ": found rollover asked for, expected it of a rotary axis alone");
}

TEST_F(NcProgram, DoesNotTakeThePlacesOfThePlanOrOfAFileWhenItFails) {
  const std::string output = folder_.file("program.nc");
  EXPECT_FALSE(write_nc_program({.plan = plan_, .dialect = "grbl"}, plan_));
  EXPECT_FALSE(write_nc_program({.plan = plan_, .dialect = "grbl", .part = 9}, output));
  EXPECT_FALSE(std::filesystem::exists(output));
  EXPECT_TRUE(write_nc_program({.plan = plan_, .dialect = "grbl"}, output));
  EXPECT_EQ(folder_.content("program.nc"), *nc_program({.plan = plan_, .dialect = "grbl"}));
  EXPECT_EQ(folder_.content("plan.json"), plan_text);
}

constexpr std::string_view lines_text = R"({"format": "axiometry-tracking-plan/1", "title": "Seven lines",
 "machine": "Mill 4", "date": "2026-11-22", "setup": {
 "travel": {"lowest_mm": [0, 0, -500], "highest_mm": [800, 500, 0]},
 "station": {"position_mm": [0, 0, 0]}}, "lines": [
 {"id": "x", "plan": {"axis": {"name": "X", "kind": "linear", "line_origin_mm": [0, 5, 7], "line_direction": [1, 0, 0]},
  "cycle": "standard", "targets": [100, 200], "runs": 2, "overrun": 5, "feed": 600, "dwell_s": 0}},
 {"id": "xy", "plan": {"axis": {"kind": "linear", "line_origin_mm": [0, 5, 7], "line_direction": [1, 1, 0]},
  "cycle": "standard", "targets": [100, 200], "runs": 2, "overrun": 5, "feed": 600, "dwell_s": 0,
  "way_in_mm": [[95, 5, 100]]}}],
 "lost": [{"id": "z", "reason": "the sphere is below reach"}]})";

class NcProgramOfLines : public testing::Test {
 protected:
  std::string reason(NcRequest request) const {
    request.plan = plan_;
    request.dialect = "grbl";
    const auto program = nc_program(request);
    return program ? "" : program.error().to_string();
  }

  testing_support::TemporaryFolder folder_;
  const std::string plan_ = folder_.written("plan.json", lines_text);
};

TEST_F(NcProgramOfLines, DrivesTheWholeMeasurementOrOneLine) {
  const auto all = nc_program({.plan = plan_, .dialect = "fanuc"});
  ASSERT_TRUE(all) << all.error().to_string();
  for (const char* text : {"(TITLE SEVEN LINES)", "(MACHINE MILL 4)", "(2 LINES, X, XY)", "(1 OF 2, LINE X)",
                           "X95.0000 Y5.0000 Z7.0000 F600. (TO LINE X)", "X95.0000 Y5.0000 Z100.0000 F600. (WAY IN)"})
    EXPECT_NE(all->find(text), std::string::npos) << text << "\n" << *all;
  const auto one = nc_program({.plan = plan_, .dialect = "fanuc", .line = "xy"});
  ASSERT_TRUE(one) << one.error().to_string();
  EXPECT_EQ(one->find("LINE X)"), std::string::npos);
  EXPECT_NE(one->find("(LINE XY)"), std::string::npos) << *one;
  EXPECT_NE(one->find("(WAY IN)"), std::string::npos) << *one;
}

TEST_F(NcProgramOfLines, DrivesOneLineFromAboveAndNotFromTheEndOfTheOneBefore) {
  std::string text(lines_text);
  const std::string low = R"("position_mm": [0, 0, 0])";
  text.replace(text.find(low), low.size(), R"("position_mm": [0, 5, -490])");
  for (std::size_t at = 0; (at = text.find("[0, 5, 7]", at)) != std::string::npos;) text.replace(at, 9, "[0, 5, -490]");
  for (std::size_t at = 0; (at = text.find("[100, 200]", at)) != std::string::npos;) text.replace(at, 10, "[300, 400]");
  const std::string file = folder_.written("alone.json", text);
  const auto one = nc_program({.plan = file, .dialect = "fanuc", .line = "x"});
  ASSERT_TRUE(one) << one.error().to_string();
  EXPECT_NE(one->find("G1 X295.0000 Y5.0000 Z0.0000 F600. (WAY IN)"), std::string::npos) << *one;
  EXPECT_NE(one->find("G1 X295.0000 Y5.0000 Z0.0000 F600. (WAY OUT)"), std::string::npos) << *one;
  const auto all = nc_program({.plan = file, .dialect = "fanuc"});
  ASSERT_TRUE(all) << all.error().to_string();
  EXPECT_EQ(all->find("(WAY OUT)"), std::string::npos);
}

TEST_F(NcProgramOfLines, SaysWhatThereIsInsteadOfWhatIsNot) {
  EXPECT_EQ(reason({.line = "yz"}), plan_ + ": found the line \"yz\" asked for, expected one of x, xy");
  EXPECT_EQ(reason({.line = "z"}), plan_ +
                                       ": found the line \"z\" asked for, which is lost (the sphere is below reach), "
                                       "expected one of x, xy");
  EXPECT_EQ(reason({.part = 2}), plan_ + ": found part 2 asked for, expected none: a tracking plan has lines");
}

TEST_F(NcProgram, HasNoLines) {
  EXPECT_EQ(reason({.dialect = "grbl", .line = "xy"}),
            plan_ + ": found the line \"xy\" asked for, expected none: this is no tracking plan, which has lines");
}

}  // namespace
}  // namespace axiometry::app
