// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/live/runs/capture_telling.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "axiometry/app/live/runs/capture_date.h"
#include "axiometry/formats/plan/plan_json.h"
#include "tests/support/made_up_recording.h"
#include "tests/support/temporary_folder.h"

namespace axiometry::app {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing_support::MadeUpRun;

struct FileCapture {
  testing_support::TemporaryFolder folder;
  MadeUpRun run;
  std::string out = folder.file("x.json");
  std::vector<std::string> notices;

  std::string text(double beside_mm) const {
    std::string lines;
    std::size_t passed = 0;
    for (const Sample& s : run.record())
      lines += fmt::format("{:.3f},{:.6f}\n", s.time_s, s.position + (++passed > 12'000 ? beside_mm : 0.0));
    return lines;
  }
  Result<CaptureOutcome> operator()(const std::string& recording) {
    CaptureOptions options;
    options.plan = folder.written("plan.json", formats::write_plan(run.plan));
    const CaptureObserver observer{.reading = {},
                                   .event = {},
                                   .notice = [&](const std::string& said) { notices.push_back(said); },
                                   .now = {},
                                   .stopped = {},
                                   .abandoned = {}};
    return run_capture({.from = folder.written("run.csv", recording), .raw = {}, .resume = {}, .out = out}, options,
                       observer);
  }
};

TEST(CaptureTelling, PutsATestBackThatWasThereBeforeOneThatDoesNotHold) {
  FileCapture capture;
  const std::string before = "a test that was measured before";
  capture.folder.written("x.json", before);
  ASSERT_FALSE(capture(capture.text(9.0)));
  EXPECT_EQ(capture.folder.content("x.json"), before);
  EXPECT_THAT(capture.notices, ElementsAre(HasSubstr("holds again what it held before")));
}

TEST(CaptureTelling, ReplacesATestByOneThatHolds) {
  FileCapture capture;
  capture.folder.written("x.json", "a test that was measured before");
  ASSERT_TRUE(capture(capture.text(0.0)));
  EXPECT_THAT(capture.folder.content("x.json"), HasSubstr("axiometry-test/1"));
}

TEST(CaptureTelling, TellsWhatAFileHoldsBehindTheLastApproach) {
  FileCapture capture;
  std::string recording = capture.text(0.0);
  auto stops = capture.run.stops();
  const std::vector<MadeUpRun::Stop> pass(stops.begin(), stops.begin() + 6);
  stops.insert(stops.end(), pass.begin(), pass.end());
  recording.clear();
  for (const Sample& s : capture.run.record(stops)) recording += fmt::format("{:.3f},{:.6f}\n", s.time_s, s.position);
  const auto outcome = capture(recording + "broken\n");
  ASSERT_TRUE(outcome) << outcome.error().to_string();
  std::vector<std::string> remarks;
  for (const SourceRemark& remark : outcome->test.provenance.remarks) remarks.push_back(remark.message);
  EXPECT_THAT(remarks, testing::Contains(HasSubstr("5 more standstills at targets behind the last approach")));
  EXPECT_THAT(remarks, testing::Contains(HasSubstr("left out the rest of the recording")));
}

TEST(CaptureDate, IsTheDayOfThePlace) {
  const char* const before = std::getenv("TZ");
  const std::optional<std::string> zone = before ? std::optional<std::string>(before) : std::nullopt;
  const ArrivalNs late = 1'795'993'200'000'000'000;  // 2026-11-29 23:00 in UTC
  for (const auto& [there, day] : {std::pair("UTC0", "2026-11-29"), std::pair("CET-1", "2026-11-30")}) {
    ::setenv("TZ", there, 1);
    ::tzset();
    EXPECT_EQ(arrival_date(late), day);
  }
  zone ? ::setenv("TZ", zone->c_str(), 1) : ::unsetenv("TZ");
  ::tzset();
  EXPECT_EQ(arrival_date({}), "");
}

}  // namespace
}  // namespace axiometry::app
