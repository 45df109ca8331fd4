// SPDX-License-Identifier: Apache-2.0
// Recordings that a power cut, a bad disk, a bad cable or a bad source has harmed.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <sys/resource.h>

#include <cmath>
#include <csignal>
#include <filesystem>

#include "axiometry/app/files/output.h"
#include "axiometry/app/files/source.h"
#include "axiometry/app/live/runs/capture_run.h"
#include "axiometry/app/recordings/raw_log.h"
#include "axiometry/app/recordings/read_recording.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/digest/sha256.h"
#include "axiometry/formats/plan/plan_json.h"
#include "tests/support/simulated_recording.h"
#include "tests/support/temporary_folder.h"

namespace axiometry::app {
namespace {

using testing::Contains;
using testing::Each;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing_support::lines_of;
using testing_support::recording;
using testing_support::short_plan;
using testing_support::TimedLine;

constexpr ArrivalNs noon = 1'795'262'400'000'000'000;  // 2026-11-21 12:00 UTC

class CaptureTornTest : public testing::Test {
 protected:
  /// As a live capture would have written it: a piece for every two lines.
  void write_raw(const std::vector<TimedLine>& lines) {
    std::filesystem::remove(raw_);
    std::filesystem::remove(times_name(raw_));
    auto log = RawLog::create(raw_);
    ASSERT_TRUE(log);
    for (std::size_t k = 0; k + 1 < lines.size(); k += 2)
      ASSERT_TRUE(
          log->append(lines[k].text + lines[k + 1].text, noon + static_cast<ArrivalNs>(lines[k + 1].time_s * 1e9)));
  }

  struct Replay {
    std::vector<capture::CapturedReading> readings{};
    std::vector<std::string> remarks{};
    std::string error{};
  };

  static CaptureOptions options_of(const std::string& layout, bool rate) {
    CaptureOptions options;
    options.stream = layout;
    options.recording.skip_damaged = true;
    if (layout == "umd") options.recording.units_per_count = 1e-4;
    if (layout == "umd" && rate) options.recording.rate_hz = 100.0;
    return options;
  }

  static Replay outcome_of(const Result<CaptureOutcome>& outcome) {
    if (!outcome) return {.error = outcome.error().to_string()};
    Replay replay{.readings = outcome->result.readings};
    for (const SourceRemark& remark : outcome->test.provenance.remarks) replay.remarks.push_back(remark.message);
    return replay;
  }

  Replay played(const CaptureOptions& options, std::size_t runs = 2) const {
    auto session = CaptureSession::open(short_plan(runs), options);
    EXPECT_TRUE(session);
    return outcome_of(
        run_live_capture(*std::move(session), {.name = "x", .connect = {}, .raw = {}, .resume = raw_}, {}));
  }

  /// Each is one of the sound ones, in their order, to the last digit; but for one that the end has cut off.
  static void expect_among(const Replay& replay, const Replay& sound, const std::string& what) {
    std::size_t at = 0;
    for (const capture::CapturedReading& reading : replay.readings) {
      if (reading.standstill.cut_off) continue;
      while (at < sound.readings.size() && !(sound.readings[at].approach == reading.approach)) ++at;
      ASSERT_LT(at, sound.readings.size()) << what;
      EXPECT_EQ(reading.deviation, sound.readings[at].deviation) << what;
      EXPECT_EQ(reading.standstill.count, sound.readings[at].standstill.count) << what;
    }
  }

