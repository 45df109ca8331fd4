// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <functional>

#include "axiometry/app/error_motions/motion_evaluation.h"
#include "axiometry/app/files/output.h"
#include "axiometry/app/live/disk/stop_marks.h"
#include "axiometry/app/live/runs/motion_run.h"
#include "axiometry/app/live/runs/recording_spared.h"
#include "axiometry/formats/plan/plan_json.h"
#include "tests/support/made_up_motion.h"
#include "tests/support/temporary_folder.h"

namespace axiometry::app {
namespace {

using capture::StopSign;
using testing::ElementsAre;
using testing::HasSubstr;
using testing_support::DrivenAxis;
using testing_support::DrivenSample;
using testing_support::straightness_plan;
using testing_support::true_straightness_um;

/// Time, position, reading, trigger; the reading in any unit of length.
std::string stream_of(const DrivenAxis& axis, const std::string& head, double um_per_unit) {
  std::string text = head + "\n";
  for (const DrivenSample& s : axis.samples())
    text +=
        fmt::format("{:.2f},{:.4f},{:.7f},{}\n", s.time_s, s.position_mm, s.value_um / um_per_unit, s.trigger ? 1 : 0);
  return text;
}

struct MotionCapture {
  testing_support::TemporaryFolder folder;
  Plan plan = straightness_plan();
  CaptureRun run;
  CaptureOptions options;
  std::vector<std::string> events, notices;

  MotionCapture() {
    options.motion.emplace();
    options.motion->sign = StopSign::trigger;
    options.motion->stop_column = 2;
    options.recording.axis = 1;
    options.recording.axis_stated = true;
    put("run.csv", stream_of(DrivenAxis(plan), "time_s,position_mm,straightness_um,trigger", 1.0));
    run.from = path("run.csv");
    run.out = path("eyx.csv");
  }
  /// Beyond a place the axis is elsewhere. Lines so long that the first block of the file holds two rests.
  void displace_beyond(double from_mm) {
    options.motion->sign = StopSign::position;
    options.motion->stop_column = 0;
    const DrivenAxis axis(plan);
    std::string stream = "time_s,position_mm,straightness_um,trigger\n";
    for (const DrivenSample& s : axis.samples())
      stream += fmt::format("{:.2f},{:.4f},{:.7f},{:.220f}\n", s.time_s,
                            s.position_mm + (s.position_mm > from_mm ? 37.0 : 0.0), s.value_um, 0.0);
    put("run.csv", stream);
    put("eyx.csv", "measured before\n");
  }
  std::string path(const std::string& name) const { return folder.file(name); }
  void put(const std::string& name, const std::string& bytes) const { EXPECT_TRUE(write_file(path(name), bytes)); }

  Result<MotionOutcome> operator()() {
    put("plan.json", formats::write_plan(plan));
    options.plan = path("plan.json");
    const CaptureObserver observer{.reading = {},
                                   .event = [&](const auto& event) { events.push_back(event.message); },
                                   .notice = [&](const std::string& text) { notices.push_back(text); },
                                   .now = {},
                                   .stopped = {},
                                   .abandoned = {}};
    return run_motion_capture(run, options, observer);
  }

