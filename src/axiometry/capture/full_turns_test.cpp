// SPDX-License-Identifier: Apache-2.0
#include "axiometry/capture/full_turns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "axiometry/capture/target_matcher.h"
#include "tests/support/made_up_recording.h"

namespace axiometry::capture {
namespace {

using testing_support::MadeUpRun;

/// Rotary plan with targets from first on, one each `step` degrees.
Plan turning_plan(double first, double step, std::size_t targets) {
  Plan plan = testing_support::made_up_plan();
  plan.axis.name = "C";
  plan.axis.kind = AxisKind::rotary;
  plan.targets.clear();
  for (std::size_t i = 0; i < targets; ++i)
    plan.targets.push_back(Position::native(first + step * static_cast<double>(i)));
  plan.feed = 3600.0;
  return plan;
}

MadeUpRun turning_run(Plan plan) {
  MadeUpRun run;
  run.plan = std::move(plan);
  run.rate_hz = 200.0;
  run.quantum = 0.0001;
  return run;
}

/// What an instrument shows that begins at `lowest` again after each turn.
std::vector<Sample> rolling(std::vector<Sample> samples, double lowest) {
  for (Sample& s : samples) s.position -= full_turn_deg * std::floor((s.position - lowest) / full_turn_deg);
  return samples;
}

CaptureResult capture_turns(const Plan& plan, const std::vector<Sample>& shown, bool reversed = false,
                            std::size_t piece = SIZE_MAX) {
  const StandstillOptions rest = standstill_options(plan);
  StandstillDetector detector(rest);
  FullTurns turns(fastest_turn(plan.feed));
  auto matcher = TargetMatcher::make(plan, {.shortest = rest.shortest, .reversed = reversed});
  EXPECT_TRUE(matcher) << matcher.error().message;
  for (std::span<const Sample> left = shown; !left.empty(); left = left.subspan(std::min(piece, left.size()))) {
    const auto followed = turns.follow(left.first(std::min(piece, left.size())));
    if (turns.rolls_from_s()) matcher->rolls_from(*turns.rolls_from_s());
    for (const Standstill& s : detector.push(followed)) matcher->take(s);
  }
  for (const Standstill& s : detector.interrupt()) matcher->take(s);
  EXPECT_TRUE(matcher->finish());
  return matcher->result();
}

std::string told(const CaptureResult& result) {
  std::string text;
  for (const CaptureEvent& event : result.events) text += event.message + "\n";
  return text;
}

void expect_all(const MadeUpRun& run, const CaptureResult& result) {
  const std::vector<Approach> expected = approaches(run.plan);
  ASSERT_EQ(result.readings.size(), expected.size()) << told(result);
  for (std::size_t k = 0; k < expected.size(); ++k) {
    const CapturedReading& r = result.readings[k];
    EXPECT_EQ(approach_name(r.approach), approach_name(expected[k]));
    EXPECT_NEAR(r.deviation.in_native(), 3600.0 * run.deviation(expected[k]), 1.0) << approach_name(r.approach);
  }
}

TEST(FullTurns, FindsEveryReadingOfAnInstrumentThatRollsOver) {
  const Plan plans[] = {turning_plan(0.0, 45.0, 9),    turning_plan(-180.0, 45.0, 9), turning_plan(-30.0, 10.0, 7),
                        turning_plan(-90.0, 30.0, 31), turning_plan(330.0, 15.0, 9),  turning_plan(0.0, 90.0, 9),
                        turning_plan(-720.0, 90.0, 9)};
  for (const Plan& plan : plans)
    for (const double lowest : {0.0, -180.0}) {
      SCOPED_TRACE(testing::Message() << plan.targets.front().in_native() << " to " << plan.targets.back().in_native()
                                      << ", shown from " << lowest);
      MadeUpRun run = turning_run(plan);
      for (const double sign : {1.0, -1.0}) {
        run.deviation = [sign](const Approach& a) {
          return sign *
                 (0.001 + 0.0002 * static_cast<double>(a.target) - (a.direction == Direction::down ? 0.002 : 0.0));
        };
        const CaptureResult result = capture_turns(plan, rolling(run.record(), lowest));
        expect_all(run, result);
        EXPECT_LE(result.events.size(), 1u) << told(result);
      }
    }
}

TEST(FullTurns, FindsThemAtSpeedAndWithFewSamples) {
  Plan plan = turning_plan(0.0, 45.0, 17);
  plan.feed = 36'000.0;  // 100 turns a minute
  plan.overrun = Position::native(90.0);
  plan.dwell = Duration::s(4.0);
  MadeUpRun run = turning_run(plan);
  run.rate_hz = 12.0;
  expect_all(run, capture_turns(plan, run.record()));
  expect_all(run, capture_turns(plan, rolling(run.record(), 0.0)));
}

TEST(FullTurns, ReadsAReversedInstrumentThatRollsOver) {
  const MadeUpRun run = turning_run(turning_plan(0.0, 45.0, 9));
  std::vector<Sample> mirrored = run.record();
  for (Sample& s : mirrored) s.position = -s.position;
  expect_all(run, capture_turns(run.plan, rolling(mirrored, 0.0), true));
}

TEST(FullTurns, AWrongSignIsStillFoundAsSuch) {
  const MadeUpRun run = turning_run(turning_plan(0.0, 45.0, 9));
  std::vector<Sample> mirrored = run.record();
  for (Sample& s : mirrored) s.position = -s.position;
  EXPECT_FALSE(check_fit(run.plan, capture_turns(run.plan, rolling(mirrored, 0.0))));
}

TEST(FullTurns, AStreamWithoutRolloverStaysAsItIs) {
  for (const double shift : {0.0, -45.0, 360.0}) {  // to 720 and beyond; of another zero; a turn off
    MadeUpRun run = turning_run(turning_plan(-30.0, 45.0, 19));
    run.spike = 999.0;
    run.spike_every = 301;
    std::vector<Sample> samples = run.record();
    for (Sample& s : samples) s.position += shift;
    std::vector<Sample> torn(samples.begin(), samples.begin() + 2000);  // a gap in which it goes on by more than a turn
    torn.insert(torn.end(), samples.begin() + 8000, samples.end());
    for (const auto& recorded : {samples, torn}) {
      FullTurns turns(fastest_turn(run.plan.feed));
      const auto followed = turns.follow(recorded);
      EXPECT_EQ(followed.data(), recorded.data());
      EXPECT_FALSE(turns.rolls_from_s());
    }
  }
}

TEST(FullTurns, BeforeTheTestAPlaceATurnOffTheTargetsIsNone) {
  const MadeUpRun run = turning_run(turning_plan(0.0, 45.0, 9));
  auto stops = run.stops();
  stops.insert(stops.begin(), {MadeUpRun::Stop{-40.0, 0.0}, MadeUpRun::Stop{-45.0, 3.0}});
  expect_all(run, capture_turns(run.plan, run.record(stops)));
  expect_all(run, capture_turns(run.plan, rolling(run.record(stops), 0.0)));
}

TEST(FullTurns, FalseSamplesAndNoiseAtTheRolloverCountForNothing) {
  MadeUpRun run = turning_run(turning_plan(0.0, 45.0, 9));
  run.noise = 0.001;
  run.deviation = [](const Approach&) { return 0.0; };  // at rest the instrument shows 0 and 359.999 in turn
  std::vector<Sample> shown = rolling(run.record(), 0.0);
  for (std::size_t k = 150; k < shown.size(); k += 401) shown[k].position = 0.0;
  expect_all(run, capture_turns(run.plan, shown));
}

TEST(FullTurns, BehindAGapTheTurnIsFoundAgain) {
  const MadeUpRun run = turning_run(turning_plan(0.0, 60.0, 13));
  const std::vector<Sample> all = rolling(run.record(), 0.0);
  const CaptureResult whole = capture_turns(run.plan, all);
  ASSERT_EQ(whole.readings.size(), approaches(run.plan).size());
  for (const std::size_t first : {5u, 11u, 20u}) {
    std::vector<Sample> torn;
    const double from_s = whole.readings[first].standstill.end_s + 0.3;
    const double to_s = whole.readings[first + 1].standstill.begin_s + 0.5;
    for (const Sample& s : all)
      if (s.time_s < from_s || s.time_s > to_s) torn.push_back(s);
    const CaptureResult result = capture_turns(run.plan, torn);
    ASSERT_EQ(result.readings.size(), whole.readings.size() - 1);
    for (std::size_t k = 0; k < result.readings.size(); ++k)
      EXPECT_EQ(result.readings[k].approach, whole.readings[k <= first ? k : k + 1].approach);
  }
}

/// What is shown where the last cell of the standstill detector lies, which may be of before a rollover.
TEST(FullTurns, TellWhatTheInstrumentShowsOfAPositionOnEitherSideOfARollover) {
  const MadeUpRun run = turning_run(turning_plan(0.0, 45.0, 17));
  for (const double lowest : {0.0, -180.0, -30.0}) {
    const std::vector<Sample> counted = run.record(), shown = rolling(counted, lowest);
    FullTurns turns(fastest_turn(run.plan.feed));
    std::vector<double> positions;
    std::size_t rolled = 0;
    for (std::size_t k = 0; k < shown.size(); ++k) {
      positions.push_back(turns.follow({&shown[k], 1}).front().position);
      rolled += k > 0 && std::abs(shown[k].position - shown[k - 1].position) > 180.0 ? 1 : 0;
      for (std::size_t back = 0; back <= std::min<std::size_t>(k, 40); ++back) {
        const double told = turns.shown_deg(positions[k - back]);
        ASSERT_NEAR(std::remainder(told - shown[k - back].position, full_turn_deg), 0.0, 1e-9);
        ASSERT_NEAR(told, lowest + 180.0, 180.0 + 0.001) << lowest << ": sample " << k << ", " << back << " before";
      }
    }
    EXPECT_GT(rolled, 1u);
  }
}

TEST(FullTurns, ForgetAFirstSampleThatWasFalse) {
  const MadeUpRun run = turning_run(turning_plan(0.0, 45.0, 19));
  std::vector<Sample> shown = rolling(run.record(), 0.0);
  shown.front().position = 5000.0;
  FullTurns turns(fastest_turn(run.plan.feed));
  const double end = turns.follow(shown).back().position;
  ASSERT_TRUE(turns.rolls_from_s());
  EXPECT_NEAR(turns.shown_deg(end), shown.back().position, 1e-9);
}

TEST(FullTurns, ShowWhatCountsOnAsItIs) {
  const MadeUpRun run = turning_run(turning_plan(-30.0, 45.0, 19));  // to 780°
  FullTurns turns(fastest_turn(run.plan.feed));
  const std::vector<Sample> all = run.record();
  turns.follow(all);
  EXPECT_EQ(turns.shown_deg(770.0), 770.0);
  EXPECT_EQ(turns.shown_deg(-30.0), -30.0);
}

TEST(FullTurns, TheResultDoesNotDependOnThePieces) {
  const MadeUpRun run = turning_run(turning_plan(-90.0, 30.0, 31));
  const std::vector<Sample> shown = rolling(run.record(), 0.0);
  const CaptureResult whole = capture_turns(run.plan, shown);
  for (const std::size_t piece : {1u, 7u, 1000u}) {
    const CaptureResult result = capture_turns(run.plan, shown, false, piece);
    ASSERT_EQ(result.readings.size(), whole.readings.size());
    ASSERT_EQ(result.events.size(), whole.events.size());
    for (std::size_t k = 0; k < whole.readings.size(); ++k)
      EXPECT_EQ(result.readings[k].deviation, whole.readings[k].deviation);
  }
}

}  // namespace
}  // namespace axiometry::capture
