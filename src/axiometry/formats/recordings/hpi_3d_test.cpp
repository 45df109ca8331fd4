// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "axiometry/base/text/number_text.h"
#include "axiometry/formats/recording.h"
#include "axiometry/formats/recordings/hpi_frames.h"
#include "tests/support/hpi_frames.h"
#include "tests/support/recording_feed.h"

namespace axiometry::formats {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing_support::hpi_distance;
using testing_support::hpi_frame;
using testing_support::hpi_velocity;
using testing_support::hpi_weather;
using testing_support::read_samples;
using testing_support::same_however_cut;

std::string bytes_of(std::initializer_list<unsigned> values) {
  std::string text;
  for (unsigned value : values) text += static_cast<char>(value);
  return text;
}

std::string shown(std::string_view bytes, RecordingOptions options = {}) {
  EXPECT_TRUE(same_however_cut("hpi-3d", bytes, options));
  const auto read = read_samples("hpi-3d", bytes, options);
  std::string text = read.refusal;
  for (const Sample& s : read.samples)
    text += (text.empty() ? "" : " ") + format_exact(s.time_s) + ":" + format_exact(s.position);
  return text;
}

RecordingOptions skipping() {
  RecordingOptions options;
  options.skip_damaged = true;
  return options;
}

std::vector<std::string> hpi_remarks(std::string_view bytes, RecordingOptions options = skipping()) {
  auto reader = find_recording("hpi-3d")->open(options);
  const SampleSink none = [](std::span<const Sample>) -> Result<void> { return {}; };
  static_cast<void>((*reader)->feed(bytes, none));
  static_cast<void>((*reader)->finish(none));
  return (*reader)->remarks();
}

// Bytes computed by a program of its own.
TEST(Hpi3d, ReadsFramesThatWereMadeElsewhere) {
  const std::string frames =
      bytes_of({0xaa, 0xb0, 0x15, 0, 0, 0, 0x06, 0xac, 0xfc, 0, 0, 0, 0, 0x09, 0x5a, 0x6a}) +
      bytes_of({0xaa, 0xb0, 0x15, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0, 0, 0, 0x09, 0x5a, 0x7e});
  EXPECT_EQ(shown(frames), "0:11.2 0.04:-1e-07");
  EXPECT_EQ(hpi::commands_to_begin(),
            bytes_of({0xaa, 0xb0, 0x32, 0, 0, 0, 0, 0x8e, 0xaa, 0xb0, 0x79, 0, 0, 0, 0, 0x35}));
}

TEST(Hpi3d, CountsDistancesAtTheRateOfTheInstrumentOrTheOneStated) {
  const std::string frames = hpi_distance(1) + hpi_distance(-2.5) + hpi_distance(70'000);
  EXPECT_EQ(shown(frames), "0:1 0.04:-2.5 0.08:70000");
  RecordingOptions options;
  options.rate_hz = 10;
  EXPECT_EQ(shown(frames, options), "0:1 0.1:-2.5 0.2:70000");
  options = {};
  options.arrival_s = [] { return 3.5; };
  EXPECT_EQ(shown(frames, options), "3.5:1 3.5:-2.5 3.5:70000");
  options.arrival_s = [] { return std::numeric_limits<double>::quiet_NaN(); };
  EXPECT_EQ(read_samples("hpi-3d", frames, options).lost, 3u);
}

TEST(Hpi3d, IsKnownByItsFramesFromTheMiddleOfOneOn) {
  const std::string stream = hpi_distance(1).substr(5) + hpi_distance(2) + hpi_weather(0, 20, 40, 1000);
  ASSERT_TRUE(recognise_recording(stream));
  EXPECT_EQ((*recognise_recording(stream))->id, "hpi-3d");
  EXPECT_EQ(shown(stream), "0:2");
  EXPECT_THAT(hpi_remarks(stream), testing::Contains("passed over 11 bytes of a frame that had begun before"));
  EXPECT_EQ(find_recording("hpi-3d")->recognise(std::string(65536, '\xAA')), 0);
}

TEST(Hpi3d, RefusesBytesThatAreNoFrameOrPassesOverThemAndCountsWhatIsLost) {
  std::string harmed = hpi_distance(2);
  harmed[6] ^= 1;  // one bit
  const std::string stream = hpi_distance(1) + harmed + hpi_distance(3) + hpi_distance(4).substr(3) + hpi_distance(5);
  EXPECT_EQ(shown(stream),
            "found bytes that are no frame behind frame 1, expected AA B0, 16 bytes with a check that is right 0:1");
  EXPECT_EQ(shown(stream, skipping()), "0:1 0.08:3 0.16:5");
  EXPECT_EQ(read_samples("hpi-3d", stream, skipping()).lost, 2u);
  EXPECT_THAT(hpi_remarks(stream), testing::Contains("29 bytes between the frames made no frame whose check is right; "
                                                     "counted as 2 lost samples"));
}

TEST(Hpi3d, CountsADamagedFrameOfTheWeatherAsThatAndNotAsALostDistance) {
  std::string weather = hpi_weather(0, 20, 40, 1000), distance = hpi_distance(2);
  weather[8] ^= 4, distance[8] ^= 4;
  const std::string between = hpi_distance(1) + weather + hpi_distance(2) + hpi_distance(3);
  EXPECT_EQ(shown(between, skipping()), "0:1 0.04:2 0.08:3");
  EXPECT_EQ(read_samples("hpi-3d", between, skipping()).lost, 0u);
  EXPECT_THAT(hpi_remarks(between), testing::Contains("16 bytes between the frames made no frame whose check is right; "
                                                      "counted as 1 damaged frame of the weather"));
  const std::string both = hpi_distance(1) + weather.substr(0, 12) + distance + weather + hpi_distance(3);
  EXPECT_EQ(shown(both, skipping()), "0:1 0.08:3");
  EXPECT_EQ(read_samples("hpi-3d", both, skipping()).lost, 1u);
  EXPECT_THAT(hpi_remarks(both), testing::Contains(HasSubstr("counted as 1 lost sample and 2 damaged frames of the "
                                                             "weather")));
}

TEST(Hpi3d, NoSingleBitCanBeWrongUnnoticed) {
  const std::string good = hpi_distance(123.4567);
  for (std::size_t bit = 0; bit < 8 * good.size(); ++bit) {
    std::string harmed = good;
    harmed[bit / 8] = static_cast<char>(harmed[bit / 8] ^ (1 << bit % 8));
    EXPECT_FALSE(hpi::frame_at(harmed)) << bit;
  }
}

TEST(Hpi3d, LeavesOutWhatTheInstrumentFlags) {
  const std::string stream =
      hpi_distance(1) + hpi_distance(2, {.too_fast = true}) + hpi_distance(3, {.weak = true}) + hpi_distance(4);
  EXPECT_EQ(shown(stream), "0:1 0.12:4");
  EXPECT_EQ(read_samples("hpi-3d", stream).lost, 2u);
  EXPECT_THAT(hpi_remarks(stream), testing::IsSupersetOf({HasSubstr("left out 1 sample with the instrument's flag of "
                                                                    "too high a speed"),
                                                          HasSubstr("left out 1 sample with the instrument's flag of "
                                                                    "too weak a signal")}));
  EXPECT_THAT(shown(hpi_distance(1, {.weak = true})), HasSubstr("found no distance without the instrument's flag of "
                                                                "too weak a signal"));
  EXPECT_THAT(hpi_remarks(hpi_distance(1, {.ready = false})), testing::Contains(HasSubstr("1 sample came while")));
}

TEST(Hpi3d, TakesTheWeatherOfTheAirAndOfSensorsThatTouch) {
  const std::string stream = hpi_weather(0, 20.5, 40, 1001.2) + hpi_distance(1) + hpi_weather(2, 22.25, 0, 0) +
                             hpi_weather(0, -3.75, 45, 999.9) + hpi_weather(2, 22.5, 0, 0) + hpi_weather(0, 300, 1, 1);
  const Environment air = read_samples("hpi-3d", stream).environment;
  EXPECT_DOUBLE_EQ(air.air_temperature_start->in_celsius(), 20.5);
  EXPECT_DOUBLE_EQ(air.air_temperature_end->in_celsius(), -3.75);
  EXPECT_DOUBLE_EQ(air.air_humidity_end->in_percent(), 45.0);
  EXPECT_DOUBLE_EQ(air.air_pressure_start->in_kPa(), 100.12);
  EXPECT_DOUBLE_EQ(air.air_pressure_end->in_kPa(), 99.99);
  ASSERT_EQ(air.sensors.size(), 1u);
  EXPECT_EQ(air.sensors[0].location, "sensor 2");
  EXPECT_DOUBLE_EQ(air.sensors[0].start->in_celsius(), 22.25);
  EXPECT_DOUBLE_EQ(air.sensors[0].end->in_celsius(), 22.5);
  EXPECT_THAT(hpi_remarks(stream), testing::Contains("left out 1 value of the weather that no sensor shows"));
}

TEST(Hpi3d, RefusesWhatIsNoStreamOfDistances) {
  std::string velocities;
  for (int k = 0; k < 300; ++k) velocities += hpi_velocity();
  EXPECT_THAT(shown(velocities), HasSubstr("found velocities and no distance"));
  EXPECT_THAT(shown(hpi_velocity()), HasSubstr("found velocities and no distance"));
  EXPECT_THAT(shown(hpi_frame('\x32', std::string(12, '\0'))), HasSubstr("found no frame with a distance"));
  EXPECT_THAT(shown(""), HasSubstr("found no frame with a distance"));
  EXPECT_THAT(read_samples("hpi-3d", hpi_distance(1) + std::string(9000, '\xAA'), skipping()).refusal,
              HasSubstr("found 4096 bytes without a frame"));
  EXPECT_THAT(shown(hpi_distance(1) + "\xAA\xB0"), HasSubstr("found 2 bytes behind the last frame"));
  EXPECT_THAT(shown(hpi_distance(1) + "\xAA"), HasSubstr("found 1 byte behind the last frame"));
  RecordingOptions options;
  options.kind = AxisKind::rotary;
  EXPECT_FALSE(find_recording("hpi-3d")->open(options));
  options = {};
  options.units_per_count = 1.0;
  EXPECT_FALSE(find_recording("hpi-3d")->open(options));
  options = {};
  options.axis = 1;
  EXPECT_FALSE(find_recording("hpi-3d")->open(options));
}

TEST(Hpi3d, TellsPausesOfALiveStreamButNotThoseOfABrokenConnection) {
  double now = 0.0;
  RecordingOptions options = skipping();
  options.arrival_s = [&now] { return now; };
  auto reader = find_recording("hpi-3d")->open(options);
  const SampleSink none = [](std::span<const Sample>) -> Result<void> { return {}; };
  for (double at : {0.0, 0.04, 4.04}) {
    now = at;
    ASSERT_TRUE((*reader)->feed(hpi_distance(at), none));
  }
  ASSERT_TRUE((*reader)->interrupted(none));
  now = 60.0;
  ASSERT_TRUE((*reader)->feed(hpi_distance(5), none));
  EXPECT_THAT((*reader)->remarks(), ElementsAre("the instrument was silent for more than a second 1 time, 4.0 s at "
                                                "most: samples may be missing there"));
}

}  // namespace
}  // namespace axiometry::formats
