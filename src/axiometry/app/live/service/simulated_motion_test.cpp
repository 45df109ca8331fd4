// SPDX-License-Identifier: Apache-2.0
// Captures of a straightness or a rotation with the simulator as their source, over an archive.
#include "axiometry/app/live/sources/simulated_motion.h"

#include <gmock/gmock.h>

#include <chrono>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "axiometry/app/error_motions/motion_evaluation.h"
#include "axiometry/app/live/service/table_captures_test_support.h"
#include "axiometry/formats/motions/motion_csv.h"
#include "axiometry/simulation/motion_walk.h"
#include "tests/support/made_up_motion.h"

namespace axiometry::app {
namespace {

using capture::StopKey;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;
using Stage = CaptureState::Stage;
using SimulatedOptions = std::vector<std::pair<std::string, std::string>>;

/// Three targets, there and back, 8 s from stop to stop.
Plan simulated_plan(const char* error = "EYX") {
  Plan plan = testing_support::straightness_plan();
  plan.errors = {*motion_name(error)};
  plan.machine = "Mill";
  plan.runs = 1;
  plan.feed = 3000.0;
  plan.dwell = Duration::s(2.0);
  return plan;
}

class SimulatedMotions : public testing_support::TableCaptures {
 protected:
  static CaptureWish wish(const Plan& plan, const char* stops, SimulatedOptions more = {}, const char* speed = "60") {
    more.insert(more.begin(), {{"stops", stops}, {"speed", speed}, {"seed", "7"}});
    return {.plan = 7, .whole = plan, .source = "simulator", .layout = {}, .options = std::move(more), .actor = "me"};
  }

  static void expect_truth(const CaptureState& end, const Plan& plan, double size, double per_unit = 1.0) {
    ASSERT_TRUE(end.motion && end.motion->values);
    ASSERT_EQ(end.motion->values->size(), approaches(plan).size());
    for (const capture::PlannedValue& value : *end.motion->values) {
      const double at_mm = plan.targets[value.approach.target].in_native();
      const double truth = simulation::true_motion({.size = size}, plan, at_mm, value.approach.direction);
      EXPECT_NEAR(value.still.value * per_unit, truth, 0.2 * size) << "approach at " << at_mm;
    }
  }

