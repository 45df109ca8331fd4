// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/volumetric/part_lengths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "axiometry/app/recordings/raw_recording.h"
#include "axiometry/app/volumetric/gathered_lengths.h"
#include "axiometry/app/volumetric/planned_points.h"
#include "axiometry/app/volumetric/simulated_recording.h"
#include "axiometry/formats/volumetric/volumetric_lengths_csv.h"
#include "axiometry/volumetric/known_machine_test_support.h"
#include "axiometry/volumetric/plan/point_set.h"

namespace axiometry::app {
namespace {

using volumetric::CalibrationPlan;

constexpr std::size_t part_points = 12;

/// Two stations with two tools each.
CalibrationPlan four_parts() {
  CalibrationPlan plan{.machine = volumetric::testing::known_machine()};
  plan.machine.stations = {{"A", {-150.0, -120.0, -700.0}}, {"B", {1150.0, -100.0, -650.0}}};
  plan.machine.tools.resize(2);
  plan.dwell = Duration::s(2.0);
  for (std::size_t station = 0; station < 2; ++station)
    for (std::size_t tool = 0; tool < 2; ++tool) {
      volumetric::PlannedRun& run = plan.runs.emplace_back(volumetric::PlannedRun{station, tool});
      const double shift = 0.1 + 0.2 * static_cast<double>(2 * station + tool);
      for (const Vector3& q :
           volumetric::short_tour(volumetric::spread_points(plan.machine.travel, part_points, {shift, shift, shift})))
        run.stops.push_back({q});
    }
  return plan;
}

struct RecordedParts {
  CalibrationPlan plan = four_parts();
  volumetric::SimulatedFaults faults = {};
  volumetric::TrueErrors errors = volumetric::drawn_errors(plan.machine.travel, {}, {3, 0});

