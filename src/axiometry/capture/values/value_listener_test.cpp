// SPDX-License-Identifier: Apache-2.0
#include "axiometry/capture/values/value_listener.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "tests/support/made_up_motion.h"

namespace axiometry::capture {
namespace {

using testing::HasSubstr;
using testing_support::DrivenAxis;
using testing_support::DrivenSample;
using testing_support::straightness_plan;
using testing_support::true_straightness_um;

std::vector<Sample> values_of(std::span<const DrivenSample> driven) {
  std::vector<Sample> samples;
  for (const DrivenSample& s : driven) samples.push_back({s.time_s, s.value_um});
  return samples;
}

std::vector<Sample> beside_of(std::span<const DrivenSample> driven, StopSign sign) {
  std::vector<Sample> samples;
  for (const DrivenSample& s : driven)
    samples.push_back({s.time_s, sign == StopSign::position ? s.position_mm : s.trigger ? 1.0 : 0.0});
  return samples;
}

ValueListener listener_of(const Plan& plan, StopSign sign) {
  ValueOptions options{.sign = sign, .still = {}, .rest = standstill_options(plan), .matcher = {}};
  options.window = value_window(plan);
  options.matcher.shortest = options.rest.shortest;
  return *ValueListener::make(plan, options);
}

/// In pieces of that many samples.
void feed(ValueListener& listener, std::span<const DrivenSample> driven, std::size_t piece = 1000) {
  const StopSign sign = listener.options().sign;
  for (; !driven.empty(); driven = driven.subspan(std::min(piece, driven.size()))) {
    const auto part = driven.first(std::min(piece, driven.size()));
    if (sign == StopSign::trigger) listener.push_beside(beside_of(part, sign));
    listener.push(values_of(part));
    if (sign == StopSign::position) listener.push_beside(beside_of(part, sign));
  }
}

void expect_truth(const ValueListener& listener, std::size_t count) {
  const auto values = listener.values();
  std::string told;
  for (const CaptureEvent& event : listener.events()) told += event.message + "\n";
  ASSERT_EQ(values.size(), count) << told;
  for (const PlannedValue& v : values)
    EXPECT_NEAR(v.still.value, true_straightness_um(listener.plan(), v.approach), 0.05) << approach_name(v.approach);
}

std::size_t events_of(const ValueListener& listener, EventKind kind) {
  return static_cast<std::size_t>(std::ranges::count(listener.events(), kind, &CaptureEvent::kind));
}

std::string message_of(const ValueListener& listener, EventKind kind) {
  for (const CaptureEvent& event : listener.events())
    if (event.kind == kind) return event.message;
  return "";
}

/// One sample for each stop, in its middle.
std::vector<Sample> one_reading_each(const DrivenAxis& axis, const Plan& plan) {
  std::vector<Sample> readings;
  for (const auto& stop : axis.stops())
    readings.push_back({0.5 * (stop.begin_s + stop.end_s), true_straightness_um(plan, stop.approach)});
  return readings;
}

TEST(StillValue, IsTheMeanOfWhatStandsStill) {
  std::vector<Sample> samples;
  for (int k = 0; k < 40; ++k) samples.push_back({0.1 * k, 3.0 + (k % 2 == 0 ? 0.3 : -0.3)});
  samples[11].position = 500.0;
  const auto still = still_value(samples, {});
  ASSERT_TRUE(still) << still.error().message;
  EXPECT_NEAR(still->value, 3.0, 0.02);
  EXPECT_EQ(still->rejected, 1u);
  EXPECT_NEAR(still->spread, 0.3, 0.01);
  EXPECT_NEAR(still->drift, 0.0, 0.05);
}

TEST(StillValue, IsNoneOfTooFewOrOfWhatMoves) {
  std::vector<Sample> samples;
  for (int k = 0; k < 15; ++k) samples.push_back({0.1 * k, 3.0});
  EXPECT_EQ(still_value(samples, {}).error().message,
            "found 15 samples, expected at least 16 to tell whether they stand still");
  samples.clear();
  for (int k = 0; k < 100; ++k) samples.push_back({0.1 * k, 0.05 * k});
  EXPECT_THAT(still_value(samples, {}).error().message, HasSubstr("found means that range over 3.75 µm, expected "));
  EXPECT_EQ(still_value(samples, {.threshold = 1.0, .unit = "″"}).error().message,
            "found means that range over 3.75 ″, expected 1.00 at most");
  EXPECT_TRUE(still_value(samples, {.threshold = 4.0}));
  // However noisy: means that wander by more than ten times what is always allowed.
  for (int k = 0; k < 100; ++k) samples[static_cast<std::size_t>(k)].position = (k % 2 == 0 ? 40.0 : -40.0) + 0.2 * k;
  EXPECT_THAT(still_value(samples, {}).error().message, HasSubstr("expected 10.00 at most"));
}

TEST(ValueListener, TakesOneWindowBehindEachTrigger) {
  const Plan plan = straightness_plan();
  const DrivenAxis axis(plan);
  for (const std::size_t piece : {std::size_t{1}, std::size_t{7}, std::size_t{100000}}) {
    ValueListener listener = listener_of(plan, StopSign::trigger);
    feed(listener, axis.samples(), piece);
    ASSERT_TRUE(listener.finish());
    EXPECT_TRUE(listener.complete());
    expect_truth(listener, 12);
    EXPECT_TRUE(listener.events().empty()) << listener.events().front().message;
  }
}

TEST(ValueListener, AnswersNoDoubleTrigger) {
  const Plan plan = straightness_plan();
  const DrivenAxis axis(plan);
  auto samples = axis.samples();
  const auto again_at = axis.stops()[1].begin_s + 2.4;  // within the window, then behind it
  for (DrivenSample& s : samples) s.trigger = s.trigger || (s.time_s > again_at && s.time_s < again_at + 0.05);
  const auto later = axis.stops()[2].end_s - 0.05;
  for (DrivenSample& s : samples) s.trigger = s.trigger || (s.time_s > later && s.time_s < later + 0.04);
  ValueListener listener = listener_of(plan, StopSign::trigger);
  feed(listener, samples);
  ASSERT_TRUE(listener.finish());
  expect_truth(listener, 12);
  EXPECT_EQ(events_of(listener, EventKind::repeated), 2u);
  EXPECT_THAT(message_of(listener, EventKind::repeated), HasSubstr("while the one before was being read"));
}

TEST(ValueListener, GivesNothingBehindAMissedTriggerUntilItIsTold) {
  const Plan plan = straightness_plan();
  const DrivenAxis axis(plan);
  auto samples = axis.samples();
  for (DrivenSample& s : samples)
    if (s.time_s > axis.stops()[4].begin_s && s.time_s < axis.stops()[4].end_s) s.trigger = false;
  ValueListener listener = listener_of(plan, StopSign::trigger);
  feed(listener, samples);
  EXPECT_TRUE(listener.waits_for_key());
  expect_truth(listener, 4);
  EXPECT_THAT(message_of(listener, EventKind::doubtful),
              HasSubstr("so late that target 2↓ run 1 may have been passed"));
  const double time_s = listener.press(StopKey::skip);
  expect_truth(listener, 11);
  EXPECT_TRUE(listener.complete());
  // Played again the same is said where it was meant.
  ValueListener again = listener_of(plan, StopSign::trigger);
  again.press_at(StopKey::skip, time_s);
  feed(again, samples, 13);
  ASSERT_TRUE(again.finish());
  expect_truth(again, 11);
  EXPECT_EQ(events_of(again, EventKind::doubtful), 0u);
  // Nobody says anything: those that wait are not used, and that is told.
  ValueListener silent = listener_of(plan, StopSign::trigger);
  feed(silent, samples);
  ASSERT_TRUE(silent.finish());
  expect_truth(silent, 4);
  EXPECT_THAT(silent.events().back().message, HasSubstr("the recording ended before target 2↓ run 1 and the 7 behind"));
}

TEST(ValueListener, TakesReadingsInTheOrderOfThePlan) {
  const Plan plan = straightness_plan();
  const auto readings = one_reading_each(DrivenAxis(plan), plan);
  ValueListener listener = listener_of(plan, StopSign::readings);
  listener.push(readings);
  expect_truth(listener, 12);
  EXPECT_EQ(listener.values().front().still.count, 1u);

  auto doubled = readings;
  doubled.insert(doubled.begin() + 3, {doubled[2].time_s + 0.5, doubled[2].position});
  ValueListener twice = listener_of(plan, StopSign::readings);
  twice.push(doubled);
  expect_truth(twice, 12);
  EXPECT_THAT(message_of(twice, EventKind::repeated), HasSubstr("sooner than the axis can be at target 3↓ run 1"));

  // What sends all the time is told of once for each target, with their number.
  std::vector<Sample> streamed;
  for (int k = 0; k < 100; ++k) streamed.push_back({readings[2].time_s + 0.005 * (k + 1), readings[2].position});
  auto flooded = readings;
  flooded.insert(flooded.begin() + 3, streamed.begin(), streamed.end());
  flooded.insert(flooded.end(), 3, {readings.back().time_s + 1.0, 0.0});
  ValueListener flood = listener_of(plan, StopSign::readings);
  flood.push(flooded);
  ASSERT_TRUE(flood.finish());
  expect_truth(flood, 12);
  ASSERT_EQ(flood.events().size(), 4u);
  EXPECT_THAT(flood.events()[0].message, HasSubstr("sooner than the axis can be at target 3↓ run 1"));
  EXPECT_EQ(flood.events()[1].message, "99 more in the same way: not used");
  EXPECT_EQ(flood.events()[1].time_s, streamed.back().time_s);
  EXPECT_THAT(flood.events()[2].message, HasSubstr("a reading more than the plan has approaches"));
  EXPECT_EQ(flood.events()[3].message, "2 more in the same way: not used");

  auto missing = readings;
  missing.erase(missing.begin() + 7);
  ValueListener missed = listener_of(plan, StopSign::readings);
  missed.push(missing);
  expect_truth(missed, 7);
  missed.press(StopKey::take);  // the program waited there: it is this one
  EXPECT_GT(missed.taken(), 7u);
  missed.press(StopKey::undo);
}

TEST(ValueListener, LearnsThePaceOfASlowerProgram) {
  const Plan plan = straightness_plan();
  auto readings = one_reading_each(DrivenAxis(plan), plan);
  for (Sample& s : readings) s.time_s *= 1.35;
  ValueListener listener = listener_of(plan, StopSign::readings);
  listener.push(readings);
  expect_truth(listener, 12);
  EXPECT_TRUE(listener.events().empty());
}

/// Says "take" one second after the stop, as a person does.
void lead(ValueListener& listener, const DrivenAxis& axis, std::size_t stops) {
  auto next = axis.stops().begin();
  for (const DrivenSample& s : axis.samples()) {
    const Sample one{s.time_s, s.value_um};
    listener.push({&one, 1});
    if (next - axis.stops().begin() == static_cast<std::ptrdiff_t>(stops)) continue;
    if (s.time_s < next->begin_s + 1.0) continue;
    listener.press(StopKey::take);
    ++next;
  }
}

TEST(ValueListener, IsLedByKeys) {
  const Plan plan = straightness_plan();
  const DrivenAxis axis(plan);
  ValueListener listener = listener_of(plan, StopSign::keys);
  lead(listener, axis, 12);
  ASSERT_TRUE(listener.finish());
  expect_truth(listener, 12);
  EXPECT_TRUE(listener.complete());
  ValueListener early = listener_of(plan, StopSign::keys);
  lead(early, axis, 5);
  ASSERT_TRUE(early.finish());
  expect_truth(early, 5);
  EXPECT_FALSE(early.complete());
  EXPECT_EQ(events_of(early, EventKind::incomplete), 1u);
}

struct Standing {
  ValueListener listener = listener_of(straightness_plan(), StopSign::keys);
  double time_s = 0.0;
  void stand(double level, double seconds, double slope = 0.0) {
    for (const double end_s = time_s + seconds; time_s < end_s; time_s += 0.02) {
      const Sample s{time_s,
                     level + slope * (end_s - time_s) + (static_cast<int>(time_s * 50.0) % 2 == 0 ? 0.1 : -0.1)};
      listener.push({&s, 1});
    }
  }
};

TEST(ValueListener, KeepsTheTargetDueUntilItStandsStill) {
  Standing axis;
  axis.listener.press(StopKey::take);
  EXPECT_THAT(message_of(axis.listener, EventKind::unsteady), HasSubstr("no reading has come yet"));
  axis.stand(1.0, 1.0);
  axis.listener.press(StopKey::take);
  axis.stand(1.0, 2.0, 20.0);
  EXPECT_EQ(axis.listener.taken(), 0u);
  EXPECT_THAT(axis.listener.events().back().message, HasSubstr("target 1↑ run 1: found means that range over"));
  EXPECT_THAT(axis.listener.events().back().message, HasSubstr("the target is still due"));
  axis.listener.press(StopKey::take);
  EXPECT_TRUE(axis.listener.is_reading());
  axis.listener.press(StopKey::take);  // a second time while it is read: nothing
  axis.stand(1.0, 2.0);
  EXPECT_EQ(axis.listener.taken(), 1u);
}

TEST(ValueListener, TakesBackSkipsAndAsksAgain) {
  Standing axis;
  axis.stand(1.0, 1.0);
  axis.listener.press(StopKey::take);
  axis.stand(1.0, 2.0);
  ASSERT_EQ(axis.listener.taken(), 1u);
  axis.listener.press(StopKey::take);  // at once: the axis cannot be at the next one
  EXPECT_FALSE(axis.listener.is_reading());
  EXPECT_EQ(events_of(axis.listener, EventKind::repeated), 1u);
  axis.listener.press(StopKey::take);  // it is
  EXPECT_TRUE(axis.listener.is_reading());
  axis.listener.press(StopKey::undo);
  EXPECT_FALSE(axis.listener.is_reading());
  EXPECT_EQ(axis.listener.taken(), 1u);
  axis.listener.press(StopKey::undo);
  EXPECT_EQ(axis.listener.taken(), 0u);
  EXPECT_EQ(axis.listener.due()->target, 0u);
  axis.listener.press(StopKey::undo);  // there is none
  axis.listener.press(StopKey::skip);
  EXPECT_EQ(axis.listener.due()->target, 1u);
  axis.listener.press(StopKey::take);
  axis.stand(4.0, 2.0);
  ASSERT_EQ(axis.listener.values().size(), 1u);
  EXPECT_EQ(axis.listener.values().front().approach.target, 1u);
  EXPECT_EQ(axis.listener.given().size(), 2u) << "also what was taken back";
}

TEST(ValueListener, TakesTheLastOneBackThoughATriggerMoreThanThePlanHasIsBeingRead) {
  const Plan plan = straightness_plan();
  const DrivenAxis axis(plan);
  ValueListener listener = listener_of(plan, StopSign::trigger);
  feed(listener, axis.samples());
  ASSERT_TRUE(listener.complete());
  const double end_s = axis.samples().back().time_s;
  const std::vector<DrivenSample> more = {{end_s + 10.0, 0.0, 0.0, false}, {end_s + 10.1, 0.0, 0.0, true}};
  feed(listener, more);
  ASSERT_TRUE(listener.is_reading());
  listener.press(StopKey::undo);
  EXPECT_FALSE(listener.is_reading());
  EXPECT_EQ(listener.taken(), 11u);
  EXPECT_EQ(listener.events().back().message, approach_name(*listener.due()) + " is due again");
}

TEST(ValueListener, PlaysWhatWasSaidOnEitherSideOfAGapAgainThere) {
  Standing live;
  live.stand(1.0, 1.0);
  const double before_s = live.listener.press(StopKey::take);
  live.listener.interrupt();
  const double behind_s = live.listener.press(StopKey::take);
  EXPECT_LT(before_s, behind_s);
  live.stand(1.0, 2.0);
  EXPECT_EQ(live.listener.taken(), 1u);
  EXPECT_EQ(events_of(live.listener, EventKind::unsteady), 1u);
  Standing again;
  again.listener.press_at(StopKey::take, before_s);
  again.listener.press_at(StopKey::take, behind_s);
  again.stand(1.0, 1.0);
  again.listener.interrupt();
  EXPECT_EQ(events_of(again.listener, EventKind::unsteady), 1u) << "of the window that the gap cut off";
  again.stand(1.0, 2.0);
  ASSERT_EQ(again.listener.taken(), 1u);
  EXPECT_EQ(again.listener.values().front().still.from_s, live.listener.values().front().still.from_s);
  EXPECT_EQ(again.listener.events().size(), live.listener.events().size());
}

/// A recording that is gone on with: what was said at its end counts before what is said now.
TEST(ValueListener, CountsWhatWasSaidBeforeWhatIsSaidNow) {
  Standing axis;
  axis.listener.press_at(StopKey::skip, -std::numeric_limits<double>::infinity());
  axis.listener.press(StopKey::skip);
  EXPECT_EQ(axis.listener.due()->target, 2u);
  ASSERT_EQ(axis.listener.events().size(), 2u);
  for (const CaptureEvent& event : axis.listener.events()) EXPECT_EQ(event.time_s, 0.0) << "no time has come yet";
}

TEST(ValueListener, FindsStopsByThePositionBesideTheReading) {
  const Plan plan = straightness_plan();
  const DrivenAxis axis(plan);
  for (const std::size_t piece : {std::size_t{3}, std::size_t{100000}}) {
    ValueListener listener = listener_of(plan, StopSign::position);
    feed(listener, axis.samples(), piece);
    ASSERT_TRUE(listener.finish());
    expect_truth(listener, 12);
  }
}

TEST(ValueListener, KeepsReadingsThatAreFarAheadOfThePositions) {
  const Plan plan = straightness_plan();
  const DrivenAxis axis(plan);
  ValueListener listener = listener_of(plan, StopSign::position);
  listener.push(values_of(axis.samples()));
  const auto positions = beside_of(axis.samples(), StopSign::position);
  for (std::span<const Sample> rest = positions; !rest.empty();
       rest = rest.subspan(std::min<std::size_t>(100, rest.size())))
    listener.push_beside(rest.first(std::min<std::size_t>(100, rest.size())));
  ASSERT_TRUE(listener.finish());
  expect_truth(listener, 12);
}

TEST(ValueListener, UsesNoReadingThatMovesWhileTheAxisRests) {
  const Plan plan = straightness_plan();
  const DrivenAxis axis(plan);
  auto samples = axis.samples();
  for (DrivenSample& s : samples)
    if (s.time_s > axis.stops()[3].begin_s && s.time_s < axis.stops()[3].end_s)
      s.value_um += 8.0 * (s.time_s - axis.stops()[3].begin_s);
  ValueListener listener = listener_of(plan, StopSign::position);
  feed(listener, samples);
  ASSERT_TRUE(listener.finish());
  expect_truth(listener, 11);
  EXPECT_THAT(message_of(listener, EventKind::unsteady), HasSubstr("target 3↓ run 1: found means"));
}

TEST(ValueListener, ShiftsNoneBehindATargetThatThePositionPassed) {
  const Plan plan = straightness_plan();
  const DrivenAxis axis(plan);
  std::vector<DrivenSample> samples;
  for (const DrivenSample& s : axis.samples())
    if (!(s.time_s > axis.stops()[1].begin_s + 0.1 && s.time_s < axis.stops()[1].end_s - 0.1)) samples.push_back(s);
  for (std::size_t k = 0; k < samples.size(); ++k) samples[k].time_s = 0.02 * static_cast<double>(k);
  ValueListener listener = listener_of(plan, StopSign::position);
  feed(listener, samples);
  ASSERT_TRUE(listener.finish());
  expect_truth(listener, 11);
  EXPECT_EQ(events_of(listener, EventKind::missed), 1u);
}

TEST(ValueListener, RefusesPositionsOfAnotherPlan) {
  const Plan plan = straightness_plan();
  auto samples = DrivenAxis(plan).samples();
  for (DrivenSample& s : samples) s.position_mm += 37.0;
  ValueListener listener = listener_of(plan, StopSign::position);
  feed(listener, samples);
  EXPECT_THAT(listener.finish().error().message, HasSubstr("the recording belongs to another plan"));
}

TEST(ValueListener, UsesNoWindowInWhichSamplesAreMissing) {
  Standing axis;
  axis.stand(1.0, 1.0);
  axis.listener.press(StopKey::take);
  axis.stand(1.0, 0.5);
  axis.listener.interrupt();
  EXPECT_THAT(message_of(axis.listener, EventKind::unsteady), HasSubstr("samples are missing"));
  EXPECT_EQ(axis.listener.taken(), 0u);
}

}  // namespace
}  // namespace axiometry::capture
