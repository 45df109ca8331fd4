// SPDX-License-Identifier: Apache-2.0
// A rotary axis whose instrument shows the same again after each turn: the test is that of one which counts on.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "axiometry/app/files/output.h"
#include "axiometry/app/live/runs/capture_run.h"
#include "axiometry/formats/plan/plan_json.h"
#include "tests/support/made_up_recording.h"
#include "tests/support/temporary_folder.h"

namespace axiometry::app {
namespace {

testing_support::MadeUpRun rotary_run() {
  testing_support::MadeUpRun run;
  run.plan.axis.name = "C";
  run.plan.axis.kind = AxisKind::rotary;
  run.plan.targets.clear();
  for (const double target : {0.0, 97.0, 181.0, 268.0, 360.0, 470.0})
    run.plan.targets.push_back(Position::native(target));
  run.plan.feed = 3600.0;
  run.rate_hz = 200.0;
  run.deviation = [](const Approach& a) { return 0.001 * static_cast<double>(a.target) - 0.002; };
  return run;
}

std::string shown_from(double lowest, const std::vector<Sample>& samples) {
  std::string text = "time_s,C_deg\n";
  for (const Sample& s : samples)
    text += fmt::format("{:.4f},{:.5f}\n", s.time_s, s.position - 360.0 * std::floor((s.position - lowest) / 360.0));
  return text;
}

struct RolloverRun {
  testing_support::TemporaryFolder folder;
  CaptureRun run;
  CaptureOptions options;

  explicit RolloverRun(const std::string& recording) {
    options.plan = folder.written("plan.json", formats::write_plan(rotary_run().plan));
    run.from = folder.written("run.csv", recording);
  }
  Result<CaptureOutcome> captured() const { return run_capture(run, options, {}); }
};

TEST(RolloverRun, MakesTheTestOfAnInstrumentThatCountsOn) {
  const std::vector<Sample> samples = rotary_run().record();
  for (const double lowest : {0.0, -180.0}) {
    const auto rolled = RolloverRun(shown_from(lowest, samples)).captured();
    ASSERT_TRUE(rolled) << rolled.error().to_string();
    EXPECT_TRUE(rolled->complete);
    ASSERT_EQ(rolled->result.readings.size(), approaches(rotary_run().plan).size());
    for (const capture::CapturedReading& r : rolled->result.readings)
      EXPECT_NEAR(r.deviation.in_native(), 3600.0 * rotary_run().deviation(r.approach), 0.1);
    EXPECT_THAT(rolled->test.provenance.remarks,
                testing::Contains(testing::Field(&SourceRemark::message, testing::HasSubstr("counted on over 360°"))));
  }
}

TEST(RolloverRun, ReadsItTheSameWithTheZeroAtTheFirstTarget) {
  std::vector<Sample> samples = rotary_run().record();
  for (Sample& s : samples) s.position += 123.0;
  RolloverRun shifted(shown_from(0.0, samples));
  shifted.options.matcher.zero_at_first_target = true;
  const auto captured = shifted.captured();
  ASSERT_TRUE(captured) << captured.error().to_string();
  EXPECT_TRUE(captured->complete);
  EXPECT_EQ(captured->result.readings.size(), approaches(rotary_run().plan).size());
}

TEST(RolloverRun, TheAxisIsSaidToBeWhereTheInstrumentShowsIt) {
  RolloverRun rolled(shown_from(0.0, rotary_run().record()));
  double lowest = 1e9, highest = -1e9;
  auto session = CaptureSession::open(rotary_run().plan, rolled.options);
  ASSERT_TRUE(session);
  const std::string text = shown_from(0.0, rotary_run().record());
  for (std::size_t at = 0; at < text.size(); at += 60) {  // also between a rollover and the end of its cell
    ASSERT_TRUE(session->feed(text.substr(at, 60)));
    if (!session->now()) continue;
    lowest = std::min(lowest, session->now()->position.in_native());
    highest = std::max(highest, session->now()->position.in_native());
  }
  EXPECT_GT(lowest, -1.0);
  EXPECT_LT(highest, 361.0);
  EXPECT_GT(highest, 260.0);
}

}  // namespace
}  // namespace axiometry::app
