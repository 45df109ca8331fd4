// SPDX-License-Identifier: Apache-2.0
// `axiometry capture --from simulator://…`: a straightness that is captured to a table without instrument and machine.
#include <gmock/gmock.h>

#include <string>
#include <utility>
#include <vector>

#include "axiometry/app/files/output.h"
#include "axiometry/app/files/whole_file.h"
#include "axiometry/app/live/sources/capture_source.h"
#include "axiometry/app/live/runs/motion_run.h"
#include "axiometry/formats/motions/motion_csv.h"
#include "axiometry/formats/plan/plan_json.h"
#include "tests/support/made_up_motion.h"
#include "tests/support/temporary_folder.h"

namespace axiometry::app {
namespace {

using capture::StopSign;
using testing::HasSubstr;

struct SimulatedRun {
  testing_support::TemporaryFolder folder;
  CaptureRun run;
  CaptureOptions options;

  explicit SimulatedRun(const std::string& from, StopSign sign = StopSign::readings) {
    Plan plan = testing_support::straightness_plan();
    plan.runs = 1;
    EXPECT_TRUE(write_file(folder.file("plan.json"), formats::write_plan(plan)));
    options.plan = folder.file("plan.json");
    options.recording.skip_damaged = true;
    options.motion.emplace();
    options.motion->sign = sign;
    run.from = from;
    run.out = folder.file("eyx.csv");
    run.raw = run.out + ".raw";
  }
  std::string table() const { return whole_file(run.out).value_or(""); }
  std::string refusal() const {
    const auto outcome = run_motion_capture(run, options, {});
    return outcome ? "" : outcome.error().message;
  }
};

TEST(SimulatedRun, WritesATableThatSaysThatItWasSimulated) {
  SimulatedRun simulated("simulator://?seed=7&size=8&speed=60");
  const auto outcome = run_motion_capture(simulated.run, simulated.options, {});
  ASSERT_TRUE(outcome) << outcome.error().to_string();
  EXPECT_TRUE(outcome->complete);
  EXPECT_EQ(outcome->found, 6u);
  EXPECT_THAT(simulated.table(),
              HasSubstr("# captured from simulator://?seed=7&size=8&speed=60, layout time-position"));
  EXPECT_THAT(simulated.table(),
              HasSubstr("# test.comment: Simulated, not measured: fault good, size 8 um; seed 7\n"));
  const auto read = formats::read_motion_csv(simulated.table());
  ASSERT_TRUE(read) << read.error().to_string();
  EXPECT_EQ(read->metadata.conditions.purpose, "simulation");
  EXPECT_EQ(read->metadata.machine.name, "Simulator");
}

TEST(SimulatedRun, ItsRawRecordingPlayedAgainSaysItToo) {
  SimulatedRun simulated("simulator://?seed=7&size=8&speed=60");
  ASSERT_TRUE(run_motion_capture(simulated.run, simulated.options, {}));
  SimulatedRun again(simulated.run.raw);
  again.run.raw.clear();
  const auto outcome = run_motion_capture(again.run, again.options, {});
  ASSERT_TRUE(outcome) << outcome.error().to_string();
  const auto read = formats::read_motion_csv(again.table());
  ASSERT_TRUE(read) << read.error().to_string();
  EXPECT_EQ(read->metadata.conditions.purpose, "simulation");
  EXPECT_EQ(read->metadata.machine.name, "Simulator");
}

TEST(SimulatedRun, WithKeysTheAxisStandsAtEachStopUntilItIsDone) {
  SimulatedRun simulated("simulator://?speed=60", StopSign::keys);
  const Plan plan = testing_support::straightness_plan();
  bool stands = false;
  CaptureObserver person;
  person.now = [&](const CaptureSession& session) {
    const auto due = session.motion()->values().due();
    stands = session.now() && session.now()->at_rest && due;
    if (!stands) return;
    EXPECT_NEAR(session.now()->position.in_native(), plan.targets[due->target].in_native(), 1e-3);
  };
  person.keys = [&] {
    using Keys = std::vector<capture::StopKey>;
    return std::exchange(stands, false) ? Keys{capture::StopKey::take} : Keys{};
  };
  const auto outcome = run_motion_capture(simulated.run, simulated.options, person);
  ASSERT_TRUE(outcome) << outcome.error().to_string();
  EXPECT_TRUE(outcome->complete);
  EXPECT_EQ(outcome->found, 6u);
}

TEST(SimulatedRun, WhatTheSimulatorDoesNotKnowIsRefused) {
  EXPECT_THAT(SimulatedRun("simulator://?baud=7").refusal(),
              HasSubstr("found \"baud=7\" in the source, expected preset, size, seed or speed"));
  EXPECT_THAT(SimulatedRun("simulator://?speed=7").refusal(), HasSubstr("speed: found \"7\""));
  EXPECT_THAT(SimulatedRun("simulator://?preset=worn").refusal(), HasSubstr("preset: found \"worn\""));
  EXPECT_THAT(SimulatedRun("simulator://laser").refusal(), HasSubstr("expected simulator://?seed=7"));
  EXPECT_FALSE(parse_capture_source("laser=simulator://")) << "it is there already";

  SimulatedRun of_positions("simulator://");
  Plan plan = testing_support::straightness_plan();
  plan.errors.clear();
  ASSERT_TRUE(write_file(of_positions.options.plan, formats::write_plan(plan)));
  of_positions.options.motion.reset();
  of_positions.run.out = of_positions.folder.file("eyx.json");
  const auto outcome = run_capture(of_positions.run, of_positions.options, {});
  ASSERT_FALSE(outcome);
  EXPECT_THAT(outcome.error().message, HasSubstr("found the simulator as source of positions or lengths"));
}

}  // namespace
}  // namespace axiometry::app
