// SPDX-License-Identifier: Apache-2.0
#include "axiometry/capture/target_matcher.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "tests/support/made_up_recording.h"

namespace axiometry::capture {
namespace {

using testing_support::made_up_plan;
using testing_support::MadeUpRun;

CaptureResult capture_all(const Plan& plan, const std::vector<Sample>& samples, MatcherOptions options = {}) {
  const StandstillOptions rest = standstill_options(plan);
  StandstillDetector detector(rest);
  options.shortest = rest.shortest;
  auto matcher = TargetMatcher::make(plan, options);
  EXPECT_TRUE(matcher) << matcher.error().message;
  for (const Standstill& s : detector.push(samples)) matcher->take(s);
  for (const Standstill& s : detector.interrupt()) matcher->take(s);
  const auto finished = matcher->finish();
  EXPECT_TRUE(finished) << finished.error().message;
  return matcher->result();
}

std::size_t count_of(const CaptureResult& result, EventKind kind) {
  return static_cast<std::size_t>(std::ranges::count(result.events, kind, &CaptureEvent::kind));
}

/// Every reading is the true deviation of its approach.
void expect_true(const MadeUpRun& run, const CaptureResult& result) {
  for (const CapturedReading& r : result.readings)
    EXPECT_NEAR(r.deviation.in_native(), 1000.0 * run.deviation(r.approach), 0.05) << approach_name(r.approach);
}

std::vector<Approach> approaches_of(const CaptureResult& result) {
  std::vector<Approach> list;
  for (const CapturedReading& r : result.readings) list.push_back(r.approach);
  return list;
}

TEST(TargetMatcher, FindsEveryApproachOfEveryCycle) {
  for (TestCycle cycle : {TestCycle::standard, TestCycle::step, TestCycle::pilgrim, TestCycle::unidirectional}) {
    SCOPED_TRACE(cycle_name(cycle));
    MadeUpRun run;
    run.plan = made_up_plan(4, 2, cycle);
    const CaptureResult result = capture_all(run.plan, run.record());
    EXPECT_EQ(approaches_of(result), approaches(run.plan));
    EXPECT_TRUE(result.events.empty()) << result.events.front().message;
    expect_true(run, result);
  }
}

TEST(TargetMatcher, KnowsStandstillsAtOverruns) {
  MadeUpRun run;
  run.overrun_dwell_s = 3.0;
  const CaptureResult result = capture_all(run.plan, run.record());
  EXPECT_EQ(approaches_of(result), approaches(run.plan));
  EXPECT_EQ(result.overruns, 4u);  // the last one comes after the last approach
  EXPECT_TRUE(result.events.empty());
}

TEST(TargetMatcher, OneMissedTargetShiftsNoOther) {
  const std::size_t all = approaches(made_up_plan()).size();
  for (std::size_t missed = 0; missed < all; ++missed) {
    SCOPED_TRACE(missed);
    MadeUpRun run;
    run.missed = {missed};
    const CaptureResult result = capture_all(run.plan, run.record());
    auto expected = approaches(run.plan);
    expected.erase(expected.begin() + static_cast<std::ptrdiff_t>(missed));
    EXPECT_EQ(approaches_of(result), expected);
    EXPECT_EQ(count_of(result, missed + 1 == all ? EventKind::incomplete : EventKind::missed), 1u);
    if (missed + 1 == all)
      EXPECT_EQ(result.events.back().message,
                "the recording ended before " + approach_name(approaches(run.plan).back()));
    expect_true(run, result);
  }
}

TEST(TargetMatcher, FindsItsPlaceAgainAfterAWholePassWithoutStops) {
  MadeUpRun run;
  run.missed = {3, 4, 5, 6, 7};  // 4↑ 5↑ 5↓ 4↓ 3↓
  const CaptureResult result = capture_all(run.plan, run.record());
  EXPECT_EQ(result.readings.size(), 15u);
  EXPECT_EQ(result.readings[3].approach, (Approach{1, Direction::down, 0}));
  expect_true(run, result);
}

/// The stops of the plan with something done to them.
template <typename Change>
std::vector<Sample> record_changed(const MadeUpRun& run, Change change) {
  auto stops = run.stops();
  change(stops);
  return run.record(stops);
}

TEST(TargetMatcher, KeepsTheFirstOfTwoStandstillsAtOneApproach) {
  MadeUpRun run;
  const CaptureResult result =
      capture_all(run.plan, record_changed(run, [](auto& stops) {
                    stops.insert(stops.begin() + 3, {stops[2].position + 0.04, 2.0});  // nudged on and at rest again
                  }));
  EXPECT_EQ(approaches_of(result), approaches(run.plan));
  EXPECT_EQ(count_of(result, EventKind::repeated), 1u);
  expect_true(run, result);
}

TEST(TargetMatcher, DoesNotUseAReadingFromTheWrongSide) {
  MadeUpRun run;
  const CaptureResult result =
      capture_all(run.plan, record_changed(run, [](auto& stops) {
                    stops.insert(stops.begin() + 3, {stops[3].position + 3.0, 0.0});  // too far, then back to target 3
                  }));
  EXPECT_EQ(result.readings.size(), approaches(run.plan).size() - 1);
  EXPECT_EQ(count_of(result, EventKind::wrong_direction), 1u);
  EXPECT_EQ(count_of(result, EventKind::missed), 1u);
  EXPECT_TRUE(std::ranges::none_of(result.readings, [](const auto& r) {
    return r.approach == Approach{2, Direction::up, 0};
  }));
  expect_true(run, result);
}

TEST(TargetMatcher, TellsOfStandstillsElsewhereAndOfShortOnes) {
  MadeUpRun run;
  const CaptureResult result = capture_all(run.plan, record_changed(run, [](auto& stops) {
                                             stops[4].dwell_s = 0.8;
                                             stops.insert(stops.begin() + 3, {stops[2].position + 9.0, 2.0});
                                           }));
  EXPECT_EQ(count_of(result, EventKind::unexpected), 1u);
  EXPECT_EQ(count_of(result, EventKind::too_short), 1u);
  EXPECT_EQ(count_of(result, EventKind::missed), 1u);
  EXPECT_EQ(result.readings.size(), approaches(run.plan).size() - 1);
  expect_true(run, result);
}

TEST(TargetMatcher, BeginsAgainWhereTheTestWasBegunAgain) {
  MadeUpRun run;
  const CaptureResult result = capture_all(run.plan, record_changed(run, [&](auto& stops) {
                                             const auto begin = std::vector(stops.begin(), stops.begin() + 4);
                                             stops.insert(stops.begin(), begin.begin(), begin.end());
                                           }));
  EXPECT_EQ(approaches_of(result), approaches(run.plan));
  EXPECT_EQ(count_of(result, EventKind::restarted), 1u);
  expect_true(run, result);
}

TEST(TargetMatcher, SaysWhatIsMissingWhenTheRecordingEndsEarly) {
  MadeUpRun run;
  auto samples = run.record();
  samples.resize(samples.size() / 3);
  const CaptureResult result = capture_all(run.plan, samples);
  EXPECT_EQ(count_of(result, EventKind::incomplete), 1u);
  EXPECT_LT(result.readings.size(), 10u);
  EXPECT_GT(result.readings.size(), 3u);
  expect_true(run, result);
}

TEST(TargetMatcher, AppliesSignAndDatumAndFitsNothing) {
  MadeUpRun run;
  auto samples = run.record();
  for (Sample& s : samples) s.position = -(s.position - 500.0);
  const CaptureResult result = capture_all(run.plan, samples, {.reversed = true, .datum = Position::native(500.0)});
  EXPECT_EQ(approaches_of(result), approaches(run.plan));
  EXPECT_TRUE(result.events.empty());
  expect_true(run, result);
}

TEST(TargetMatcher, SetsTheZeroAtTheFirstTargetAndSaysSo) {
  for (bool reversed : {false, true}) {
    for (TestCycle cycle : {TestCycle::standard, TestCycle::step, TestCycle::pilgrim}) {
      SCOPED_TRACE(std::string(cycle_name(cycle)) + (reversed ? " reversed" : ""));
      MadeUpRun run;
      run.plan = made_up_plan(4, 2, cycle);
      run.overrun_dwell_s = 2.0;
      auto samples = run.record();
      for (Sample& s : samples) s.position = (reversed ? -1.0 : 1.0) * (s.position - 123.456);
      const CaptureResult result = capture_all(run.plan, samples, {.reversed = reversed, .zero_at_first_target = true});
      EXPECT_EQ(approaches_of(result), approaches(run.plan));
      EXPECT_EQ(count_of(result, EventKind::zero), 1u);
      ASSERT_FALSE(result.readings.empty());
      EXPECT_NEAR(result.readings[0].deviation.in_native(), 0.0, 1e-6);
      for (const CapturedReading& r : result.readings)
        EXPECT_NEAR(r.deviation.in_native(), 1000.0 * (run.deviation(r.approach) - run.deviation({})), 0.05);
    }
  }
}

TEST(TargetMatcher, TellsOfAnOffsetThatLooksLikeAnotherZero) {
  MadeUpRun run;
  auto samples = run.record();
  for (Sample& s : samples) s.position += 1.5;
  const CaptureResult result = capture_all(run.plan, samples);
  EXPECT_EQ(result.readings.size(), 20u);
  EXPECT_EQ(count_of(result, EventKind::off_zero), 1u);
}

/// Samples from a to b (in s) are missing.
std::vector<Sample> without(std::vector<Sample> samples, double a, double b) {
  std::erase_if(samples, [&](const Sample& s) { return s.time_s >= a && s.time_s < b; });
  return samples;
}

TEST(TargetMatcher, GapsMissReadingsAndShiftNone) {
  MadeUpRun run;
  const auto samples = run.record();
  const double end_s = samples.back().time_s;
  for (double begin_s = 0.5; begin_s + 8.0 < end_s; begin_s += 1.7) {
    for (double length_s : {1.0, 4.0, 8.0}) {
      SCOPED_TRACE(testing::Message() << "gap from " << begin_s << " s, " << length_s << " s long");
      const CaptureResult result = capture_all(run.plan, without(samples, begin_s, begin_s + length_s));
      expect_true(run, result);
      EXPECT_GE(result.readings.size(), 14u);
    }
  }
}

TEST(TargetMatcher, AWholeRunThatIsMissingShiftsNoOther) {
  MadeUpRun run;
  run.plan = made_up_plan(5, 4);
  const auto samples = run.record();
  const double run_s = samples.back().time_s / 4.0;
  for (double begin_s = 10.0; begin_s + 1.4 * run_s < samples.back().time_s; begin_s += 7.0) {
    SCOPED_TRACE(begin_s);
    const CaptureResult result = capture_all(run.plan, without(samples, begin_s, begin_s + 1.1 * run_s));
    expect_true(run, result);
    EXPECT_EQ(result.readings.back().approach, approaches(run.plan).back());
    EXPECT_EQ(count_of(result, EventKind::doubtful), 0u);
    const std::string told = fmt::format("samples are missing from {:.2f} s to ", begin_s);
    EXPECT_TRUE(std::ranges::any_of(result.events, [&](const auto& e) { return e.message.starts_with(told); })) << told;
  }
}

TEST(TargetMatcher, UsesNoTargetThatTheAxisCameBackTo) {
  for (const double beyond : {0.2, 0.6, 1.1}) {
    SCOPED_TRACE(beyond);
    MadeUpRun run;
    const CaptureResult result = capture_all(
        run.plan, record_changed(run, [&](auto& stops) {
          for (std::size_t k = stops.size(); k-- > 1;)
            if (stops[k].dwell_s > 0.0)
              stops.insert(stops.begin() + static_cast<std::ptrdiff_t>(k),
                           {stops[k].position + std::copysign(beyond, stops[k].position - stops[k - 1].position), 0.0});
        }));
    EXPECT_TRUE(result.readings.empty()) << approach_name(result.readings.front().approach);
    const auto test = captured_test(run.plan, result);
    ASSERT_FALSE(test);
  }
}

TEST(TargetMatcher, AnOvershootOfTheAxisIsNoOtherWay) {
  MadeUpRun run;
  run.tail = -0.02;  // beyond, and back within some tenths of a second
  const CaptureResult result = capture_all(run.plan, run.record());
  EXPECT_EQ(approaches_of(result), approaches(run.plan));
  expect_true(run, result);
}

TEST(TargetMatcher, TellsOfStandstillsBehindTheLastApproach) {
  MadeUpRun run;
  const CaptureResult result = capture_all(run.plan, record_changed(run, [](auto& stops) {
                                             const std::vector<MadeUpRun::Stop> pass(stops.begin(), stops.begin() + 6);
                                             stops.insert(stops.end(), pass.begin(), pass.end());  // begun once more
                                           }));
  EXPECT_EQ(result.readings.size(), 20u);
  ASSERT_EQ(count_of(result, EventKind::unexpected), 1u);
  EXPECT_TRUE(result.events.back().message.starts_with("5 more standstills at targets behind the last approach"))
      << result.events.back().message;
}

TEST(TargetMatcher, RefusesARecordingThatDoesNotFitThePlan) {
  MadeUpRun run;
  auto samples = run.record();
  for (Sample& s : samples) s.position += 9.0;
  const CaptureResult result = capture_all(run.plan, samples);
  const auto test = captured_test(run.plan, result);
  ASSERT_FALSE(test);
  EXPECT_TRUE(test.error().message.starts_with("found 0 of ")) << test.error().message;
}

TEST(TargetMatcher, SaysThatNothingRestedInsteadOfBlamingThePlan) {
  MadeUpRun run;
  const auto samples = run.record();
  const CaptureResult result = capture_all(run.plan, std::vector<Sample>(samples.begin(), samples.begin() + 40));
  ASSERT_EQ(result.standstills, 0u);
  const auto test = captured_test(run.plan, result);
  ASSERT_FALSE(test);
  EXPECT_TRUE(test.error().message.starts_with("found no standstill that is long enough")) << test.error().message;
}

TEST(TargetMatcher, RefusesARecordingOfTargetsThatAreOnlyNearThoseOfThePlan) {
  MadeUpRun run;
  const auto samples = run.record();
  Plan other = run.plan;
  for (std::size_t i = 0; i < other.targets.size(); ++i)
    other.targets[i] = Position::native(other.targets[i].in_native() + (i % 2 == 0 ? 1.5 : -1.5));
  const CaptureResult result = capture_all(other, samples);
  EXPECT_EQ(result.readings.size(), approaches(other).size());
  const auto test = captured_test(other, result);
  ASSERT_FALSE(test);
  EXPECT_TRUE(test.error().message.contains("belongs to another plan")) << test.error().message;
}

TEST(TargetMatcher, TakesADistantZeroForNoOtherPlan) {
  MadeUpRun run;
  auto samples = run.record();
  for (Sample& s : samples) s.position += 2.0;
  EXPECT_TRUE(captured_test(run.plan, capture_all(run.plan, samples)));
}

TEST(TargetMatcher, RefusesAWindowThatReachesTheNextTarget) {
  EXPECT_FALSE(TargetMatcher::make(made_up_plan(), {.window = Position::native(20.0)}));
  EXPECT_FALSE(TargetMatcher::make(made_up_plan(), {.window = Position::native(0.0)}));
  EXPECT_EQ(default_window(made_up_plan()), Position::native(2.5));
}

TEST(CapturedTest, HoldsReadingsTimesAndWhatThePlanSays) {
  MadeUpRun run;
  run.missed = {2};
  const CaptureResult result = capture_all(run.plan, run.record());
  const auto test = captured_test(run.plan, result);
  ASSERT_TRUE(test) << test.error().message;
  EXPECT_EQ(test->series.target_count(), 5u);
  EXPECT_EQ(test->series.run_count(), 2u);
  EXPECT_EQ(test->series.reading_count(), 19u);
  EXPECT_FALSE(test->series.reading(2, Direction::up, 0));
  EXPECT_NEAR(test->series.reading(3, Direction::down, 1)->in_native(), 3.5, 0.05);
  EXPECT_EQ(test->metadata.conditions.feed, 1200.0);
  ASSERT_EQ(test->times_s.size(), 20u);
  EXPECT_TRUE(std::isnan(test->times_s[2 * 2]));
  EXPECT_LT(test->times_s[0], test->times_s[2]);
  EXPECT_FALSE(test->provenance.remarks.empty());
}

TEST(CapturedTest, TellsNoiseThatMakesTheScatterBetweenRuns) {
  const auto tells = [](double noise) {
    MadeUpRun run;
    run.noise = noise;
    const auto test = captured_test(run.plan, capture_all(run.plan, run.record()));
    EXPECT_TRUE(test) << test.error().message;
    return test && std::ranges::any_of(test->provenance.remarks, [](const SourceRemark& remark) {
             return remark.message.contains("samples at rest scatter");
           });
  };
  EXPECT_FALSE(tells(0.0001));
  EXPECT_TRUE(tells(0.05));
}

TEST(CapturedTest, LeavesOutTargetsThatWereNeverReached) {
  MadeUpRun run;
  auto samples = run.record();
  samples.resize(samples.size() / 8);
  const auto test = captured_test(run.plan, capture_all(run.plan, samples));
  ASSERT_TRUE(test) << test.error().message;
  EXPECT_LT(test->series.target_count(), 5u);
  EXPECT_GE(test->series.target_count(), 2u);
  EXPECT_TRUE(std::ranges::any_of(test->provenance.remarks, &SourceRemark::departs));
}

/// Close to a target the value stands still, while the axis goes there, rests, and goes on to the next one.
TEST(TargetMatcher, TakesNoReadingOfAValueThatFrozeAndJumped) {
  MadeUpRun run;
  auto samples = run.record();
  const double target = run.plan.targets[1].in_native();
  const auto near = std::ranges::find_if(samples, [&](const Sample& s) { return s.position > target - 0.3; });
  const auto end = near + static_cast<std::ptrdiff_t>(4.5 * run.rate_hz);
  for (auto s = near; s != end; ++s) s->position = near->position;
  ASSERT_GT(end->position, target + 10.0);
  const CaptureResult result = capture_all(run.plan, samples);
  auto expected = approaches(run.plan);
  expected.erase(expected.begin() + 1, expected.begin() + 3);  // and the way to the next one was not seen
  EXPECT_EQ(approaches_of(result), expected);
  EXPECT_EQ(count_of(result, EventKind::signal_lost), 1u);
  EXPECT_EQ(count_of(result, EventKind::unseen), 1u);
  expect_true(run, result);
}

}  // namespace
}  // namespace axiometry::capture
