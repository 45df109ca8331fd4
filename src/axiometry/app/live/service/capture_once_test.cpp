// SPDX-License-Identifier: Apache-2.0
//
// One capture becomes one test, with all of its recording, wherever it was stopped or its program ended.
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <thread>

#include "axiometry/app/files/whole_file.h"
#include "axiometry/app/live/runs/capture_run.h"
#include "axiometry/app/live/service/capture_keeping.h"
#include "axiometry/app/recordings/raw_log.h"
#include "axiometry/formats/plan/plan_json.h"
#include "axiometry/store/database/clock.h"
#include "tests/support/archive.h"
#include "tests/support/simulated_recording.h"

namespace axiometry::app {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing_support::lines_of;
using testing_support::short_plan;

const store::By captured_by{"A. Tester", "a test"};

/// Says nothing, and is over.
class SilentStream final : public LiveStream {
 public:
  Got read(std::span<char>, std::chrono::milliseconds) override { return {State::over}; }
};

class CaptureOnce : public testing::Test {
 protected:
  static void write_raw(const std::string& raw, const std::vector<testing_support::TimedLine>& lines) {
    auto log = RawLog::create(raw);
    ASSERT_TRUE(log);
    for (const auto& line : lines) ASSERT_TRUE(log->append(line.text, log->stamp()));
  }

  static CaptureSession session_of(const std::string& layout = "time-position") {
    CaptureOptions options;
    options.stream = layout;
    options.recording.skip_damaged = true;
    if (layout == "umd") options.recording.units_per_count = 1e-4;
    return *CaptureSession::open(short_plan(), options);
  }

  static LiveCapture gone_on_with(const std::string& raw) {
    return {.name = "x",
            .connect = [] { return std::make_unique<SilentStream>(); },
            .raw = {},
            .resume = raw,
            .give_up = Duration::s(1)};
  }

  /// One that has come to a test and lies in the folder still.
  HeldCapture captured() {
    const std::string plan = formats::write_plan(short_plan());
    const auto content = archive_.store().keep({sha256(plan), "plan.json", "plan", plan}, captured_by);
    const auto record = archive_.store().add(store::PlanRecord{"X", {}, *content}, captured_by);
    auto held = folder_.add({.plan = record->id,
                             .part = 1,
                             .walked = short_plan(),
                             .source = "laser",
                             .layout = "time-position",
                             .options = {},
                             .actor = "A. Tester",
                             .started = store::now_text()});
    write_raw(held->raw(), lines_of("time-position"));
    return *std::move(held);
  }

  static axiometry::Test test_of(const HeldCapture& held) {
    return run_live_capture(session_of(), {.name = "x", .connect = {}, .raw = {}, .resume = held.raw()}, {})->test;
  }

  std::size_t tests() { return archive_.store().tests({})->rows.size(); }

  testing_support::Archive archive_;
  Workbench workbench_{archive_.store()};
  std::string path_ = archive_.folder() + "/captures";
  CaptureFolder folder_{path_};
};

TEST_F(CaptureOnce, ARecordingIsPlayedWholeThoughItIsStoppedMeanwhile) {
  const std::string raw = archive_.folder() + "/run.raw";
  write_raw(raw, lines_of("time-position"));
  CaptureObserver observer;
  observer.stopped = [] { return true; };
  const auto outcome = run_live_capture(session_of(), gone_on_with(raw), observer);
  ASSERT_TRUE(outcome) << outcome.error().to_string();
  EXPECT_EQ(outcome->result.readings.size(), 6u);
}

TEST_F(CaptureOnce, OneThatIsLeftTellsNoReadingThatItsEndWouldCutOff) {
  const std::string raw = archive_.folder() + "/run.raw";
  write_raw(raw, lines_of("time-position"));
  for (const std::size_t pieces : {400u, 700u, 1000u}) {
    std::size_t left = pieces, told = 0;
    CaptureObserver observer;
    observer.reading = [&](const capture::CapturedReading& reading) {
      ++told;
      EXPECT_FALSE(reading.standstill.cut_off);
    };
    observer.abandoned = [&] { return left == 0 || --left == 0; };
    const auto outcome = run_live_capture(session_of(), gone_on_with(raw), observer);
    ASSERT_FALSE(outcome);
    EXPECT_GT(told, 0u) << pieces;
    EXPECT_LT(told, 6u) << pieces;
  }
}

/// Half of a µMD stream that has told no rate yet, then a break, then the rest of it with the rate.
class StreamWithoutARate : public CaptureOnce {
 protected:
  void first_half(std::optional<std::size_t> of_unknown_arrival) {
    auto log = RawLog::create(raw_);
    ASSERT_TRUE(log);
    for (std::size_t k = 0; k < 1000; ++k) ASSERT_TRUE(log->append(lines_[k].text, arrival(k)));
    if (of_unknown_arrival) spoil(*of_unknown_arrival);
  }
  void second_half(bool behind_a_break) {
    auto log = RawLog::resume(raw_);
    ASSERT_TRUE(log);
    if (behind_a_break) ASSERT_TRUE(log->begin_connection());
    ASSERT_TRUE(log->append("\n0 0 0 0 0 1001 8 5000\n", arrival(1000)));
    for (std::size_t k = 1001; k < lines_.size(); ++k) ASSERT_TRUE(log->append(lines_[k].text, arrival(k)));
  }
  std::vector<capture::CapturedReading> readings() {
    const auto played =
        run_live_capture(session_of("umd"), {.name = "x", .connect = {}, .raw = {}, .resume = raw_}, {});
    EXPECT_TRUE(played) << played.error().to_string();
    return played ? played->result.readings : std::vector<capture::CapturedReading>();
  }

