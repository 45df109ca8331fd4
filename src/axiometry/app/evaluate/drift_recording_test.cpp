// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/evaluate/drift_recording.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "tests/support/series.h"
#include "tests/support/temporary_folder.h"

namespace axiometry::app {
namespace {

DriftRecording picked(std::size_t count, double step_s) {
  DriftPicker picker;
  for (std::size_t k = 0; k < count; ++k) {
    const Sample sample{step_s * double(k), double(k)};
    EXPECT_TRUE(picker.take({&sample, 1}));
  }
  return picker.picked().value();
}

TEST(DriftRecording, KeepsEveryValueOfAShortRecording) {
  const DriftRecording recording = picked(100, 0.5);
  EXPECT_EQ(recording.values.size(), 100u);
  EXPECT_NEAR(recording.interval.in_s(), 0.5, 1e-12);
}

TEST(DriftRecording, PicksEquallyFarApartOutOfALongOne) {
  const DriftRecording recording = picked(123'456, 0.01);
  EXPECT_LE(recording.values.size(), 2000u);
  EXPECT_GE(recording.values.size(), 900u);
  const double step = recording.interval.in_s() / 0.01;
  for (std::size_t k = 1; k < recording.values.size(); ++k)
    EXPECT_NEAR(recording.values[k] - recording.values[k - 1], step, 1e-6) << k;
}

TEST(DriftRecording, RefusesTooFewValues) {
  DriftPicker picker;
  const Sample sample{0.0, 1.0};
  ASSERT_TRUE(picker.take({&sample, 1}));
  EXPECT_FALSE(picker.picked());
}

TEST(DriftRecording, RefusesWhatIsNoStandstill) {
  const auto file = std::filesystem::temp_directory_path() / "axiometry_drift_recording_test.csv";
  std::ofstream(file) << "time_s,position_mm\n"
                      << [] {
                           std::string text;
                           for (int k = 0; k < 50; ++k) text += std::to_string(k) + "," + std::to_string(k) + "\n";
                           return text;
                         }();
  EXPECT_FALSE(read_drift_recording(file.string(), AxisKind::linear));
  std::filesystem::remove(file);
}

TEST(DriftRecording, TakesTheFirstOfSeveralColumnsUnlessOneIsCalledThePosition) {
  const testing_support::TemporaryFolder folder;
  const auto spread = [&](const std::string& head) {
    std::string text = head + "\n";
    for (int k = 0; k < 50; ++k) text += fmt::format("{},{},{}\n", k, 1e-3 * (k % 2), 5e-3 * (k % 2));
    const auto recording = read_drift_recording(folder.written("still.csv", text), AxisKind::linear);
    EXPECT_TRUE(recording) << recording.error().message;
    if (!recording) return 0.0;
    const auto [least, most] = std::ranges::minmax(recording->values);
    return most - least;
  };
  EXPECT_NEAR(spread("time_s,x_mm,y_mm"), 1.0, 1e-9);
  EXPECT_NEAR(spread("time_s,x_mm,position_mm"), 5.0, 1e-9);
}

TEST(DriftRecording, RefusesAGapThatNobodyKnowsTheDriftOf) {
  DriftPicker picker;
  for (double time : {0.0,    1.0,    2.0,    3.0,    4.0,    5.0,    6.0,    7.0,    8.0,    9.0,   1000.0,
                      1001.0, 1002.0, 1003.0, 1004.0, 1005.0, 1006.0, 1007.0, 1008.0, 1009.0, 1010.0}) {
    const Sample sample{time, time};
    ASSERT_TRUE(picker.take({&sample, 1}));
  }
  EXPECT_EQ(
      picker.picked().error().message,
      "found a gap of 991 s after 9 s in values about 1 s apart, expected a recording at standstill without gaps");
}

TEST(DriftRecording, TakesTheUsualIntervalWhereTheFirstIsAnother) {
  DriftPicker picker;
  for (int k = 0; k < 100; ++k) {
    const Sample sample{k == 0 ? 9.5 : 10.0 * k, double(k)};
    ASSERT_TRUE(picker.take({&sample, 1}));
  }
  EXPECT_NEAR(picker.picked()->interval.in_s(), 10.0, 1e-12);
}

/// Time that passes without samples makes no values.
TEST(DriftRecording, CountsSamplesAndNotWhatIsHeldBetweenThem) {
  DriftPicker picker;
  for (double time : {0.0, 1.0, 1000.0}) {
    const Sample sample{time, time};
    ASSERT_TRUE(picker.take({&sample, 1}));
  }
  EXPECT_FALSE(picker.picked());
}

TEST(DriftRecording, TakesThePlaceOfAVariationThatTheFileStates) {
  axiometry::Test test{{}, testing_support::table2::series(), {}};
  for (int k = 0; k < 200; ++k) test.metadata.gum.drift_recording.push_back(std::sin(0.1 * k));
  test.metadata.gum.drift_interval = Duration::s(10.0);
  test.metadata.uncertainty.environmental_variation = Deviation::native(0.5);
  const axiometry::Test replaced = with_recorded_variation(test);
  EXPECT_NEAR(replaced.metadata.uncertainty.environmental_variation->in_native(), 2.0, 0.01);
  EXPECT_EQ(replaced.provenance.remarks.front().message,
            "uncertainty.environmental_variation = 0.5 µm does not count: the recording at standstill takes its place");

  test.provenance.stated.items = {{"uncertainty.environmental_variation", StatedBy::flag}};
  const axiometry::Test kept = with_recorded_variation(test);
  EXPECT_EQ(kept.metadata.uncertainty.environmental_variation->in_native(), 0.5);
  EXPECT_TRUE(kept.metadata.gum.drift_recording.empty());
  EXPECT_EQ(kept.provenance.remarks.size(), 1u);
}

TEST(DriftRecording, TellsOfOneThatSaysNothing) {
  axiometry::Test test{{}, testing_support::table2::series(), {}};
  test.metadata.gum.drift_recording.assign(200, 0.25);
  test.metadata.gum.drift_interval = Duration::s(10.0);
  test.metadata.uncertainty.environmental_variation = Deviation::native(0.5);
  const axiometry::Test told = with_recorded_variation(test);
  EXPECT_EQ(told.metadata.uncertainty.environmental_variation->in_native(), 0.5);
  EXPECT_EQ(told.provenance.remarks.size(), 1u);
}

TEST(DriftRecording, GivesATestItsEnvironmentalVariation) {
  axiometry::Test test{{}, testing_support::table2::series(), {}};
  for (int k = 0; k < 200; ++k) test.metadata.gum.drift_recording.push_back(std::sin(0.1 * k));
  test.metadata.gum.drift_interval = Duration::s(10.0);
  const axiometry::Test stated = with_recorded_variation(test);
  EXPECT_NEAR(stated.metadata.uncertainty.environmental_variation->in_native(), 2.0, 0.01);
  EXPECT_EQ(stated.provenance.remarks.size(), 1u);
  EXPECT_EQ(with_recorded_variation(stated).provenance.remarks.size(), 1u) << "once";
}

}  // namespace
}  // namespace axiometry::app
