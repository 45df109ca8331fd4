// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/recordings/length_capture.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "axiometry/app/recordings/raw_recording.h"
#include "axiometry/formats/tracking/tracking_lengths_csv.h"
#include "axiometry/simulation/tracked_recording.h"
#include "axiometry/tracking/lines/line_test_support.h"
#include "tests/support/made_up_lengths.h"

namespace axiometry::app {
namespace {

using tracking::testing_support::two_lines;

simulation::TrackedMachine with_play() {
  simulation::TrackedMachine machine;
  machine.backlash[0] = Length::um(3.0);
  return machine;
}

struct RecordedLines {
  TrackingPlan plan = two_lines(3);
  simulation::TrackedMachine machine = with_play();
  simulation::VirtualTracker tracker{.station_mm = tracking::testing_support::station(), .noise = Length::um(0.2)};
  double rate = 100.0;
  std::function<bool(const Sample&)> keep = [](const Sample&) { return true; };

  simulation::SimulatedLineLengths truth() const {
    return *simulation::simulate_lengths(machine, tracker, plan, Duration::s(0.0), 7);
  }

  std::string bytes() const {
    const auto recording = simulation::TrackedRecording::make(machine, tracker, plan, truth(), rate, 7);
    EXPECT_TRUE(recording) << recording.error().message;
    RawSetting setting;
    setting.lengths = true;
    RecordingEncoder encoder = *RecordingEncoder::make(RawLayout::text, setting);
    std::string text = encoder.head();
    EXPECT_TRUE(recording->record([&](std::span<const Sample> samples) -> Result<void> {
      for (const Sample& s : samples)
        if (keep(s)) encoder.append(text, s);
      return {};
    }));
    return text;
  }
};

Result<CapturedLengths> captured(const RecordedLines& lines, const CaptureOptions& options = {}) {
  const std::string bytes = lines.bytes();
  Source source = Source::of_bytes("run.csv", bytes);
  return read_length_recording(source, lines.plan, options);
}

/// The lengths of the simulated readings, each within what is left of its noise and that of the reading it stands for.
void expect_readings(const CapturedLengths& found, const RecordedLines& lines, std::size_t lost = 0) {
  const auto truth = lines.truth();
  EXPECT_EQ(found.readings.size(), truth.readings.size() - lost);
  std::map<std::tuple<std::string, std::size_t, Direction, std::size_t>, double> shown;
  for (std::size_t k = 0; k < truth.readings.size(); ++k) {
    const auto& [line, approach, length, segment] = truth.readings[k];
    shown[{line, approach.target, approach.direction, approach.run}] =
        truth.truth[k].distance_mm - truth.truth.front().distance_mm;
  }
  std::map<std::size_t, double> dead_paths;
  for (const LengthReading& r : found.readings) {
    const double dead_path =
        r.length_difference_mm - shown.at({r.line, r.approach.target, r.approach.direction, r.approach.run});
    const double known = dead_paths.emplace(r.segment, dead_path).first->second;
    EXPECT_NEAR(dead_path, known, 0.0002) << r.line << " " << r.approach.target + 1;
  }
}

TEST(LengthCapture, GivesTheReadingsThatATableWouldHave) {
  const RecordedLines lines;
  const auto found = captured(lines);
  ASSERT_TRUE(found) << found.error().message;
  expect_readings(*found, lines);
  EXPECT_EQ(found->notes.size(), 1u) << found->notes.back();
  EXPECT_EQ(found->layout, "time-position");
  EXPECT_TRUE(std::ranges::is_sorted(found->times_s));
  const auto expected = lines.truth();
  for (std::size_t k = 0; k < found->readings.size(); ++k) {
    EXPECT_EQ(found->readings[k].line, expected.readings[k].line);
    EXPECT_EQ(found->readings[k].approach, expected.readings[k].approach);
  }
}

TEST(LengthCapture, WorksInEveryCycle) {
  for (const TestCycle cycle : {TestCycle::standard, TestCycle::step, TestCycle::pilgrim, TestCycle::unidirectional}) {
    SCOPED_TRACE(cycle_name(cycle));
    RecordedLines lines;
    lines.plan = two_lines(3, cycle);
    const auto found = captured(lines);
    ASSERT_TRUE(found) << found.error().message;
    expect_readings(*found, lines);
  }
}

TEST(LengthCapture, TakesAnotherDeadPathWhereTheBeamBreaksBetweenTwoLines) {
  for (const bool told : {true, false}) {
    SCOPED_TRACE(told);
    RecordedLines lines;
    lines.tracker.breaks = {{.before_reading = 42, .jump_mm = -12.5, .told = told}};
    const auto found = captured(lines);
    ASSERT_TRUE(found) << found.error().message;
    expect_readings(*found, lines);
    EXPECT_EQ(found->readings[41].segment, 0u);
    EXPECT_EQ(found->readings[42].segment, 1u);
    EXPECT_EQ(found->readings[42].line, "xz");
    ASSERT_EQ(found->notes.size(), 2u);
    EXPECT_NE(found->notes[1].find("line xz: before target 1↑ run 1"), std::string::npos) << found->notes[1];
  }
}

TEST(LengthCapture, TellsAMissedApproachAndShiftsNoOther) {
  const RecordedLines whole;
  const auto all = captured(whole);
  ASSERT_TRUE(all);
  for (const std::size_t missed : {5u, 6u, 7u, 13u, 40u, 41u, 42u, 60u}) {
    SCOPED_TRACE(missed);
    RecordedLines lines;
    // While it rested there nothing was recorded.
    const double middle = all->times_s[missed];
    lines.keep = [=](const Sample& s) { return std::abs(s.time_s - middle) > 0.9; };
    const auto found = captured(lines);
    ASSERT_TRUE(found) << found.error().message;
    expect_readings(*found, lines, 1);
    const LengthReading& lost = all->readings[missed];
    EXPECT_TRUE(std::ranges::none_of(
        found->readings, [&](const LengthReading& r) { return r.line == lost.line && r.approach == lost.approach; }));
  }
}

TEST(LengthCapture, NeverTakesOneDirectionForTheOther) {
  // Both have the same length but for the reversal error: only the way there tells which it is.
  RecordedLines lines;
  const auto all = captured(lines);
  ASSERT_TRUE(all);
  // The last target of line x, which the axis reaches from both sides one after the other: readings 6 and 7.
  for (const std::size_t missed : {6u, 7u}) {
    RecordedLines some;
    const double middle = all->times_s[missed];
    some.keep = [=](const Sample& s) { return std::abs(s.time_s - middle) > 0.9; };
    const auto found = captured(some);
    ASSERT_TRUE(found) << found.error().message;
    for (const LengthReading& r : found->readings)
      EXPECT_FALSE(r.line == "x" && r.approach == all->readings[missed].approach);
  }
}

TEST(LengthCapture, PassesOverRestsAtTurningPoints) {
  const TrackingPlan plan = two_lines(2);
  testing_support::MadeUpLengths run;
  run.station_mm = plan.setup.station.position_mm;
  run.home_mm = {900.0, 500.0, 500.0};
  run.rate_hz = 50.0;
  std::vector<testing_support::MadeUpLengths::Place> places;
  for (const TrackingLine& line : plan.lines)
    for (const PlannedMove& move : moves(line.plan)) {
      const Vector3 at = spatial_line(line.plan.axis)->at(move.to) + plan.setup.tool_offset_mm;
      places.push_back({at, move.approach ? 2.0 : 3.0});
    }
  std::string text = "time_s,length_mm\n";
  for (const Sample& s : run.record(places)) text += fmt::format("{:.4f},{:.7f}\n", s.time_s, s.position);
  Source source = Source::of_bytes("run.csv", text);
  const auto found = read_length_recording(source, plan, {});
  ASSERT_TRUE(found) << found.error().message;
  ASSERT_EQ(found->readings.size(), found->approaches);
  const double first = found->readings.front().length_difference_mm;
  for (const LengthReading& r : found->readings) {
    const TrackingLine& line = plan.lines[r.line == "x" ? 0 : 1];
    const Vector3 at =
        spatial_line(line.plan.axis)->at(line.plan.targets[r.approach.target]) + plan.setup.tool_offset_mm;
    EXPECT_NEAR(r.length_difference_mm - first,
                distance(at, run.station_mm) - tracking::testing_support::distances()[0], 0.001);
  }
}

TEST(LengthCapture, CountsDownWhereThatIsSaid) {
  RecordedLines lines;
  std::string turned = lines.bytes();
  std::string text;
  std::size_t at = turned.find("\n0") + 1;
  text = turned.substr(0, at);
  while (at < turned.size()) {
    const std::size_t comma = turned.find(',', at), end = turned.find('\n', at);
    const std::string length = turned.substr(comma + 1, end - comma - 1);
    text += turned.substr(at, comma + 1 - at) + (length.starts_with('-') ? length.substr(1) : "-" + length) + "\n";
    at = end + 1;
  }
  CaptureOptions options;
  Source wrong = Source::of_bytes("run.csv", text);
  const auto refused = read_length_recording(wrong, lines.plan, options);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("the instrument counts the other way"), std::string::npos)
      << refused.error().message;
  options.matcher.reversed = true;
  Source right = Source::of_bytes("run.csv", text);
  const auto found = read_length_recording(right, lines.plan, options);
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_EQ(found->readings.size(), found->approaches);
}

TEST(LengthCapture, WritesATableThatIsReadBack) {
  const RecordedLines lines;
  const auto found = captured(lines);
  ASSERT_TRUE(found);
  const std::string table = length_capture_table(*found);
  EXPECT_FALSE(formats::is_length_recording(table, lines.plan));
  const auto read = formats::read_tracking_lengths(table, lines.plan);
  ASSERT_TRUE(read) << read.error().message;
  ASSERT_EQ(read->rows.size(), found->readings.size());
  for (std::size_t k = 0; k < read->rows.size(); ++k) {
    EXPECT_EQ(read->rows[k].reading.length_difference_mm, found->readings[k].length_difference_mm);
    EXPECT_NEAR(read->rows[k].time_s, found->times_s[k], 0.001);
  }
}

TEST(LengthRecording, IsToldFromATableByWhatItHolds) {
  const TrackingPlan plan = two_lines();
  const auto is_recording = [&](std::string_view text) { return formats::is_length_recording(text, plan); };
  EXPECT_TRUE(is_recording("time_s,length_mm\n0.00,1.5\n0.01,1.5\n0.02,1.6\n"));
  EXPECT_TRUE(is_recording("time_ms;length_um\n0;1,5\n10;1,5\n20;1,6\n"));
  EXPECT_TRUE(is_recording("0.00,1.5\n0.01,1.5\n"));
  EXPECT_TRUE(is_recording("t,L\n0.00,1.5\n0.01,1.5\n"));
  EXPECT_FALSE(is_recording("length_difference_mm\n1.5\n2.5\n"));
  EXPECT_FALSE(is_recording("time_s,length_mm\n0,1.5\n6.5,2.5\n13,3.5\n"));
  EXPECT_FALSE(
      is_recording("line,target,direction,run,length_difference_mm,time_s\nx,1,up,1,0.5,0.01\nx,2,up,1,3,0.02\n"));
  EXPECT_FALSE(is_recording(""));
  EXPECT_FALSE(is_recording("nothing of the kind\n"));
}

}  // namespace
}  // namespace axiometry::app