  const std::string raw_ = archive_.folder() + "/run.raw";
  const std::vector<testing_support::TimedLine> lines_ = lines_of("umd");

 private:
  ArrivalNs arrival(std::size_t k) const {
    constexpr ArrivalNs noon = 1'795'262'400'000'000'000;
    return noon + static_cast<ArrivalNs>(lines_[k].time_s * 1e9);
  }
  void spoil(std::size_t piece) {
    std::fstream times(times_name(raw_), std::ios::in | std::ios::out | std::ios::binary);
    times.seekp(static_cast<std::streamoff>(16 + 16 * piece));
    times << std::string(16, 'x');
  }
};

TEST_F(StreamWithoutARate, KeepsItsReadingsWhenTheRateIsToldBehindABreak) {
  for (const auto& unknown : {std::optional<std::size_t>(), std::optional<std::size_t>(100)}) {
    first_half(unknown);
    const auto told = readings();
    second_half(true);
    const auto after = readings();
    ASSERT_GE(told.size(), 3u);
    ASSERT_GE(after.size(), told.size());
    for (std::size_t k = 0; k < told.size(); ++k) {
      EXPECT_EQ(told[k].deviation, after[k].deviation) << k;
      EXPECT_EQ(told[k].standstill.begin_s, after[k].standstill.begin_s) << k;
      EXPECT_EQ(told[k].standstill.count, after[k].standstill.count) << k;
    }
    remove_raw(raw_);
  }
}

TEST_F(StreamWithoutARate, TakesTheRateBehindALineThatIsTooLong) {
  first_half({});
  {
    auto log = RawLog::resume(raw_);
    ASSERT_TRUE(log->append(std::string(5000, '-') + "\n", log->stamp()));
  }
  second_half(false);
  for (const auto& reading : readings())  // 50 samples a second, as the rate says, and 100 as they came
    EXPECT_NEAR(reading.standstill.used_to_s - reading.standstill.used_from_s,
                (static_cast<double>(reading.standstill.count) - 1.0) / 50.0, 0.05);
}

/// Whoever runs it, before a byte is added.
TEST_F(CaptureOnce, NothingIsGoneOnWithThatIsNoRecordingOrAnothersAtTheMoment) {
  const auto refusal = [](const std::string& raw) {
    const auto outcome = run_live_capture(session_of(), gone_on_with(raw), {});
    return outcome ? std::string() : outcome.error().to_string();
  };
  const std::string notes = archive_.folder() + "/notes.txt", text = "My notes\nof today\nand more\n";
  std::ofstream(notes) << text;
  EXPECT_THAT(refusal(notes), HasSubstr("notes.txt"));
  EXPECT_EQ(whole_file(notes), text);
  EXPECT_FALSE(has_times(notes));
  EXPECT_THAT(refusal("/dev/zero"), HasSubstr("expected a file"));
  const std::string raw = archive_.folder() + "/run.raw";
  write_raw(raw, lines_of("time-position"));
  const auto others = RawHold::take(raw);
  ASSERT_TRUE(others);
  EXPECT_THAT(refusal(raw), HasSubstr("found another program at this recording"));
}

TEST_F(CaptureOnce, ThePlanIsNoRecordingToGoOnWith) {
  const std::string plan = archive_.folder() + "/plan.json", bytes = formats::write_plan(short_plan());
  std::ofstream(plan) << bytes;
  CaptureOptions options;
  options.plan = plan;
  const auto outcome = run_capture({.from = "tcp://127.0.0.1:1", .raw = {}, .resume = plan, .out = {}}, options, {});
  ASSERT_FALSE(outcome);
  EXPECT_THAT(outcome.error().message, HasSubstr("also an input"));
  EXPECT_EQ(whole_file(plan), bytes);
}

TEST_F(CaptureOnce, OneIsKeptThoughNoMoreMayListen) {
  const store::Id id = captured().id();
  const auto service =
      *CaptureService::open({.folder = path_, .sources = {}, .most_at_once = 0}, keeping_in(workbench_));
  const auto kept = service->stop(id);
  ASSERT_TRUE(kept) << kept.error().to_string();
  EXPECT_EQ(kept->test, 1);
}

TEST_F(CaptureOnce, ARecordingWhoseOrderIsSpoiledIsNamed) {
  const store::Id id = captured().id();
  EXPECT_TRUE(folder_.without_order().empty());
  const std::string base = path_ + "/capture-" + std::to_string(id);
  for (const std::string_view spoiled : {"", "{", "not an order at all\n}\n"}) {
    std::ofstream(base + ".json", std::ios::binary) << spoiled;
    EXPECT_TRUE(folder_.left_behind().empty());
    EXPECT_THAT(folder_.without_order(), testing::ElementsAre(base + ".raw"));
  }
}

TEST_F(CaptureOnce, NumbersAreGivenOnceThoughTwoProgramsCount) {
  std::vector<store::Id> given[2];
  const auto count = [&](std::vector<store::Id>& mine) {
    CaptureFolder folder(path_);
    for (int k = 0; k < 100; ++k)
      if (auto held = folder.add({.walked = short_plan()})) {
        mine.push_back(held->id());
        held->remove();
      }
  };
  {
    const std::jthread one([&] { count(given[0]); }), other([&] { count(given[1]); });
  }
  std::set<store::Id> all(given[0].begin(), given[0].end());
  all.insert(given[1].begin(), given[1].end());
  EXPECT_EQ(all.size(), 200u);
  EXPECT_EQ(whole_file(path_ + "/last-number"), std::to_string(*all.rbegin()));
}

TEST_F(CaptureOnce, WhatWasKeptBeforeTheProgramEndedIsFoundAgainAndNotGoneOnWith) {
  const CaptureKeeping keeping = keeping_in(workbench_);
  store::Id id = 0;
  {
    HeldCapture held = captured();
    id = held.id();
    EXPECT_EQ(*keeping.kept(held), std::nullopt);
    ASSERT_TRUE(keeping.keep({held, test_of(held)}));
  }  // and here the program ends
  EXPECT_EQ(folder_.left_behind().size(), 1u);
  const auto service = *CaptureService::open({.folder = path_, .sources = {}}, keeping);
  const auto resumed = service->resume(id);
  ASSERT_FALSE(resumed);
  EXPECT_EQ(resumed.error().kind, ErrorKind::conflict);
  EXPECT_THAT(resumed.error().message, HasSubstr("in the archive already, as test 1"));
  EXPECT_EQ(tests(), 1u);
  EXPECT_TRUE(folder_.left_behind().empty());
  EXPECT_FALSE(folder_.take(id));
}

TEST_F(CaptureOnce, AnotherTestOfTheSameCaptureIsNotKept) {
  const CaptureKeeping keeping = keeping_in(workbench_);
  HeldCapture held = captured();
  axiometry::Test test = test_of(held);
  const auto first = keeping.keep({held, test});
  test.provenance.file = "seen in another life of the program";
  EXPECT_EQ(*keeping.keep({held, test}), *first);
  EXPECT_EQ(tests(), 1u);
  EXPECT_EQ(archive_.store().documents(**first)->size(), 2u);
}

/// A power failure cuts the note off that was being written; one before it stands.
TEST_F(CaptureOnce, ANoteThatIsCutOffIsNone) {
  const std::string sha(64, 'a');
  store::Id id = 0;
  {
    HeldCapture held = captured();
    id = held.id();
    ASSERT_TRUE(held.note_test(sha));
  }
  const std::string order = path_ + "/capture-" + std::to_string(id) + ".json";
  using namespace std::string_view_literals;
  for (const std::string_view torn : {"\0\0\0\0"sv, "\nbecomes test bbbb"sv, "\nkep"sv, "\n"sv, "\n\0\0\0\0"sv}) {
    std::ofstream(order, std::ios::app | std::ios::binary) << torn;
    const auto held = folder_.take(id);
    ASSERT_TRUE(held) << held.error().to_string();
    EXPECT_THAT(held->noted_tests(), ElementsAre(sha));
  }
  ASSERT_TRUE(folder_.take(id)->note_test(std::string(64, 'c')));
  EXPECT_THAT(folder_.take(id)->noted_tests(), ElementsAre(sha, std::string(64, 'c')));
  EXPECT_EQ(folder_.take(id)->order().source, "laser");
}

}  // namespace
}  // namespace axiometry::app
