// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "axiometry/base/text/number_text.h"
#include "axiometry/formats/recording.h"
#include "axiometry/formats/recordings/time_text.h"
#include "tests/support/hpi_frames.h"
#include "tests/support/recording_feed.h"
#include "tests/support/rtx_file.h"

namespace axiometry::formats {
namespace {

using testing::HasSubstr;
using testing_support::read_samples;
using testing_support::ReadSamples;
using testing_support::same_however_cut;

std::string text_of(const ReadSamples& read) {
  std::string text = read.refusal;
  for (const Sample& s : read.samples)
    text += (text.empty() ? "" : " ") + format_exact(s.time_s) + ":" + format_exact(s.position);
  return text;
}

std::string from_text(std::string_view bytes, RecordingOptions options = {}) {
  EXPECT_TRUE(same_however_cut("time-position", bytes, options));
  return text_of(read_samples("time-position", bytes, options));
}

RecordingOptions rotary() {
  RecordingOptions options;
  options.kind = AxisKind::rotary;
  return options;
}

TEST(TimePosition, ReadsEveryDelimiterAndDecimalMark) {
  EXPECT_EQ(from_text("0,1.5\n0.1,1.25\n"), "0:1.5 0.1:1.25");
  EXPECT_EQ(from_text("0;1,5\n0,1;1,25\n"), "0:1.5 0.1:1.25");
  EXPECT_EQ(from_text("0\t1,5\n0,1\t1,25"), "0:1.5 0.1:1.25");
  EXPECT_EQ(from_text("  0   1.5\r\n0.1 \t 1.25\r\n"), "0:1.5 0.1:1.25");
  EXPECT_EQ(from_text("0,0 1,5\n0,1 1,25\n"), "0:1.5 0.1:1.25");
  EXPECT_EQ(from_text("# comment\n\n0;1.5;\n% more\n0.1;1.25;\n"), "0:1.5 0.1:1.25");
}

/// As programs of Windows write it: with a byte order mark, low bytes first.
std::string windows_utf16(std::u16string_view text) {
  std::string bytes = "\xFF\xFE";
  for (const char16_t unit : text) (bytes += static_cast<char>(unit & 0xFF)) += static_cast<char>(unit >> 8);
  return bytes;
}

TEST(TimePosition, ReadsUtf16AsUtf8) {
  const std::string bytes = windows_utf16(u"t [ms];x [\u00B5m]\r\n250;1500\r\n500;1250\r\n");
  EXPECT_EQ(from_text(bytes), "0.25:1.5 0.5:1.25");
  const auto known = recognise_recording(bytes);
  ASSERT_TRUE(known) << known.error().message;
  EXPECT_EQ((*known)->id, "time-position");
  const auto reader = (*known)->open({});
  ASSERT_TRUE(reader);
  ASSERT_TRUE((*reader)->feed(bytes, [](auto) { return Result<void>{}; }));
  EXPECT_THAT((*reader)->remarks(), testing::ElementsAre("found text that is not UTF-8; it was read as UTF-16"));
  const std::string log = windows_utf16(u"IOC:X 2026-11-21 12:00:00.0 -5.0001\nIOC:X 2026-11-21 12:00:00.1 -5\n");
  EXPECT_EQ((*recognise_recording(log))->id, "camonitor-stream");
  EXPECT_EQ(text_of(read_samples("camonitor-stream", log, {})), "0:-5.0001 0.1:-5");
}

TEST(TimePosition, SaysWhichUnitsItTookForGranted) {
  const auto remarks = [](std::string_view bytes) {
    const auto reader = (*recognise_recording(bytes))->open({});
    EXPECT_TRUE(reader && (*reader)->feed(bytes, [](auto) { return Result<void>{}; }));
    return (*reader)->remarks();
  };
  EXPECT_THAT(remarks("t,pos\n0,1\n1,2\n"),
              testing::ElementsAre("the header names no unit of the time, which is taken to be in seconds",
                                   "the header names no unit of the position, which is taken to be in mm"));
  EXPECT_THAT(remarks("t [ms];x [mm]\n0;1\n1;2\n"), testing::IsEmpty());
  EXPECT_THAT(remarks("0;1\n1;2\n"), testing::IsEmpty()) << "s and mm by definition";
}

TEST(TimePosition, TakesUnitsFromTheHeader) {
  EXPECT_EQ(from_text("time_s,position_mm\n1,2\n"), "1:2");
  EXPECT_EQ(from_text("\xEF\xBB\xBFt [ms];x [µm]\n250;1500\n"), "0.25:1.5");
  EXPECT_EQ(from_text("Position (um)\tTime (us)\n1500\t250000\n"), "0.25:1.5");
  EXPECT_EQ(from_text("s mm\n1 2\n"), "1:2");
  EXPECT_EQ(from_text("time/s,angle/arcsec\n1,7200\n", rotary()), "1:2");
  EXPECT_EQ(from_text("zeit_min;weg_nm\n0,5;1500000\n"), "30:1.5");
}

TEST(TimePosition, ReadsPointsInTime) {
  EXPECT_EQ(from_text("2026-11-21T23:59:59.750Z,1\n2026-11-22T00:00:00.250Z,2\n"), "0:1 0.5:2");
  EXPECT_EQ(from_text("2026-11-21 12:00:00,5;1,5\n2026-11-21 12:00:01,0;2,5\n"), "0:1.5 0.5:2.5");
  EXPECT_EQ(from_text("2026-11-21 12:00:00.5 1.5\n2026-11-21 12:00:01.0 2.5\n"), "0:1.5 0.5:2.5");
  EXPECT_EQ(from_text("time,position_um\n2026-11-21T12:00:00+01:00,1\n2026-11-21T11:00:01Z,2\n"), "0:0.001 1:0.002");
}

TEST(TimePosition, ReadsStampsThatAreCenturiesApart) {
  EXPECT_EQ(from_text("1900-01-01T00:00:00Z,1\n2200-01-01T00:00:00Z,2\n"), "0:1 9467107200:2");
}

TEST(TimePosition, TakesOneOfSeveralColumns) {
  RecordingOptions second;
  second.axis = 1;
  EXPECT_EQ(from_text("time_s,x_mm,y_um\n1,2,3000\n", second), "1:3");
  EXPECT_EQ(from_text("1 2 3\n", second), "1:3");
}

TEST(TimePosition, TakesOfSeveralColumnsOnlyTheOneThatSaysToBeThePosition) {
  EXPECT_EQ(from_text("time_s,setpoint_mm,position_mm\n1,2,3\n"), "1:3");
  EXPECT_EQ(from_text("time_s,temperature_C,position_mm\n1,20,3\n"), "1:3");
  EXPECT_EQ(from_text("time,command,actual\n1,2,3\n"), "1:3");
  const auto refused = [](std::string_view bytes) { return read_samples("time-position", bytes).refusal; };
  EXPECT_THAT(
      refused("time_s,x_mm,y_mm\n1,2,3\n"),
      HasSubstr("found the columns \"x\", \"y\" beside the time, expected the number of the one with the position"));
  EXPECT_THAT(refused("time_s,a,b\n1,2,3\n"), HasSubstr("expected the number of the one with the position"));
  EXPECT_THAT(refused("time_s,temperature_C\n1,2\n"),
              HasSubstr("found the column \"temperature_C\", expected positions"));
  RecordingOptions first;
  first.axis_stated = true;
  EXPECT_EQ(from_text("time_s,x_mm,y_mm\n1,2,3\n", first), "1:2");
  EXPECT_EQ(from_text("1,2,3\n2,4,6\n", first), "1:2 2:4") << "without a header too";
  EXPECT_THAT(refused("1,2,3\n"), HasSubstr("expected two columns, time and position"));
}

TEST(TimePosition, RefusesWhatItHasNoUseFor) {
  RecordingOptions counted;
  counted.units_per_count = 0.001;
  EXPECT_THAT(read_samples("time-position", "1,2\n", counted).refusal, HasSubstr("found a length per count"));
  RecordingOptions rated;  // as the options of kept recordings may hold it
  rated.rate_hz = 7.0;
  for (const char* layout : {"time-position", "npy", "camonitor-stream"}) {
    const auto reader = find_recording(layout)->open(rated);
    ASSERT_TRUE(reader) << layout;
    EXPECT_THAT((*reader)->remarks(), ::testing::Contains(std::string(unused_rate))) << layout;
  }
}

TEST(TimePosition, RefusesWhatIsNoSampleAndSaysWhere) {
  EXPECT_EQ(from_text("0,1\n1,nan\n"), "line 2:1: found \"nan\", expected a finite number as position 0:1");
  EXPECT_EQ(from_text("0,1\n1,2\n0.5,3\n"),
            "line 3:1: found time running backwards from 1 s to 0.5 s, expected samples in order of time 0:1 1:2");
  EXPECT_EQ(from_text("0,1\n1,2garbage\n"), "line 2:1: found \"2garbage\", expected a finite number as position 0:1");
  EXPECT_EQ(from_text("0,1\n1,2,3\n"), "line 2:1: found \"1,2,3\", expected 2 columns as in the lines before 0:1");
  EXPECT_EQ(from_text("0,1\n1\n"), "line 2:1: found \"1\", expected 2 columns as in the lines before 0:1");
  EXPECT_EQ(from_text("0,1\n1,1e999\n"), "line 2:1: found \"1e999\", expected a finite number as position 0:1");
  EXPECT_EQ(from_text("0,1\n1,1.7e308\n"),
            "line 2:1: found a number beyond 1e15, or none, expected time and position 0:1")
      << "the sum of two such would be infinite";
  EXPECT_EQ(from_text("0,1\n1e16,2\n"),
            "line 2:1: found a number beyond 1e15, or none, expected time and position 0:1");
  EXPECT_EQ(from_text("time_s,angle_deg\n0,1\n"),
            "line 1:1: found positions in °, expected a unit of length for a linear axis");
  EXPECT_EQ(from_text("hello world\n"),
            "line 1:1: found \"hello world\", expected two columns, time and position, perhaps below a header such as "
            "time_s,position_mm");
  EXPECT_EQ(from_text("time_s,position_mm\n"), "found no sample, expected lines of time and position");
  EXPECT_EQ(from_text(""), "found no sample, expected lines of time and position");
  EXPECT_EQ(from_text("2026-11-21T12:00:00Z,1\n2026-13-21T12:00:00Z,1\n"),
            "line 2:1: found \"2026-13-21T12:00:00Z\", expected a time such as 2026-11-21T12:34:56.789 0:1");
}

TEST(TimePosition, RefusesALineThatIsTooLongInTheSameWordsHoweverItCame) {
  const std::string longest = "0 " + std::string(4090, ' ') + "0.10";
  EXPECT_EQ(longest.size(), 4096u);
  EXPECT_EQ(from_text(longest + "\r\n1 0.20\n"), "0:0.1 1:0.2");
  EXPECT_THAT(from_text("0 0.1\n1 " + longest + "\n"),
              HasSubstr("2:1: found a line of more than 4096 bytes, expected one sample a line"));
}

TEST(TimePosition, PassesOverDamagedLinesWhereThatIsAskedForAndCountsThem) {
  RecordingOptions options;
  options.skip_damaged = true;
  const std::string bytes = "0,1\n1,\xFF\xFE\n2,3\n1.5,9\n4,\n5,6\n";
  EXPECT_EQ(from_text(bytes, options), "0:1 2:3 5:6");
  EXPECT_EQ(read_samples("time-position", bytes, options).lost, 3u);
  std::string garbage = "0,1\n";
  for (int k = 0; k < 200; ++k) garbage += "?\n";
  EXPECT_NE(read_samples("time-position", garbage, options).refusal, "");
}

RecordingOptions counts(double units_per_count = 1.0) {
  RecordingOptions options;
  options.units_per_count = units_per_count;
  return options;
}

std::string from_umd(std::string_view bytes, RecordingOptions options = counts()) {
  EXPECT_TRUE(same_however_cut("umd", bytes, options));
  return text_of(read_samples("umd", bytes, options));
}

TEST(Umd, ReadsCountsFractionsAndTheRateOfTheStream) {
  EXPECT_EQ(
      from_umd("Minimalist Homodyne Test:\r\n0 0 12 0 0 1 10 105\r\n0 0 12 0 -64 2 8 10000\r\n0 0 15 3 128 3 0 0\r\n"),
      "0:12 0.01:11.75 0.02:15.5");
  EXPECT_EQ(from_umd("0 0 12 0 0 1 0 0\n0 0 14 0 0 2 8 10000", counts(0.5)), "0:6 0.01:7");
}

TEST(Umd, TakesTheRateThatIsGivenOrTheArrival) {
  RecordingOptions options = counts();
  options.rate_hz = 10.0;
  EXPECT_EQ(from_umd("0 0 1 0 0 1 8 10000\n0 0 2 0 0 2 0 0\n", options), "0:1 0.1:2");
  options = counts();
  options.arrival_s = [] { return 7.0; };
  EXPECT_EQ(from_umd("0 0 1 0 0 1 0 0\n0 0 2 0 0 2 0 0\n", options), "7:1 7:2");
}

TEST(Umd, CountsWhatTheSequenceShowsToBeLost) {
  RecordingOptions options = counts();
  options.rate_hz = 1.0;
  EXPECT_EQ(from_umd("0 0 1 0 0 7 0 0\n0 0 2 0 0 10 0 0\n", options), "0:1 3:2");
  EXPECT_EQ(read_samples("umd", "0 0 1 0 0 7 0 0\n0 0 2 0 0 10 0 0\n", options).lost, 2u);
  // 16 bits turn over, with a sign and without.
  EXPECT_EQ(from_umd("0 0 1 0 0 65535 0 0\n0 0 2 0 0 0 0 0\n", options), "0:1 1:2");
  EXPECT_EQ(from_umd("0 0 1 0 0 32767 0 0\n0 0 2 0 0 -32768 0 0\n", options), "0:1 1:2");
  EXPECT_EQ(from_umd("0 0 1 0 0 9 0 0\n0 0 2 0 0 9 0 0\n", options),
            "line 2:1: found the sample counter 9 after 9, expected it to grow 0:1");
}

TEST(Umd, RefusesNumbersThatNoCounterHasInsteadOfOverflowing) {
  RecordingOptions options = counts();
  options.rate_hz = 1.0;
  const std::string first = "0 0 1 0 0 1 0 0\n";
  for (const std::string number : {"-9223372036854775808", "9223372036854775807", "9007199254740993"}) {
    EXPECT_THAT(from_umd(first + "0 0 1 0 0 " + number + " 0 0\n", options), HasSubstr("expected 8 whole numbers"));
    EXPECT_THAT(from_umd(first + "0 0 " + number + " 0 0 2 0 0\n", options), HasSubstr("expected 8 whole numbers"));
    EXPECT_THAT(from_umd(first + "0 0 1 0 " + number + " 2 0 0\n", options), HasSubstr("expected 8 whole numbers"));
  }
  EXPECT_THAT(
      from_umd("0 0 1 0 0 -9007199254740992 0 0\n0 0 1 0 0 9007199254740992 0 0\n", options),
      HasSubstr("found the sample counter 9007199254740992 after -9007199254740992, expected it to grow by less"));
}

TEST(Umd, NeverUsesASampleWithAnErrorCode) {
  RecordingOptions options = counts();
  options.rate_hz = 1.0;
  for (const char* code : {"512", "1024", "2048", "4096", "8192", "16384"}) {
    const std::string bytes = "0 0 1 0 0 1 0 0\n0 0 900 0 " + std::string(code) + " 2 0 0\n0 0 3 0 0 3 0 0\n";
    EXPECT_EQ(from_umd(bytes, options), "0:1 2:3");
    EXPECT_EQ(read_samples("umd", bytes, options).lost, 1u);
  }
}

TEST(Umd, ReadsOneOfThreeAxes) {
  const std::string bytes = "0 0 1 0 0 1 8 100 0 2 0 128 0 3 0 -128\n";
  for (std::size_t axis = 0; axis < 3; ++axis) {
    RecordingOptions options = counts();
    options.axis = axis;
    EXPECT_EQ(from_umd(bytes, options), axis == 0 ? "0:1" : "0:2.5");
  }
  RecordingOptions second = counts();
  second.axis = 1;
  EXPECT_EQ(from_umd("0 0 1 0 0 1 8 100\n", second),
            "line 1:1: found a stream of one axis, expected one of three to take axis 2 from");
}

TEST(Umd, TellsOfTheAir) {
  const auto read = read_samples(
      "umd", "0 0 1 0 0 1 3 2010\n0 0 1 0 0 2 5 101325\n0 0 1 0 0 3 6 455\n0 0 1 0 0 4 3 2040\n0 0 1 0 0 5 8 100\n",
      counts());
  EXPECT_EQ(read.refusal, "");
  EXPECT_EQ(read.environment.air_temperature_start, Temperature::celsius(20.10));
  EXPECT_EQ(read.environment.air_temperature_end, Temperature::celsius(20.40));
  EXPECT_EQ(read.environment.air_pressure_start, Pressure::kPa(101.325));
  EXPECT_EQ(read.environment.air_humidity_end, RelativeHumidity::percent(45.5));
}

TEST(Umd, RefusesWhatItCannotKnowOrRead) {
  EXPECT_TRUE(read_samples("umd", "0 0 1 0 0 1 0 0\n").refusal.starts_with("found no length of a count"));
  EXPECT_EQ(from_umd("0 0 1 0 0 1 0 0\n"),
            "found no sample rate (code 8) in 1 sample, expected one, or a rate that is stated");
  EXPECT_EQ(from_umd("0 0 1 0 0 1 8 100\n0 0 1 0 x 2 0 0\n"),
            "line 2:1: found \"0 0 1 0 x 2 0 0\", expected 8 whole numbers as in the lines before 0:1");
  EXPECT_EQ(from_umd("0 0 1 0 0 1 8 100\n0 0 1.5 0 0 2 0 0\n"),
            "line 2:1: found \"0 0 1.5 0 0 2 0 0\", expected 8 whole numbers as in the lines before 0:1");
  EXPECT_EQ(from_umd("0 0 1 0 0 1 8 100\n0 0 1 0 0 2 8 200\n"),
            "line 2:1: found a sample rate of 2 Hz after 1 Hz, expected one for the whole recording 0:1");
  EXPECT_EQ(from_umd("hello\n"), "found no line of 8 or 16 whole numbers, expected a µMD stream");
}

TEST(Umd, ForgetsACutLineWhereTheConnectionBroke) {
  RecordingOptions options = counts();
  options.rate_hz = 1.0;
  auto reader = find_recording("umd")->open(options);
  ASSERT_TRUE(reader);
  ReadSamples read;
  const SampleSink sink = [&](std::span<const Sample> samples) -> Result<void> {
    read.samples.insert(read.samples.end(), samples.begin(), samples.end());
    return {};
  };
  ASSERT_TRUE((*reader)->feed("0 0 1 0 0 1 0 0\n0 0 2 0 0 2", sink));
  ASSERT_TRUE((*reader)->interrupted(sink));
  ASSERT_TRUE((*reader)->feed("4 0 0\n0 0 5 0 0 5 0 0\n", sink));
  ASSERT_TRUE((*reader)->finish(sink));
  EXPECT_EQ(text_of(read), "0:1 4:5");
  EXPECT_EQ((*reader)->lost(), 3u);
}

std::string npy(std::string_view header, std::vector<double> values, char version = 1) {
  std::string bytes = "\x93NUMPY";
  bytes += version;
  bytes += '\0';
  const auto size = static_cast<unsigned>(header.size());
  for (int k = 0; k < (version == 1 ? 2 : 4); ++k) bytes += static_cast<char>(size >> (8 * k));
  bytes += header;
  for (double x : values)
    for (int k = 0; k < 8; ++k) bytes += static_cast<char>(std::bit_cast<std::uint64_t>(x) >> (8 * k));
  return bytes;
}

std::string from_npy(std::string_view bytes) {
  EXPECT_TRUE(same_however_cut("npy", bytes));
  return text_of(read_samples("npy", bytes));
}

constexpr std::string_view plain = "{'descr': '<f8', 'fortran_order': False, 'shape': (3, 2), }\n";

TEST(Npy, ReadsArraysAndRecords) {
  EXPECT_EQ(from_npy(npy(plain, {0, 1, 0.5, 2, 1, 3})), "0:1 0.5:2 1:3");
  EXPECT_EQ(from_npy(npy(plain, {0, 1, 0.5, 2, 1, 3}, 2)), "0:1 0.5:2 1:3");
  EXPECT_EQ(from_npy(npy("{'descr': [('time', '<f8'), ('position', '<f8')], 'fortran_order': False, 'shape': (2,), }\n",
                         {0, 1, 2, 3})),
            "0:1 2:3");
  EXPECT_EQ(from_npy(npy("{'descr': [('position', '<f8'), ('time', '<f8')], 'fortran_order': False, 'shape': (2,), }\n",
                         {1, 0, 3, 2})),
            "0:1 2:3");
}

TEST(Npy, RefusesWhatIsNotAsItsHeaderSaysAndSaysWhere) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(
      from_npy(npy(plain, {0, 1, 0.5, nan, 1, 3})).starts_with("found a number beyond 1e15, or none, in sample 2"));
  EXPECT_TRUE(
      from_npy(npy(plain, {nan, 1, 0.5, 2, 1, 3})).starts_with("found a number beyond 1e15, or none, in sample 1"));
  EXPECT_TRUE(from_npy(npy(plain, {0, 1, 0.5, 2, HUGE_VAL, 3}))
                  .starts_with("found a number beyond 1e15, or none, in sample 3"));
  EXPECT_TRUE(
      from_npy(npy(plain, {0, 1, 0.5, 2, 1, 1e300})).starts_with("found a number beyond 1e15, or none, in sample 3"));
  EXPECT_TRUE(
      from_npy(npy(plain, {0, 1, 0.5, 2, 0.4, 3})).starts_with("found time running backwards from 0.5 s to 0.4 s"));
  EXPECT_TRUE(from_npy(npy(plain, {0, 1, 0.5, 2})).starts_with("found 2 samples, expected 3"));
  EXPECT_TRUE(from_npy(npy(plain, {0, 1, 0.5, 2, 1, 3}).substr(0, 100)).starts_with("found 1 sample, expected 3"));
  EXPECT_TRUE(from_npy(npy(plain, {0, 1, 2, 2, 3, 3, 4, 4})).starts_with("found more than the 3 samples"));
  EXPECT_TRUE(from_npy(npy("{'descr': '<f4', 'fortran_order': False, 'shape': (3, 2), }\n", {}))
                  .starts_with("found numbers of the type"));
  EXPECT_TRUE(from_npy(npy("{'descr': '<f8', 'fortran_order': True, 'shape': (3, 2), }\n", {}))
                  .starts_with("found an array in Fortran order"));
  EXPECT_TRUE(from_npy(npy("{'descr': '<f8', 'fortran_order': False, 'shape': (3, 3), }\n", {}))
                  .starts_with("found an array of the shape (3, 3)"));
  EXPECT_TRUE(from_npy(npy("{'descr': '<f8', 'fortran_order': False, 'shape': (99999999999999999999, 2), }\n", {}))
                  .starts_with("found \"99999999999999999999\""));
  EXPECT_EQ(from_npy("hello"), "found no NumPy array, expected one (.npy)");
  EXPECT_EQ(from_npy(npy(plain, {}).substr(0, 40)), "found a NumPy array that ends in its header, expected samples");
}

std::string from_camonitor(std::string_view bytes, RecordingOptions options = {}) {
  EXPECT_TRUE(same_however_cut("camonitor-stream", bytes, options));
  return text_of(read_samples("camonitor-stream", bytes, options));
}

TEST(Camonitor, ReadsTheVariableThatIsAskedFor) {
  const std::string log =
      "B *** Not connected (PV not found)\nA 2026-11-21 12:00:00.5 1.5\nB 2026-11-21 11:00:00.0 7 LOLO MAJOR\n"
      "A 2026-11-21 12:00:01.0 2.5 HIGH MINOR\nB 2026-11-21 12:00:01.0 8\n";
  EXPECT_EQ(from_camonitor(log), "0:1.5 0.5:2.5");
  RecordingOptions second;
  second.axis = 1;
  EXPECT_EQ(from_camonitor(log, second), "0:7 3601:8");
  second.axis = 2;
  EXPECT_NE(read_samples("camonitor-stream", log, second).refusal, "");
  EXPECT_EQ(from_camonitor("A 2026-11-21 12:00:00 nan\n"),
            "line 1:1: found the value \"nan\", expected a finite number");
  EXPECT_NE(read_samples("camonitor-stream", "A 2026-11-21 12:00:00 1\ngarbage\n").refusal, "");
}

TEST(Recordings, RecogniseTheExampleOfTheirOwnManualAndNoOther) {
  for (const Recording* recording : recording_table()) {
    std::string head;
    if (recording->id == "npy") {
      head = npy(plain, {0, 1, 2, 3, 4, 5});
    } else if (recording->id == "hpi-3d") {
      for (double mm : {1.0, 2.0, 3.0}) head += testing_support::hpi_distance(mm);
    } else if (recording->id == "renishaw-rtx") {
      head = testing_support::rtx_file(std::array{1.0, 2.0, 3.0}, 50.0);
    } else {
      const std::size_t begin = recording->manual.find("```\n") + 4;
      head = recording->manual.substr(begin, recording->manual.find("```", begin) - begin);
    }
    const auto recognised = recognise_recording(head);
    ASSERT_TRUE(recognised) << recording->id;
    EXPECT_EQ((*recognised)->id, recording->id);
    const RecordingOptions options = recording->id == "umd" ? counts() : RecordingOptions{};
    EXPECT_EQ(read_samples(recording->id, head, options).refusal, "") << recording->id;
    EXPECT_EQ(read_samples(recording->id, head, options).samples.size(), 3u) << recording->id;
  }
  EXPECT_FALSE(recognise_recording(""));
  EXPECT_FALSE(recognise_recording("{\"format\": \"axiometry-test/1\"}"));
  EXPECT_FALSE(recognise_recording("target_mm,direction,run,deviation_um\n1,up,1,2\n"));
}

TEST(Recordings, SurviveAnyBytes) {
  unsigned state = 7;
  for (const Recording* recording : recording_table()) {
    for (int round = 0; round < 200; ++round) {
      std::string bytes = recording->id == "npy"            ? npy(plain, {0, 1, 2, 3, 4, 5})
                          : recording->id == "renishaw-rtx" ? testing_support::rtx_file(std::array{1.0, 2.0}, 50.0)
                          : recording->id == "hpi-3d"
                              ? testing_support::hpi_distance(1) + testing_support::hpi_weather(0, 20, 40, 1000)
                              : "0 0 1 0 0 1 8 100\ntime_s,x_mm\nA 2026-11-21 12:00:00 1\n1,2\n";
      for (int k = 0; k < 6; ++k) {
        state = state * 1664525u + 1013904223u;
        bytes[(state >> 8) % bytes.size()] = static_cast<char>(state >> 24);
      }
      read_samples(recording->id, bytes, recording->id == "umd" ? counts() : RecordingOptions{});
      recording->recognise(bytes);
    }
  }
}

TEST(MmPerCount, IsTheWavelengthDividedByItsCounts) {
  EXPECT_EQ(*mm_per_count(Length::nm(632.0), 8), 632e-6 / 8);
  EXPECT_FALSE(mm_per_count(Length::nm(0.0), 8));
  EXPECT_FALSE(mm_per_count(Length::nm(632.0), 0));
}

TEST(TimeStamps, AreNanosecondsSince1970) {
  EXPECT_EQ(parse_time_stamp("1970-01-01T00:00:00Z"), 0);
  EXPECT_EQ(parse_time_stamp("2026-11-21T12:34:56.789Z"), 1795264496789000000);
  EXPECT_EQ(parse_time_stamp("2026-11-21 13:34:56,789012345+01:00"), 1795264496789012345);
  for (const char* bad : {"", "2026-02-30T00:00:00", "2026-11-21", "2026-11-21T24:00:00", "2026-11-21T12:00:00.",
                          "2026-11-21T12:00:00x", "12:00:00"})
    EXPECT_FALSE(parse_time_stamp(bad)) << bad;
}

}  // namespace
}  // namespace axiometry::formats
