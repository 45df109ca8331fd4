// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/recordings/raw_recording.h"

#include <gtest/gtest.h>

#include "axiometry/app/recordings/capture_session.h"
#include "tests/support/simulated_recording.h"

namespace axiometry::app {
namespace {

TEST(RawRecording, SaysThatItIsSimulatedWhereItsLayoutHasAPlaceForThat) {
  const RawSetting setting{.samples = 1, .rate = 10.0, .wavelength = Length::nm(632.991)};
  EXPECT_TRUE(says_simulated(RecordingEncoder::make(RawLayout::text, setting)->head()));
  EXPECT_TRUE(says_simulated(RecordingEncoder::make(RawLayout::umd, setting)->head()));
  EXPECT_FALSE(says_simulated(RecordingEncoder::make(RawLayout::npy, setting)->head()));
  EXPECT_FALSE(says_simulated("time_s,position_mm\n"));
  EXPECT_TRUE(says_simulated("\xEF\xBB\xBF# Simulated, not measured\r\n"));
  std::string utf16 = "\xFF\xFE";
  for (const char c : std::string("# Simulated, not measured\r\n")) utf16 += {c, '\0'};
  EXPECT_TRUE(says_simulated(utf16));
  EXPECT_FALSE(says_simulated("# laser 1\n# Simulated, not measured\n")) << "said by somebody else";
}

TEST(RawRecording, PlayedAgainGivesATestThatSaysIt) {
  auto session = CaptureSession::open(testing_support::short_plan(), {});
  ASSERT_TRUE(session);
  ASSERT_TRUE(session->feed(testing_support::recording("good", 3)));
  ASSERT_TRUE(session->finish(CaptureSession::End::of_file));
  EXPECT_TRUE(session->simulated());
  const auto test = session->test();
  ASSERT_TRUE(test) << test.error().to_string();
  EXPECT_EQ(test->metadata.conditions.purpose, "simulation");
  EXPECT_EQ(test->metadata.conditions.comment, "Simulated, not measured");
  EXPECT_EQ(test->metadata.machine.name, "Simulator");
}

TEST(RawRecording, SaysItAlsoInPiecesOfAStreamWhoseLayoutIsStated) {
  CaptureOptions options;
  options.stream = "time-position";
  auto session = CaptureSession::open(testing_support::short_plan(), options);
  ASSERT_TRUE(session);
  const std::string recording = testing_support::recording("good", 3);
  ASSERT_TRUE(session->feed(recording.substr(0, 6)));
  ASSERT_TRUE(session->feed(recording.substr(6)));
  EXPECT_TRUE(session->simulated());
}

}  // namespace
}  // namespace axiometry::app