  void expect_whole() {
    const auto outcome = (*this)();
    ASSERT_TRUE(outcome) << outcome.error().to_string();
    EXPECT_EQ(outcome->found, 12u);
    EXPECT_EQ(outcome->planned, 12u);
    const auto measured = measure_straightness({.file = run.out, .options = {}});
    ASSERT_TRUE(measured) << measured.error().to_string();
    EXPECT_EQ(measured->error->text(), "EYX");
    EXPECT_EQ(measured->motion.runs, 2u);
    const auto table = *formats::read_motion_csv(*whole(run.out));
    for (const MotionReading& r : table.readings) {
      const Approach a{static_cast<std::size_t>(r.position_mm / 100.0), r.direction, r.run - 1};
      EXPECT_NEAR(r.value, true_straightness_um(plan, a), 0.05);
    }
  }
  static Result<std::string> whole(const std::string& file) { return file_bytes(file); }
  std::string refusal() {
    const auto outcome = (*this)();
    return outcome ? "" : outcome.error().message;
  }
};

TEST(MotionCapture, WritesTheTableThatStraightnessEvaluates) {
  MotionCapture capture;
  capture.options.motion->sense = reading_sense("+Y").value();
  capture.options.motion->equipment = {"Straightness interferometer | Acme | SI-1 | 77"};
  capture.expect_whole();
  const std::string table = *MotionCapture::whole(capture.run.out);
  EXPECT_THAT(table, HasSubstr("# error: EYX\n# positive: +Y\n# axis.name: X\n"));
  EXPECT_THAT(table, HasSubstr("# equipment: Straightness interferometer | Acme | SI-1 | 77\n"));
  EXPECT_THAT(table, HasSubstr("the stops were told by a trigger in the stream; 12 of 12 readings of the plan"));
  EXPECT_THAT(table, HasSubstr("\nposition_mm,run,direction,EYX_um,time_s,scatter_um,drift_um,samples\n0,1,up,"));
  const auto measured = measure_straightness({.file = capture.run.out, .options = {}});
  ASSERT_EQ(measured->remarks.size(), 1u) << "columns of a capture are no surprise";
  EXPECT_EQ(measured->remarks[0], no_instrument_remark);
}

TEST(MotionCapture, FindsStopsByThePositionInTheStream) {
  MotionCapture capture;
  capture.options.motion->sign = StopSign::position;
  capture.options.motion->stop_column = 0;
  capture.expect_whole();
}

TEST(MotionCapture, LeavesNoTableThatItBeganOfPositionsOfAnotherPlan) {
  MotionCapture capture;
  capture.displace_beyond(50.0);  // the first target is the same: there is a table at first
  std::filesystem::remove(capture.run.out);
  EXPECT_THAT(capture.refusal(), HasSubstr("the recording belongs to another plan"));
  EXPECT_FALSE(std::filesystem::exists(capture.run.out));
  EXPECT_THAT(capture.notices, ElementsAre(capture.run.out + ": removed, what was written there does not hold"));
}

TEST(MotionCapture, PutsBackWhatWasThereBeforeATableThatDoesNotHold) {
  MotionCapture capture;
  capture.displace_beyond(50.0);
  EXPECT_THAT(capture.refusal(), HasSubstr("the recording belongs to another plan"));
  EXPECT_EQ(*MotionCapture::whole(capture.run.out), "measured before\n");
  EXPECT_THAT(capture.notices, ElementsAre(HasSubstr("holds again what it held before")));
}

TEST(MotionCapture, RefusesReadingsThatAreCalledAnotherError) {
  for (const auto& [head, another] :
       {std::pair("EYX_um", false), std::pair("EZX_um", true), std::pair("EYY_um", true), std::pair("yaw_um", true),
        std::pair("Pitch [um]", true), std::pair("roll_um", true), std::pair("straightness_um", false)}) {
    SCOPED_TRACE(head);
    MotionCapture capture;
    capture.put("run.csv",
                stream_of(DrivenAxis(capture.plan), fmt::format("time_s,position_mm,{},trigger", head), 1.0));
    const std::string refusal = capture.refusal();
    if (another) EXPECT_THAT(refusal, HasSubstr("found readings that the stream calls"));
    if (!another) EXPECT_EQ(refusal, "");
  }
}

TEST(MotionCapture, TellsOfAnInstrumentThatShowedOneValueAllTheTime) {
  MotionCapture capture;
  std::string stream = "time_s,position_mm,straightness_um,trigger\n";
  for (const DrivenSample& s : DrivenAxis(capture.plan).samples())
    stream += fmt::format("{:.2f},{:.4f},0.0000,{}\n", s.time_s, s.position_mm, s.trigger ? 1 : 0);
  capture.put("run.csv", stream);
  ASSERT_EQ(capture.refusal(), "");
  EXPECT_THAT(capture.events, testing::Contains(HasSubstr("every sample of the recording is 0 µm, to the last digit")));
}

TEST(MotionCapture, LeavesWhatWasThereBeforePositionsOfAnotherPlan) {
  MotionCapture capture;
  capture.displace_beyond(-10.0);
  EXPECT_THAT(capture.refusal(), HasSubstr("the recording belongs to another plan"));
  EXPECT_EQ(*MotionCapture::whole(capture.run.out), "measured before\n");
  EXPECT_TRUE(capture.notices.empty());
}

TEST(MotionCapture, KeepsWhatStoodBeforeALineThatTellsNoStop) {
  MotionCapture capture;
  const DrivenAxis axis(capture.plan);
  std::string stream = stream_of(axis, "time_s,position_mm,straightness_um,trigger", 1.0);
  const std::size_t line = stream.find(fmt::format("\n{:.2f},", axis.stops()[9].end_s)) + 1;
  stream[stream.find('\n', line) - 1] = 'x';
  capture.put("run.csv", stream);
  EXPECT_THAT(capture.refusal(), HasSubstr("found \"x\", expected a finite number"));
  const auto table = formats::read_motion_csv(*MotionCapture::whole(capture.run.out));
  ASSERT_TRUE(table) << table.error().to_string();
  EXPECT_EQ(table->readings.size(), 10u);
}

TEST(MotionCapture, TakesMillimetresAsStatedAndAsNamed) {
  for (const bool stated : {false, true}) {
    MotionCapture capture;
    capture.put("run.csv",
                stream_of(DrivenAxis(capture.plan),
                          stated ? "time_s,position_mm,reading,trigger" : "time_s,position_mm,Y [mm],trigger", 1000.0));
    if (stated) capture.options.motion->unit = formats::find_unit("mm");
    capture.expect_whole();
    EXPECT_THAT(*MotionCapture::whole(capture.run.out), HasSubstr("# sent in mm, written in µm\n"));
  }
}

TEST(MotionCapture, RefusesUnitsThatNobodyStatesOrThatContradict) {
  const auto refusal = [](const std::string& head, const char* unit, const char* error = nullptr) {
    MotionCapture capture;
    capture.put("run.csv", stream_of(DrivenAxis(capture.plan), head, 1.0));
    if (unit != nullptr) capture.options.motion->unit = formats::find_unit(unit);
    if (error != nullptr) capture.plan.errors = {*motion_name(error)};
    return capture.refusal();
  };
  EXPECT_THAT(refusal("time_s,position_mm,reading,trigger", nullptr), HasSubstr("found readings without a unit"));
  EXPECT_EQ(refusal("time_s,position_mm,reading_mm,trigger", "um"),
            "found readings in mm by the stream's header, expected µm as stated");
  EXPECT_EQ(refusal("time_s,position_mm,reading_urad,trigger", nullptr),
            "found EYX in µrad, expected readings of a length");
  EXPECT_EQ(refusal("time_s,position_mm,reading,trigger", "um", "EBX"),
            "found EBX in µm, expected readings of an angle");
  EXPECT_THAT(refusal("time_s,position_mm,level [V],trigger", "um"),
              HasSubstr("found the column \"level [V]\" in a unit that is not known"));
}

TEST(MotionCapture, WritesAnglesInTheirOwnUnit) {
  const std::pair<const char*, const char*> units[] = {{"arcsec", "EBX_arcsec"}, {"urad", "EBX_urad"}};
  for (const auto& [unit, column] : units) {
    MotionCapture capture;
    capture.plan.errors = {*motion_name("EBX")};
    capture.put("run.csv",
                stream_of(DrivenAxis(capture.plan), fmt::format("time_s,position_mm,yaw_{},trigger", unit), 1.0));
    const auto outcome = capture();
    ASSERT_TRUE(outcome) << outcome.error().to_string();
    EXPECT_EQ(outcome->found, 12u);
    EXPECT_THAT(*MotionCapture::whole(capture.run.out), HasSubstr(column));
    EXPECT_TRUE(measure_angle({.file = capture.run.out, .options = {}}));
  }
}

TEST(MotionCapture, RefusesStatementsThatFitNoCapture) {
  const auto refusal = [](const std::function<void(MotionCapture&)>& change) {
    MotionCapture capture;
    change(capture);
    return capture.refusal();
  };
  EXPECT_THAT(refusal([](auto& c) { c.plan.errors.clear(); }),
              HasSubstr("made for positions, expected the error that is read"));
  EXPECT_THAT(refusal([](auto& c) { c.plan.errors.push_back(*motion_name("EZX")); }),
              HasSubstr("made for EYX, EZX, expected the error that is read"));
  EXPECT_THAT(refusal([](auto& c) { c.options.motion->error = *motion_name("EZX"); }),
              HasSubstr("found readings of EZX with a plan made for EYX"));
  EXPECT_THAT(refusal([](auto& c) { c.options.motion->sense = *reading_sense("+Z"); }),
              HasSubstr("expected +Y or -Y as EYX is"));
  EXPECT_THAT(refusal([](auto& c) { c.options.motion->stop_column.reset(); }),
              HasSubstr("expected its number among those beside the time"));
  EXPECT_THAT(refusal([](auto& c) { c.options.motion->sign = StopSign::readings; }),
              HasSubstr("found a column of the stops"));
  EXPECT_THAT(refusal([](auto& c) {
                c.options.motion->sign = StopSign::keys;
                c.options.motion->stop_column.reset();
              }),
              HasSubstr("found a finished recording and no keys, expected those"));
  EXPECT_THAT(refusal([](auto& c) { c.options.matcher.reversed = true; }),
              HasSubstr("only where a position tells the stops"));
  EXPECT_THAT(refusal([](auto& c) { c.options.stream = "umd"; }), HasSubstr("whose numbers are positions"));
  EXPECT_THAT(refusal([](auto& c) { c.options.recording.axis_stated = false, c.options.recording.axis = 0; }),
              HasSubstr("expected the number of the one with the readings"));
}

TEST(MotionCapture, PlaysKeysOfAFinishedRecordingAgain) {
  MotionCapture capture;
  capture.options.motion->sign = StopSign::keys;
  capture.options.motion->stop_column.reset();
  const DrivenAxis axis(capture.plan);
  std::string keys = "# said at the stops\n";
  for (const auto& stop : axis.stops()) keys += fmt::format("{:.2f},take\n", stop.begin_s + 1.0);
  capture.put("run.keys", keys);
  capture.run.keys = capture.path("run.keys");
  capture.expect_whole();
  // The last was taken back behind the last of the plan, and taken once more.
  const double last_s = axis.stops().back().begin_s;
  capture.put("run.keys",
              keys.substr(0, keys.rfind('\n', keys.size() - 2) + 1) +
                  fmt::format("{:.2f},take\n{:.2f},undo\n{:.2f},take\n", last_s + 0.2, last_s + 2.0, last_s + 2.1));
  capture.expect_whole();
  EXPECT_THAT(capture.events, testing::Contains(HasSubstr("is due again")));
  // One less: the recording is not whole, and says where.
  capture.put("run.keys", keys.substr(0, keys.rfind('\n', keys.size() - 2) + 1));
  const auto outcome = capture();
  ASSERT_TRUE(outcome);
  EXPECT_EQ(outcome->found, 11u);
  EXPECT_THAT(capture.events.back(), HasSubstr("the recording ended before target 1↓ run 2"));
  const auto half = measure_straightness({.file = capture.run.out, .options = {}});
  EXPECT_THAT(half.error().message, HasSubstr("found no reading at position 0 mm"));
}

TEST(StopMarks, AreSparedAsTheRecordingIs) {
  MotionCapture capture;
  capture.put("run.raw", *MotionCapture::whole(capture.run.from));
  capture.put("run.raw.keys", "1,skip\n");
  capture.run.from = capture.path("run.raw");
  capture.run.out = capture.path("run.raw.keys");
  EXPECT_EQ(capture.refusal(), "found an output that is also an input, expected another name");
  CaptureRun live;
  live.from = "tcp://127.0.0.1:9";
  live.raw = capture.path("x.raw");
  for (const char* name : {"x.raw", "x.raw.keys"}) {
    live.out = capture.path(name);
    EXPECT_FALSE(check_recording_spared(live, capture.path("run.csv"))) << name;
  }
  live.out = capture.path("x.csv");
  EXPECT_TRUE(check_recording_spared(live, capture.path("run.csv")));
}

TEST(StopMarks, AreKeptInTheirOrderAndReadAgain) {
  const testing_support::TemporaryFolder folder;
  const std::string raw = folder.file("x.csv.raw");
  ASSERT_TRUE(append_mark(raw, {capture::StopKey::take, -std::numeric_limits<double>::infinity()}));
  ASSERT_TRUE(append_mark(raw, {capture::StopKey::undo, 0.1 + 0.2}));
  ASSERT_TRUE(append_mark(raw, {capture::StopKey::skip, 12.5}));
  const auto marks = read_marks(marks_name(raw));
  ASSERT_TRUE(marks) << marks.error().to_string();
  ASSERT_EQ(marks->size(), 3u);
  EXPECT_EQ((*marks)[1].time_s, 0.1 + 0.2);
  EXPECT_EQ((*marks)[2].key, capture::StopKey::skip);
  ASSERT_TRUE(append_mark(raw, {capture::StopKey::take, 3.0}));
  EXPECT_THAT(read_marks(marks_name(raw)).error().message, HasSubstr("found 3 s after 12.5 s"));
  ASSERT_TRUE(write_file(marks_name(raw), "1,take\n2.5,ta"));
  EXPECT_EQ(marks_beside(raw)->size(), 1u) << "a power failure cut the second off";
  ASSERT_TRUE(append_mark(raw, {capture::StopKey::skip, 3.0}));
  EXPECT_EQ(*MotionCapture::whole(marks_name(raw)), "1,take\n3,skip\n");
  EXPECT_TRUE(marks_beside(folder.file("none"))->empty());
  ASSERT_TRUE(write_file(marks_name(raw), "1,take\n2,took\n"));
  EXPECT_THAT(read_marks(marks_name(raw)).error().to_string(), HasSubstr("keys:2:1: found \"2,took\""));
}

TEST(StopMarks, BeginNoRecordingBehindATime) {
  const testing_support::TemporaryFolder folder;
  const std::string file = folder.written("x.keys", "begin,take\n12.5,take\nbegin,skip\n");
  EXPECT_THAT(read_marks(file).error().to_string(), HasSubstr("keys:3:1: found \"begin,skip\", expected a time in s"));
}

}  // namespace
}  // namespace axiometry::app