  testing_support::TemporaryFolder folder_;
  const std::string raw_ = folder_.file("run.raw");
};

TEST_F(CaptureTornTest, ARecordingCutAnywherePlaysItsSoundBeginningAndTellsWhatIsMissing) {
  for (const std::string& layout :
       {std::string("time-position"), std::string("camonitor-stream"), std::string("umd")}) {
    write_raw(lines_of(layout, 2));
    const CaptureOptions options = options_of(layout, true);
    const Replay sound = played(options);
    ASSERT_EQ(sound.readings.size(), 12u) << layout << sound.error;
    EXPECT_THAT(sound.remarks, Not(Contains(HasSubstr("left"))));
    const std::string bytes = folder_.content("run.raw"), times = folder_.content("run.raw.times");
    for (const double part : {0.35, 0.6, 0.7501, 0.9}) {
      const auto size = static_cast<std::size_t>(part * static_cast<double>(bytes.size()));
      folder_.written("run.raw", bytes.substr(0, size));
      const Replay cut = played(options);
      EXPECT_EQ(cut.error, "");
      EXPECT_GE(cut.readings.size(), static_cast<std::size_t>(12 * part) - 2) << layout << part;
      expect_among(cut, sound, layout);
      EXPECT_THAT(cut.remarks, Contains(HasSubstr("beyond the")));
      folder_.written("run.raw", bytes);
      folder_.written("run.raw.times",
                      times.substr(0, static_cast<std::size_t>(part * static_cast<double>(times.size()))));
      const Replay without = played(options);  // these layouts have times of their own
      EXPECT_EQ(without.readings.size(), 12u);
      expect_among(without, sound, layout);
      EXPECT_THAT(without.remarks, Contains(HasSubstr("arrived is not known")));
      folder_.written("run.raw.times", times);
    }
    for (const std::string& lost : {std::string(), times.substr(16), std::string("no times")}) {
      folder_.written("run.raw.times", lost);
      const Replay without = played(options);
      EXPECT_EQ(without.readings.size(), 12u);
      expect_among(without, sound, layout);
      EXPECT_THAT(without.remarks, Not(IsEmpty()));
    }
    std::filesystem::remove(times_name(raw_));
    expect_among(played(options), sound, layout);
    EXPECT_EQ(played(options).readings.size(), 12u);
  }
}

TEST_F(CaptureTornTest, EveryByteOfAnEndMayBeMissing) {
  const auto lines = lines_of("time-position");
  write_raw(lines);
  const CaptureOptions options = options_of("time-position", true);
  const Replay sound = played(options);
  const std::string bytes = folder_.content("run.raw");
  for (std::size_t missing = 1; missing <= 60; ++missing) {
    const std::size_t size = bytes.size() / 2 - missing;
    folder_.written("run.raw", bytes.substr(0, size));
    const Replay cut = played(options);
    ASSERT_EQ(cut.error, "");
    expect_among(cut, sound, std::to_string(missing));
    const bool whole = bytes[size - 1] == '\n';
    EXPECT_EQ(std::ranges::any_of(cut.remarks, [](const auto& r) { return r.contains(" no whole sample"); }), !whole);
  }
  folder_.written("run.raw", bytes.substr(0, bytes.find('\n', bytes.size() / 2) + 2));
  EXPECT_THAT(played(options).remarks, Contains("left out the last byte of the recording, which is no whole sample"));
}

TEST_F(CaptureTornTest, SamplesThatOnlyTheirArrivalPlacesAreUsedWhereItIsKnown) {
  write_raw(lines_of("umd", 5));
  const CaptureOptions options = options_of("umd", false);
  const Replay sound = played(options, 5);
  ASSERT_EQ(sound.readings.size(), 30u) << sound.error;
  const std::string times = folder_.content("run.raw.times");
  folder_.written("run.raw.times", times.substr(0, times.size() * 2 / 3));
  const Replay cut = played(options, 5);
  EXPECT_GE(cut.readings.size(), 15u);
  EXPECT_LT(cut.readings.size(), 30u);
  expect_among(cut, sound, "cut");
  folder_.written("run.raw.times", "");
  EXPECT_THAT(played(options, 5).error, HasSubstr("found no sample rate (code 8)"));
}

TEST_F(CaptureTornTest, ARecordingThatWasGoneOnWithBehindAPowerCutPlaysBothParts) {
  const auto lines = lines_of("time-position", 2);
  const std::vector<TimedLine> first(lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(lines.size() / 2));
  write_raw(first);
  const std::string bytes = folder_.content("run.raw");
  folder_.written("run.raw", bytes.substr(0, bytes.size() * 19 / 20));  // times were on the disk before the bytes
  {
    auto log = RawLog::resume(raw_);
    ASSERT_TRUE(log);
    ASSERT_TRUE(log->begin_connection());
    for (std::size_t k = first.size(); k < lines.size(); ++k)
      ASSERT_TRUE(log->append(lines[k].text, noon + static_cast<ArrivalNs>(lines[k].time_s * 1e9)));
  }
  const Replay both = played(options_of("time-position", true));
  EXPECT_EQ(both.error, "");
  EXPECT_GE(both.readings.size(), 11u);
}

TEST_F(CaptureTornTest, AWrongDigitInATimeCostsItsLine) {
  auto lines = lines_of("time-position");
  write_raw(lines);
  const CaptureOptions options = options_of("time-position", true);
  const Replay sound = played(options);
  ASSERT_EQ(sound.readings.size(), 6u) << sound.error;
  const std::string good = lines[796].text;
  for (const std::string& digit : {std::string("9"), std::string()}) {  // ahead, and back
    lines[796].text = digit.empty() ? "0" + good.substr(1) : digit + good;
    write_raw(lines);
    const Replay harmed = played(options);
    EXPECT_EQ(harmed.error, "");
    EXPECT_EQ(harmed.readings.size(), 6u);
    EXPECT_THAT(harmed.remarks,
                Contains(HasSubstr("left out 1 line whose time is out of order, the first is line 797")));
  }
}

TEST_F(CaptureTornTest, AClockThatIsSetCostsNothing) {
  for (const double shift_s : {-100.0, 3600.0}) {
    auto lines = lines_of("time-position");
    for (std::size_t k = 700; k < lines.size(); ++k)
      lines[k].text = fmt::format("{:.7f}{}", lines[k].time_s + shift_s, lines[k].text.substr(lines[k].text.find(',')));
    write_raw(lines);
    const Replay set = played(options_of("time-position", true));
    EXPECT_EQ(set.error, "");
    EXPECT_GE(set.readings.size(), 5u) << shift_s;
    EXPECT_THAT(set.remarks,
                Contains(HasSubstr(shift_s < 0.0 ? "set back 1 time, first in line 701" : "set ahead 1 time")));
  }
}

TEST_F(CaptureTornTest, BehindARefusedStretchTheRestIsLeftOutAndTold) {
  auto lines = lines_of("time-position");
  for (std::size_t k = 900; k < lines.size(); ++k) lines[k].text = "?\n";
  write_raw(lines);
  const Replay replay = played(options_of("time-position", true));
  EXPECT_EQ(replay.error, "");
  EXPECT_GE(replay.readings.size(), 3u);
  EXPECT_THAT(replay.remarks,
              Contains(HasSubstr("left out the rest of the recording: line 1000:1: found \"?\", expected")));
}

TEST_F(CaptureTornTest, WhereTheBeginningIsNoTestItIsSaidWhyTheRestWasLeftOut) {
  auto lines = lines_of("time-position");
  for (std::size_t k = 10; k < lines.size(); ++k) lines[k].text = "?\n";
  write_raw(lines);
  CaptureOptions options = options_of("time-position", true);
  options.plan = folder_.written("plan.json", formats::write_plan(short_plan(2)));
  auto source = Source::open(raw_);
  ASSERT_TRUE(source);
  const auto test = read_recording(*source, options);
  ASSERT_FALSE(test);
  EXPECT_THAT(test.error().message,
              HasSubstr("; left out the rest of the recording: line 110:1: found \"?\", expected"));
}

TEST_F(CaptureTornTest, BehindARefusedStretchTheNextConnectionIsPlayedAndAllOfItHashed) {
  const auto lines = lines_of("time-position", 2);
  const std::size_t half = lines.size() / 4 * 2;
  std::uint64_t behind = 0;
  write_raw({lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(half)});
  {
    auto log = RawLog::resume(raw_);
    ASSERT_TRUE(log);
    for (std::size_t k = 0; k < 300; ++k) ASSERT_TRUE(log->append("?\n", log->stamp()));
    behind = log->size();
    ASSERT_TRUE(log->begin_connection());
    ASSERT_TRUE(log->append("part of a line\nand the instrument's greeting\n", log->stamp()));
    for (std::size_t k = half; k < lines.size(); ++k) ASSERT_TRUE(log->append(lines[k].text, log->stamp()));
  }
  const Replay replay = played(options_of("time-position", true));
  EXPECT_EQ(replay.error, "");
  EXPECT_GE(replay.readings.size(), 11u);
  EXPECT_THAT(
      replay.remarks,
      Contains(HasSubstr(fmt::format(
          "left out the recording up to the connection that begins behind byte {}: line {}:1: ", behind, half + 100))));
  EXPECT_THAT(replay.remarks, Not(Contains(HasSubstr("left out the rest"))));
  CaptureOptions options = options_of("time-position", true);
  options.plan = folder_.written("plan.json", formats::write_plan(short_plan(2)));
  auto source = Source::open(raw_);
  ASSERT_TRUE(source);
  const auto test = read_recording(*source, options);
  ASSERT_TRUE(test) << test.error().to_string();
  EXPECT_EQ(test->provenance.sha256, sha256(folder_.content("run.raw")));
}

TEST_F(CaptureTornTest, ReadingsInFrontOfARefusedLineAreTold) {
  auto lines = lines_of("time-position");
  for (std::size_t k = 900; k < lines.size(); ++k) lines[k].text = "?\n";
  write_raw(lines);
  std::filesystem::remove(times_name(raw_));  // so that all of it is one piece
  std::size_t told = 0;
  CaptureObserver observer;
  observer.reading = [&](const capture::CapturedReading&) { ++told; };
  auto session = CaptureSession::open(short_plan(2), options_of("time-position", true));
  const auto outcome =
      run_live_capture(*std::move(session), {.name = "x", .connect = {}, .raw = {}, .resume = raw_}, observer);
  ASSERT_TRUE(outcome);
  EXPECT_GE(told, 3u);
  EXPECT_EQ(told, outcome->result.readings.size());
}

TEST_F(CaptureTornTest, AConnectionThatBringsNothingIsNoEnd) {
  std::string boot;
  for (int k = 0; k < 150; ++k) boot += "booting, please wait\n";
  for (const std::string& layout : {std::string("time-position"), std::string()}) {
    std::filesystem::remove(raw_);
    std::filesystem::remove(times_name(raw_));
    {
      auto log = RawLog::create(raw_);
      ASSERT_TRUE(log);
      ASSERT_TRUE(log->append(boot, log->stamp()));
    }
    EXPECT_NE(played(options_of(layout, true)).error, "");
    {
      auto log = RawLog::resume(raw_);
      ASSERT_TRUE(log);
      ASSERT_TRUE(log->begin_connection());
      ASSERT_TRUE(log->append("\n" + recording("good", 3, 2), log->stamp()));
    }
    const Replay replay = played(options_of(layout, true));
    EXPECT_EQ(replay.error, "") << layout;
    EXPECT_EQ(replay.readings.size(), 12u);
    EXPECT_THAT(replay.remarks, Contains(HasSubstr("up to the connection that begins behind byte 3150")));
  }
}

TEST_F(CaptureTornTest, AShortStreamWithoutARateIsPlacedByItsArrival) {
  const auto lines = lines_of("umd");
  ASSERT_LT(lines.size(), 4096u);
  write_raw(lines);
  const Replay replay = played(options_of("umd", false), 1);
  EXPECT_EQ(replay.error, "");
  EXPECT_EQ(replay.readings.size(), 6u);
}

/// Sends its pieces, one to each who connects, and closes; later ones hear nothing.
class FlappingStream final : public LiveStream {
 public:
  explicit FlappingStream(std::string bytes) : bytes_(std::move(bytes)) {}
  Got read(std::span<char> buffer, std::chrono::milliseconds) override {
    if (bytes_.empty()) return {State::closed, 0, "closed by the other side"};
    const std::size_t count = std::min({buffer.size(), bytes_.size(), std::size_t{10'000}});
    std::copy_n(bytes_.begin(), count, buffer.begin());
    bytes_.erase(0, count);
    return {State::data, count};
  }

 private:
  std::string bytes_;
};

class CaptureSourceTest : public CaptureTornTest {
 protected:
  Result<CaptureOutcome> listen(LiveCapture live) {
    live.name = "x";
    live.raw = raw_;
    CaptureObserver observer;
    observer.notice = [&](const std::string& text) { notices_.push_back(text); };
    auto session = CaptureSession::open(short_plan(2), options_of("time-position", true));
    return run_live_capture(*std::move(session), live, observer);
  }
  std::vector<std::string> notices_;
};

TEST_F(CaptureSourceTest, ThatClosesAtOnceIsTriedSeldomAndGivenUp) {
  std::size_t connections = 0;
  const auto outcome = listen({.name = {},
                               .connect = [&]() -> Result<std::unique_ptr<LiveStream>> {
                                 ++connections;
                                 return std::make_unique<FlappingStream>("");
                               },
                               .raw = {},
                               .give_up = Duration::s(0.8)});
  EXPECT_FALSE(outcome);  // nothing came
  EXPECT_LE(connections, 3u);
  EXPECT_LE(notices_.size(), 2u);
  EXPECT_THAT(notices_, Contains(HasSubstr("did not come back")));
}

TEST_F(CaptureSourceTest, ThatNeverEndsALineIsNotRecordedForEver) {
  const auto outcome = listen({.name = {},
                               .connect = []() -> Result<std::unique_ptr<LiveStream>> {
                                 return std::make_unique<FlappingStream>(std::string(4 << 20, '7'));
                               },
                               .raw = {},
                               .give_up = Duration::s(0)});
  ASSERT_FALSE(outcome);
  EXPECT_THAT(outcome.error().message, HasSubstr("without a line break"));
  EXPECT_LE(std::filesystem::file_size(raw_), (1u << 20) + (128u << 10));
}

TEST_F(CaptureSourceTest, EndsBeforeTheDiskIsFullAndSaysSoInTime) {
  std::string bytes;
  for (const TimedLine& line : lines_of("time-position", 2)) bytes += line.text;
  std::uint64_t free = DiskRoom::little - 1;
  const auto outcome = listen(
      {.name = {},
       .connect = [&]() -> Result<std::unique_ptr<LiveStream>> { return std::make_unique<FlappingStream>(bytes); },
       .raw = {},
       .give_up = Duration::s(0),
       .free = [&](const std::string&) { return std::optional(free); }});
  ASSERT_TRUE(outcome) << outcome.error().message;
  EXPECT_THAT(notices_, Contains(HasSubstr("found 255 MiB left on the disk")));
  std::filesystem::remove(raw_);
  std::filesystem::remove(times_name(raw_));
  free = DiskRoom::least;
  EXPECT_FALSE(listen(
      {.name = {},
       .connect = [&]() -> Result<std::unique_ptr<LiveStream>> { return std::make_unique<FlappingStream>(bytes); },
       .raw = {},
       .free = [&](const std::string&) { return std::optional(free); }}));
  EXPECT_THAT(notices_, Contains(HasSubstr("it ends here")));
  EXPECT_EQ(std::filesystem::file_size(raw_), 0u);
}

TEST_F(CaptureSourceTest, GivesATestOfAllThatCameWhenTheDiskFillsInTheMiddle) {
  std::string bytes;
  for (const TimedLine& line : lines_of("time-position")) bytes += line.text;  // half of the plan
  while (bytes.size() < std::size_t{3} << 20) bytes += "# a comment that only takes room on the disk\n";
  std::size_t asked = 0;
  const auto outcome = listen(
      {.name = {},
       .connect = [&]() -> Result<std::unique_ptr<LiveStream>> { return std::make_unique<FlappingStream>(bytes); },
       .raw = {},
       .give_up = Duration::s(0),
       .free = [&](const std::string&) { return std::optional(++asked < 3 ? DiskRoom::little : DiskRoom::least); }});
  ASSERT_TRUE(outcome) << outcome.error().message;
  EXPECT_TRUE(outcome->stopped);
  EXPECT_EQ(outcome->result.readings.size(), 6u);
  const auto size = std::filesystem::file_size(raw_);
  EXPECT_GT(size, std::size_t{1} << 20);
  EXPECT_LT(size, bytes.size());
}

/// Files of this process end at so many bytes, as they do on a disk that is full.
class FullDisk {
 public:
  explicit FullDisk(rlim_t size) {
    handler_ = std::signal(SIGXFSZ, SIG_IGN);
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{size, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FullDisk() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int) = nullptr;
};

TEST_F(CaptureSourceTest, WhatWasKeptWhenTheDiskIsFullIsSaidAndPlays) {
  std::string bytes;
  for (const TimedLine& line : lines_of("time-position", 2)) bytes += line.text;
  {
    const FullDisk full(35'000);  // in the middle of a piece
    const auto outcome = listen({.name = {},
                                 .connect = [&]() -> Result<std::unique_ptr<LiveStream>> {
                                   return std::make_unique<FlappingStream>(bytes + bytes + bytes);
                                 },
                                 .raw = {},
                                 .give_up = Duration::s(0)});
    ASSERT_FALSE(outcome);
    EXPECT_THAT(outcome.error().message, HasSubstr("30000 bytes and"));
  }
  EXPECT_EQ(std::filesystem::file_size(raw_), 35'000u);
  const Replay kept = played(options_of("time-position", true));
  EXPECT_EQ(kept.error, "");
  EXPECT_GE(kept.readings.size(), 5u);
}

}  // namespace
}  // namespace axiometry::app