  volumetric::SimulatedLengths truth() const {
    return *volumetric::simulate_lengths(plan.machine, errors, volumetric::visits_of(plan), faults, {3, 0});
  }
  std::string bytes(PartRange parts) const {
    const auto recording = PartsRecording::make(plan, parts, errors, truth(), {.rate = 25.0}, 3);
    EXPECT_TRUE(recording) << recording.error().message;
    RawSetting setting;
    setting.lengths = true;
    RecordingEncoder encoder = *RecordingEncoder::make(RawLayout::text, setting);
    std::string text = encoder.head();
    EXPECT_TRUE(recording->record([&](std::span<const Sample> samples) -> Result<void> {
      for (const Sample& s : samples) encoder.append(text, s);
      return {};
    }));
    return text;
  }
};

Result<PartLengths> heard_parts(const CalibrationPlan& plan, const std::string& bytes,
                                std::optional<PartRange> said = {}, bool may_hold_all = false) {
  Source source = Source::of_bytes("run.csv", bytes);
  return read_part_recording(source, plan, said, may_hold_all, {});
}

/// Within a segment all lengths are those that were simulated, but for one dead path.
void expect_simulated(const PartLengths& found, const volumetric::SimulatedLengths& truth) {
  std::map<std::tuple<std::size_t, std::size_t, double, double>, double> known;
  for (const auto& r : truth.lengths.readings) known[{r.station, r.tool, r.axes_mm.x, r.axes_mm.y}] = r.length_mm;
  std::map<std::tuple<std::size_t, std::size_t, std::size_t>, double> dead;
  for (const auto& r : found.lengths.readings) {
    const double off = r.length_mm - known.at({r.station, r.tool, r.axes_mm.x, r.axes_mm.y});
    EXPECT_NEAR(dead.emplace(std::tuple(r.station, r.tool, r.segment), off).first->second, off, 2e-4);
  }
}

TEST(PartLengths, GivesTheSimulatedLengthsOfThePartThatItRecognises) {
  const RecordedParts parts;
  for (std::size_t part = 1; part <= 4; ++part) {
    SCOPED_TRACE(part);
    const auto found = heard_parts(parts.plan, parts.bytes({part, part}));
    ASSERT_TRUE(found) << found.error().message;
    EXPECT_EQ(found->parts, (PartRange{part, part}));
    EXPECT_EQ(found->lengths.readings.size(), part_points);
    EXPECT_EQ(found->notes.size(), 1u) << found->notes.back();
    expect_simulated(*found, parts.truth());
  }
}

TEST(PartLengths, KnowsARecordingOfAllParts) {
  const RecordedParts parts;
  const auto found = heard_parts(parts.plan, parts.bytes({1, 4}), {}, true);
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_EQ(found->parts, (PartRange{1, 4}));
  EXPECT_EQ(found->lengths.readings.size(), 4 * part_points);
  expect_simulated(*found, parts.truth());
  for (const auto& r : found->lengths.readings) EXPECT_EQ(r.segment, 0u);
}

TEST(PartLengths, BeginsASegmentWhereTheBeamIsBroken) {
  RecordedParts parts;
  parts.faults.told_breaks = 2;
  parts.faults.lost = 2;
  const auto found = heard_parts(parts.plan, parts.bytes({1, 4}), PartRange{1, 4});
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_EQ(found->lengths.readings.size(), 4 * part_points - 2);
  EXPECT_EQ(found->lengths.segments.size(), 2u);
  expect_simulated(*found, parts.truth());
}

TEST(PartLengths, RefusesAPartThatWasSaidWrongly) {
  const RecordedParts parts;
  const auto found = heard_parts(parts.plan, parts.bytes({2, 2}), PartRange{3, 3});
  ASSERT_FALSE(found);
  EXPECT_NE(found.error().message.find("far better, expected those of part 3 (station B"), std::string::npos)
      << found.error().message;
}

TEST(PartLengths, ToleratesAStationThatStandsElsewhere) {
  RecordedParts parts;
  const std::string bytes = parts.bytes({2, 2});
  parts.plan.machine.stations[0].at_mm += Vector3{9.0, -8.0, 7.0};
  const auto found = heard_parts(parts.plan, bytes);
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_EQ(found->parts, (PartRange{2, 2}));
  EXPECT_EQ(found->lengths.readings.size(), part_points);
}

TEST(PartLengths, GoesIntoATableThatReadsBack) {
  const RecordedParts parts;
  const auto found = heard_parts(parts.plan, parts.bytes({4, 4}));
  ASSERT_TRUE(found) << found.error().message;
  const auto table = formats::read_volumetric_lengths(part_lengths_table(*found));
  ASSERT_TRUE(table) << table.error().message;
  ASSERT_EQ(table->readings.size(), part_points);
  EXPECT_EQ(table->stations, std::vector<std::string>{"B"});
  EXPECT_EQ(table->readings.front().length_mm, found->lengths.readings.front().length_mm);
}

TEST(PartRanges, AreNumbersOrTheFirstAndTheLastOfSeveral) {
  EXPECT_EQ(*parse_part_range("3"), (PartRange{3, 3}));
  EXPECT_EQ(*parse_part_range("2-5"), (PartRange{2, 5}));
  for (const char* wrong : {"", "0", "5-2", "1-2-3", "a", "-3"}) EXPECT_FALSE(parse_part_range(wrong)) << wrong;
}

TEST(PlannedPoints, FindLengthsOfAnotherPart) {
  const RecordedParts parts;
  volumetric::VolumetricLengths lengths = parts.truth().lengths;
  const auto right = check_planned(parts.plan, lengths);
  ASSERT_TRUE(right);
  EXPECT_TRUE(right->empty());
  lengths.readings.front().axes_mm.x += 1.0;
  EXPECT_EQ(check_planned(parts.plan, lengths)->size(), 1u);
  std::swap(lengths.stations[0], lengths.stations[1]);
  const auto wrong = check_planned(parts.plan, lengths);
  ASSERT_FALSE(wrong);
  EXPECT_NE(wrong.error().message.find("named wrongly"), std::string::npos) << wrong.error().message;
}

}  // namespace
}  // namespace axiometry::app
