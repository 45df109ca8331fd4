// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "axiometry/base/text/number_text.h"
#include "axiometry/formats/recording.h"
#include "axiometry/formats/recordings/rtx_header.h"
#include "tests/support/recording_feed.h"
#include "tests/support/rtx_file.h"

namespace axiometry::formats {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing_support::read_samples;
using testing_support::rtx_file;
using testing_support::same_however_cut;

constexpr double three[] = {0.5, -1.25, 3.0};

std::string rtx_text(std::string_view bytes, RecordingOptions options = {}) {
  EXPECT_TRUE(same_however_cut("renishaw-rtx", bytes, options));
  const auto read = read_samples("renishaw-rtx", bytes, options);
  std::string text = read.refusal;
  for (const Sample& s : read.samples)
    text += (text.empty() ? "" : " ") + format_exact(s.time_s) + ":" + format_exact(s.position);
  return text;
}

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, text.npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(RenishawRtx, ReadsPositionsAtTheActualRate) {
  const std::string file = rtx_file(three, 4.0);
  EXPECT_EQ((*recognise_recording(file))->id, "renishaw-rtx");
  EXPECT_EQ(rtx_text(file), "0:0.5 0.25:-1.25 0.5:3");
  EXPECT_EQ(rtx_text(replaced(file, "\r\nEOF::\r\n", "")), "0:0.5 0.25:-1.25 0.5:3");
  EXPECT_EQ(rtx_text(replaced(file, "\r\nEOF::\r\n", "EOF::")), "0:0.5 0.25:-1.25 0.5:3");
  EXPECT_EQ(rtx_text(rtx_file(three, 1, "Sample no: 3\nSample rate: 2\nActual sample rate:\n")), "0:0.5 0.5:-1.25 1:3");
}

TEST(RenishawRtx, TakesAnglesInMilliradiansForARotaryAxis) {
  RecordingOptions rotary;
  rotary.kind = AxisKind::rotary;
  const double one[] = {M_PI * 1000.0};
  EXPECT_NEAR(read_samples("renishaw-rtx", rtx_file(one, 1), rotary).samples.at(0).position, 180.0, 1e-10);
}

TEST(RenishawRtx, RefusesAFileOfTheOtherKindOfAxis) {
  const auto of_type = [](const std::string& type) {
    return rtx_file(three, 1, "File Type: " + type + "\nSample no: 3\nActual sample rate: 4\n");
  };
  RecordingOptions rotary;
  rotary.kind = AxisKind::rotary;
  for (const char* type : {"Angular", "angular dynamic", "ROTARY", "rta"}) {
    EXPECT_EQ(rtx_text(of_type(type)), "found an .rtx recording of the file type \"" + std::string(type) +
                                           "\", whose numbers are angles in mrad, expected one of a linear axis")
        << type;
    EXPECT_EQ(read_samples("renishaw-rtx", of_type(type), rotary).samples.size(), 3u) << type;
  }
  for (const char* type : {"Linear", "linear dynamic", "rtl"}) {
    EXPECT_EQ(rtx_text(of_type(type), rotary), "found an .rtx recording of the file type \"" + std::string(type) +
                                                   "\", whose numbers are in mm, expected one of a rotary axis")
        << type;
    EXPECT_EQ(read_samples("renishaw-rtx", of_type(type)).samples.size(), 3u) << type;
  }
  for (const char* type : {"rtx", "", "Dynamic", "Triangular mesh"})
    EXPECT_EQ(read_samples("renishaw-rtx", of_type(type)).samples.size(), 3u) << type;
}

TEST(RenishawRtx, TellsWhatTheHeaderSaysAndWhatIsDoubtful) {
  const auto header = rtx_header(rtx_file(three, 4.0));
  ASSERT_TRUE(header && *header);
  EXPECT_EQ((*header)->machine, "Mill 5");
  EXPECT_EQ((*header)->samples, 3u);
  EXPECT_THAT(rtx_remarks(**header), Contains(HasSubstr("whether the day or the month stands first")));
  EXPECT_THAT(rtx_remarks(**header), Not(Contains(HasSubstr("trigger interval"))));
  const auto by_place = rtx_header(rtx_file(three, 1, "Sample no: 3\nTrigger interval: 0.01\nActual sample rate: 4\n"));
  EXPECT_THAT(rtx_remarks(**by_place), Contains(HasSubstr("were the samples triggered by position")));
  const auto asked = rtx_header(rtx_file(three, 1, "Sample no: 3\nSample rate: 2\n"));
  EXPECT_THAT(rtx_remarks(**asked), Contains(HasSubstr("no actual sample rate")));
}

TEST(RenishawRtx, DoubtsADateOnlyWhereItMayBeReadInTwoWays) {
  const auto told = [](std::string date) {
    RtxHeader header;
    header.rate_is_actual = true;
    header.date = std::move(date);
    return rtx_remarks(header);
  };
  for (const char* date : {"10/02/2025 12:58:22", "1-2-2025", " 3/ 4/2025", "3 / 4 / 2025"})
    EXPECT_THAT(told(date), ElementsAre(HasSubstr("whether the day or the month stands first"))) << date;
  for (const char* date : {"31/12/2025 12:58:22", "12/31/2025", "05/05/2025", "2025-02-10", "10.02.2025", "today"})
    EXPECT_THAT(told(date), ElementsAre("the file is of \"" + std::string(date) + '"')) << date;
}

TEST(RenishawRtx, RefusesInWordsWhatIsNotWhole) {
  const std::string file = rtx_file(three, 4.0);
  const std::size_t data = file.find("Data:\r\n") + 7;
  EXPECT_EQ(rtx_text(file.substr(0, data + 20)),
            "found 2 samples, expected 3 as the header says: the file is cut off 0:0.5 0.25:-1.25");
  EXPECT_EQ(rtx_text(file.substr(0, data - 9)), "found an .rtx recording that ends in its header, expected samples");
  EXPECT_THAT(rtx_text(replaced(file, "Sample no: 3", "Sample no: 2")),
              HasSubstr("found more behind the 2 samples that the header says, expected EOF::"));
  EXPECT_THAT(rtx_text(replaced(file, "Sample no: 3", "Sample no: 2") + std::string(100, 'x')),
              HasSubstr("found more behind the 2 samples"));
  EXPECT_THAT(rtx_text(replaced(file, "Sample no: 3", "Sample no: 0")), HasSubstr("found \"0\" as Sample no"));
  EXPECT_THAT(rtx_text(replaced(file, "Sample no: 3", "Sample no: 99999999999999999999")), HasSubstr("as Sample no"));
  EXPECT_THAT(rtx_text(replaced(file, "Sample no: 3", "Sample no: 9000000000000000000")),
              HasSubstr("the file is cut off"));
  for (const char* rate : {"0", "-4", "1e-310", "nan", "inf", "1e99", "4 Hz"})
    EXPECT_THAT(rtx_text(rtx_file(three, 1, std::string("Sample no: 3\nActual sample rate: ") + rate + "\n")),
                HasSubstr("as sample rate of an .rtx recording, expected 1e-6 to 1e9 Hz"))
        << rate;
  const double bad[] = {1.0, std::numeric_limits<double>::quiet_NaN()};
  EXPECT_EQ(rtx_text(rtx_file(bad, 1)),
            "found a number beyond 1e15, or none, in sample 2, expected time and position 0:1");
  EXPECT_THAT(read_samples("renishaw-rtx", "HEADER::\n" + std::string(70'000, 'x')).refusal,
              HasSubstr("found no Data: in the first 65536 bytes"));
  RecordingOptions options;
  options.rate_hz = 5;
  EXPECT_FALSE(find_recording("renishaw-rtx")->open(options));
  options = {};
  options.units_per_count = 5;
  EXPECT_FALSE(find_recording("renishaw-rtx")->open(options));
  options = {};
  options.axis = 1;
  EXPECT_FALSE(find_recording("renishaw-rtx")->open(options));
}

TEST(RenishawRtx, TakesNoEndMarkForTheNumberThatIsMissing) {
  for (const char* end : {"\r\nEOF::\r\n", "\r\nEOF::\r\n\r\n", "EOF::   \r\n", "\r\n\r\nEOF::"}) {
    const std::string file = replaced(rtx_file(three, 4.0), "\r\nEOF::\r\n", end);
    EXPECT_EQ(rtx_text(file), "0:0.5 0.25:-1.25 0.5:3") << end;
    for (const char* announced : {"4", "5", "6"})
      EXPECT_THAT(
          rtx_text(replaced(file, "Sample no: 3", std::string("Sample no: ") + announced)),
          HasSubstr(std::string("found 3 samples, expected ") + announced + " as the header says: the file is cut off"))
          << end;
  }
  for (const char* end : {"\r\nEOF::\r\n", "EOF::\r\n", "EOF::", ""}) {
    const std::string file = replaced(rtx_file({}, 4.0), "\r\nEOF::\r\n", end);
    EXPECT_THAT(rtx_text(replaced(file, "Sample no: 0", "Sample no: 5")),
                HasSubstr("found 0 samples, expected 5 as the header says: the file is cut off"))
        << end;
  }
}

TEST(RenishawRtx, IsNotTakenForTheOtherFilesOfThatMaker) {
  EXPECT_EQ(find_recording("renishaw-rtx")->recognise("HEADER::\r\nFile type  : rtl\r\nTARGET DATA::\r\n"), 0);
}

}  // namespace
}  // namespace axiometry::formats