  /// Takes each stop as a person would who waits until the axis stands.
  static CaptureState taken_at_each_stop(CaptureService& service, store::Id id, std::size_t until) {
    for (std::size_t k = service.state(id)->taken; k < until; ++k) {
      wait_for(service, id, [](const CaptureState& s) { return (s.now && s.now->at_rest) || has_ended(s.stage); });
      EXPECT_TRUE(service.press(id, StopKey::take));
      wait_for(service, id, [&](const CaptureState& s) { return s.taken > k || has_ended(s.stage); });
    }
    return *service.state(id);
  }
};

TEST_F(SimulatedMotions, AreReadAtEachStopHoweverTheStopsAreTold) {
  const Plan plan = simulated_plan();
  const auto service = open();
  for (const char* stops : {"trigger", "readings", "position"}) {
    const CaptureState end = end_of(*service, service->start(wish(plan, stops)));
    EXPECT_EQ(end.stage, Stage::complete) << stops << ": " << end.error;
    EXPECT_TRUE(end.events.empty()) << stops << ": " << end.events.front().message;
    EXPECT_EQ(end.motion->unit, MotionUnit::um);
    expect_truth(end, plan, usual_motion_size);
  }
}

TEST_F(SimulatedMotions, WithKeysTheAxisStandsUntilItsReadingIsTakenOrLeftOut) {
  const Plan plan = simulated_plan();
  const auto service = open();
  const auto started = service->start(wish(plan, "keys"));
  ASSERT_TRUE(started) << started.error().to_string();
  const store::Id id = started->id;
  CaptureState state = wait_for(*service, id, [](const CaptureState& s) { return s.now && s.now->at_rest; });
  EXPECT_NEAR(state.now->position.in_native(), 0.0, 1e-3);
  std::this_thread::sleep_for(std::chrono::milliseconds(500));  // half a minute of the machine
  state = *service->state(id);
  EXPECT_TRUE(state.now->at_rest);
  EXPECT_EQ(state.due->target, 0u) << "nobody has said anything";

  state = taken_at_each_stop(*service, id, 1);
  EXPECT_EQ(state.due->target, 1u);
  ASSERT_TRUE(service->press(id, StopKey::undo));
  wait_for(*service, id, [](const CaptureState& s) {
    return s.due && s.due->target == 0 && s.now->at_rest && s.now->position.in_native() < 1.0;
  });
  taken_at_each_stop(*service, id, 1);
  ASSERT_TRUE(service->press(id, StopKey::skip));
  wait_for(*service, id, [](const CaptureState& s) {
    return s.due && s.due->target == 2 && s.now->at_rest && s.now->position.in_native() > 199.0;
  });
  taken_at_each_stop(*service, id, 5);
  const CaptureState end = wait_for(*service, id, [](const CaptureState& s) { return has_ended(s.stage); });
  EXPECT_EQ(end.stage, Stage::complete) << end.error;
  EXPECT_EQ(end.came_to->found, 5u);
  EXPECT_FALSE(end.now) << "the axis is simulated no more";
}

TEST_F(SimulatedMotions, TheTableSaysThatItWasSimulatedAndSoDoesItsEvaluation) {
  const auto service = open();
  const CaptureState end =
      end_of(*service, service->start(wish(simulated_plan(), "trigger", {{"size", "12"}, {"positive", "-Y"}})));
  const std::string table = service->file_of(end.id, "readings").value_or("");
  EXPECT_THAT(table, HasSubstr("# machine.name: Mill (simulated)\n"));
  EXPECT_THAT(table, HasSubstr("# test.purpose: simulation\n"));
  EXPECT_THAT(table, HasSubstr("# test.comment: Simulated, not measured: fault good, size 12 um; seed 7\n"));
  EXPECT_THAT(service->file_of(end.id, "raw").value_or(""),
              testing::StartsWith("# Simulated, not measured: fault good, size 12 um; seed 7\n"
                                  "time_s,EYX [um],trigger\n"));
  expect_truth(end, simulated_plan(), 12.0);
  MotionRequest request;
  request.file = "eyx.csv";
  request.bytes = table;
  const auto measured = measure_straightness(request);
  ASSERT_TRUE(measured) << measured.error().to_string();
  EXPECT_THAT(measured->remarks, Contains("found readings that were simulated, expected those of a machine"));
}

TEST_F(SimulatedMotions, ARotationIsReadInTheUnitThatIsStated) {
  const Plan plan = simulated_plan("EBX");
  const auto service = open();
  const CaptureState plain = end_of(*service, service->start(wish(plan, "readings")));
  EXPECT_EQ(plain.motion->unit, MotionUnit::urad);
  expect_truth(plain, plan, usual_motion_size);
  const CaptureState stated = end_of(*service, service->start(wish(plan, "readings", {{"unit", "arcsec"}})));
  EXPECT_EQ(stated.motion->unit, MotionUnit::arcsec);
  expect_truth(stated, plan, usual_motion_size, 1.0 / 0.20626480624709636);
}

TEST_F(SimulatedMotions, ADriftIsToldByItsPreset) {
  const Plan plan = simulated_plan();
  const auto service = open();
  const CaptureState end =
      end_of(*service, service->start(wish(plan, "trigger", {{"preset", "drift"}, {"size", "20"}})));
  EXPECT_EQ(end.came_to->found, approaches(plan).size()) << end.error;
  EXPECT_THAT(service->file_of(end.id, "readings").value_or(""), HasSubstr("fault drift, size 20 um"));
}

TEST_F(SimulatedMotions, GoesOnBehindWhatWasHeardBeforeTheProgramEnded) {
  const Plan plan = simulated_plan();
  for (const char* stops : {"keys", "trigger"}) {
    store::Id id = 0;
    {
      const auto service = open();
      const auto started = service->start(wish(plan, stops, {}, "10"));
      ASSERT_TRUE(started) << started.error().to_string();
      id = started->id;
      if (started->motion->order.sign == capture::StopSign::keys)
        taken_at_each_stop(*service, id, 2);
      else
        wait_for(*service, id, [](const CaptureState& s) { return s.taken >= 2; });
    }
    const auto service = open();
    EXPECT_EQ(service->state(id)->stage, Stage::interrupted);
    ASSERT_TRUE(service->resume(id));
    if (std::string_view(stops) == "keys") taken_at_each_stop(*service, id, 6);
    const CaptureState end = wait_for(*service, id, [](const CaptureState& s) { return has_ended(s.stage); });
    EXPECT_GE(end.came_to->found, 5u) << stops << ": the one that was being read may be lost; " << end.error;
    EXPECT_THAT(end.error, Not(HasSubstr("time")));
  }
}

TEST_F(SimulatedMotions, WhatTheSimulatorCannotSendIsRefused) {
  const auto service = open();
  const auto refusal = [&](const CaptureWish& wished) {
    const auto started = service->start(wished);
    return started ? "" : started.error().message;
  };
  const Plan plan = simulated_plan();
  EXPECT_THAT(refusal(wish(plan, "keys", {{"preset", "backlash"}})), HasSubstr("preset: found \"backlash\""));
  for (const char* size : {"0", "-1", "1001", "much"})
    EXPECT_THAT(refusal(wish(plan, "keys", {{"size", size}})), HasSubstr("size: found")) << size;
  EXPECT_THAT(refusal(wish(plan, "keys", {{"stream-axis", "2"}})),
              HasSubstr("stream-axis: found 2 with the simulator"));
  EXPECT_THAT(refusal(wish(plan, "trigger", {{"stop-column", "1"}})), HasSubstr("stop-column: found 1"));
  EXPECT_THAT(refusal(wish(plan, "keys", {{"unit", "arcsec"}})), HasSubstr("found EYX in"));
  CaptureWish other = wish(plan, "keys");
  other.layout = "umd";
  EXPECT_THAT(refusal(other), HasSubstr("layout: found umd with the simulator, expected time-position or none"));
  Plan of_positions = plan;
  of_positions.errors.clear();
  CaptureWish sized = wish(of_positions, "keys", {{"size", "5"}});
  std::erase_if(sized.options, [](const auto& option) { return option.first == "stops"; });
  EXPECT_THAT(refusal(sized), HasSubstr("found size, expected it with the stops"));
  EXPECT_TRUE(service->states().empty());
}

}  // namespace
}  // namespace axiometry::app
