// SPDX-License-Identifier: Apache-2.0
#include "axiometry/capture/standstill.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/made_up_recording.h"

namespace axiometry::capture {
namespace {

using testing_support::MadeUpRun;

std::vector<Standstill> detect(const std::vector<Sample>& samples, const StandstillOptions& options,
                               std::size_t piece = 1'000'000) {
  StandstillDetector detector(options);
  std::vector<Standstill> found;
  const auto keep = [&](std::vector<Standstill> more) { found.insert(found.end(), more.begin(), more.end()); };
  for (std::size_t k = 0; k < samples.size(); k += piece)
    keep(detector.push(std::span(samples).subspan(k, std::min(piece, samples.size() - k))));
  keep(detector.interrupt());
  return found;
}

/// 0, 20, 45, 20, 0 with 2 s on each, and where the axis must have been found at rest.
const std::vector<MadeUpRun::Stop> path = {{0.0, 2.0}, {20.0, 2.0}, {45.0, 2.0}, {20.0, 2.0}, {0.0, 2.0}};

/// Every stop once, each within `tolerance` mm and averaged over most of the time.
void expect_path(const MadeUpRun& run, double tolerance) {
  const auto found = detect(run.record(path), standstill_options(run.plan));
  ASSERT_EQ(found.size(), path.size());
  for (std::size_t k = 0; k < path.size(); ++k) {
    EXPECT_NEAR(found[k].position.in_native(), path[k].position, tolerance) << "stop " << k;
    EXPECT_GT(found[k].used_to_s - found[k].used_from_s, 0.8) << "stop " << k;
    EXPECT_NEAR(static_cast<double>(found[k].count), (found[k].used_to_s - found[k].used_from_s) * run.rate_hz,
                2.0 + static_cast<double>(found[k].rejected));
  }
}

TEST(Standstill, IsFoundWhereTheAxisRestsWithItsMeanSpreadAndTimes) {
  MadeUpRun run;
  const auto found = detect(run.record(path), standstill_options(run.plan));
  ASSERT_EQ(found.size(), 5u);
  for (std::size_t k = 0; k < 5; ++k) {
    const Standstill& s = found[k];
    EXPECT_NEAR(s.position.in_native(), path[k].position, 5.0 * run.noise / std::sqrt(static_cast<double>(s.count)));
    EXPECT_NEAR(s.spread.in_native(), run.noise, 0.1 * run.noise);
    EXPECT_NEAR(s.end_s - s.begin_s, k == 0 ? 3.0 : 2.0, 0.3);
    EXPECT_NEAR(s.drift.in_native(), 0.0, run.noise);
    EXPECT_EQ(s.rejected, 0u);
    EXPECT_FALSE(s.cut_off);
    EXPECT_EQ(s.after_gap, k == 0);
  }
  EXPECT_EQ(found[0].arrival, std::nullopt);
  EXPECT_EQ(found[1].arrival, Direction::up);
  EXPECT_EQ(found[2].arrival, Direction::up);
  EXPECT_EQ(found[3].arrival, Direction::down);
  EXPECT_EQ(found[4].arrival, Direction::down);
  EXPECT_NEAR(found[2].lowest.in_native(), 20.0, 0.01);
  EXPECT_NEAR(found[2].highest.in_native(), 45.0, 0.01);
}

TEST(Standstill, IsFoundInNoiseOfAnySize) {
  for (double noise : {0.0, 1e-6, 1e-4, 1e-3, 1e-2}) {
    MadeUpRun run;
    run.noise = noise;
    SCOPED_TRACE(noise);
    expect_path(run, 1e-6 + 0.2 * noise);
  }
}

TEST(Standstill, IsFoundAtEveryRate) {
  for (double rate_hz : {20.0, 100.0, 1000.0, 10'000.0}) {
    MadeUpRun run;
    run.rate_hz = rate_hz;
    SCOPED_TRACE(rate_hz);
    expect_path(run, 1e-4);
  }
}

TEST(Standstill, IsFoundInReadingsCoarserThanTheirNoise) {
  for (double noise : {0.0, 0.0002, 0.0008}) {
    MadeUpRun run;
    run.quantum = 0.001;
    run.noise = noise;
    SCOPED_TRACE(noise);
    expect_path(run, 0.0006);
  }
}

TEST(Standstill, OutlastsVibration) {
  for (double hz : {3.0, 17.0, 80.0}) {
    MadeUpRun run;
    run.vibration = 0.003;
    run.vibration_hz = hz;
    SCOPED_TRACE(hz);
    expect_path(run, 0.0005);
  }
}

TEST(Standstill, LeavesOutOutliersAndCountsThem) {
  for (double height : {0.005, 1.0, 1000.0}) {
    MadeUpRun run;
    run.spike = height;
    run.spike_every = 97;
    SCOPED_TRACE(height);
    expect_path(run, 3e-5);
    for (const Standstill& s : detect(run.record(path), standstill_options(run.plan)))
      EXPECT_NEAR(static_cast<double>(s.rejected), static_cast<double>(s.count) / 96.0, 1.5);
  }
}

TEST(Standstill, TellsHowFarItCrept) {
  MadeUpRun run;
  run.creep_per_s = 0.0005;
  run.noise = 0.00005;
  const auto found = detect(run.record(path), standstill_options(run.plan));
  ASSERT_EQ(found.size(), 5u);
  for (std::size_t k = 1; k < 5; ++k)
    EXPECT_NEAR(found[k].drift.in_native(), 0.0005 * (found[k].used_to_s - found[k].used_from_s), 0.00002);
}

TEST(Standstill, ExcludesTheTailOfAStop) {
  MadeUpRun run;
  run.tail = 0.05;
  expect_path(run, 0.0001);
}

TEST(Standstill, IsTheSameHoweverTheRecordingIsCut) {
  MadeUpRun run;
  run.rate_hz = 90.0;
  run.spike = 1.0;
  run.spike_every = 131;
  const auto samples = run.record(path);
  const auto whole = detect(samples, standstill_options(run.plan));
  for (std::size_t piece : {1, 2, 3, 5, 7, 64, 1000}) {
    const auto cut = detect(samples, standstill_options(run.plan), piece);
    ASSERT_EQ(cut.size(), whole.size());
    for (std::size_t k = 0; k < cut.size(); ++k) {
      EXPECT_EQ(cut[k].position, whole[k].position);
      EXPECT_EQ(cut[k].spread, whole[k].spread);
      EXPECT_EQ(cut[k].count, whole[k].count);
      EXPECT_EQ(cut[k].begin_s, whole[k].begin_s);
      EXPECT_EQ(cut[k].arrival, whole[k].arrival);
    }
  }
}

TEST(Standstill, EndsAtAGapAndTheNextOneKnowsNoDirection) {
  MadeUpRun run;
  auto samples = run.record({{0.0, 2.0}, {20.0, 4.0}});
  // From the middle of the second standstill on everything is three seconds later.
  for (std::size_t k = samples.size() - static_cast<std::size_t>(2.3 * run.rate_hz); k < samples.size(); ++k)
    samples[k].time_s += 3.0;
  const auto found = detect(samples, standstill_options(run.plan));
  ASSERT_EQ(found.size(), 3u);
  EXPECT_TRUE(found[1].cut_off);
  EXPECT_TRUE(found[2].after_gap);
  EXPECT_EQ(found[2].arrival, std::nullopt);
  EXPECT_NEAR(found[2].position.in_native(), 20.0, 1e-4);
}

TEST(Standstill, OutlastsSingleLostSamples) {
  MadeUpRun run;
  auto samples = run.record(path);
  for (std::size_t k = samples.size() - 7; k > 10; k -= 7)
    samples.erase(samples.begin() + static_cast<std::ptrdiff_t>(k));
  EXPECT_EQ(detect(samples, standstill_options(run.plan)).size(), 5u);
}

TEST(Standstill, IsNoneWhereTheAxisOnlyTurns) {
  MadeUpRun run;
  EXPECT_EQ(detect(run.record({{0.0, 2.0}, {20.0, 0.0}, {0.0, 2.0}}), standstill_options(run.plan)).size(), 2u);
}

TEST(Standstill, IsNoneInMotionAtConstantSpeedHoweverSlow) {
  for (double speed : {0.005, 0.1, 20.0}) {  // mm/s
    MadeUpRun run;
    std::vector<Sample> samples;
    for (int k = 0; k < 20'000; ++k) samples.push_back({k / 500.0, speed * k / 500.0});
    EXPECT_TRUE(detect(samples, standstill_options(run.plan)).empty()) << speed;
  }
}

TEST(Standstill, SettlesForTheThresholdThatIsGiven) {
  MadeUpRun run;
  run.creep_per_s = 0.02;
  StandstillOptions options = standstill_options(run.plan);
  EXPECT_EQ(detect(run.record(path), options).size(), 1u);  // only before the first motion
  options.threshold = Position::native(0.05);
  EXPECT_EQ(detect(run.record(path), options).size(), 5u);
}

/// What an instrument sends that shows its last value from one time to another.
std::vector<Sample> frozen(std::vector<Sample> samples, double from_s, double to_s) {
  const auto first = std::ranges::lower_bound(samples, from_s, {}, &Sample::time_s);
  for (auto s = first; s != samples.end() && s->time_s < to_s; ++s) s->position = first->position;
  return samples;
}

std::size_t suspected(const std::vector<Standstill>& found) {
  return static_cast<std::size_t>(
      std::ranges::count_if(found, [](const Standstill& s) { return s.frozen_from_s.has_value(); }));
}

/// On the way from 0 to 20 the value stands still, and shows the axis at 20 only when it rests there.
TEST(Standstill, IsSuspectedWhereTheValueFreezesOnTheWayAndJumps) {
  MadeUpRun run;
  const auto found = detect(frozen(run.record(path), 3.7, 5.2), standstill_options(run.plan));
  ASSERT_EQ(found.size(), path.size() + 1);
  ASSERT_TRUE(found[1].frozen_from_s);
  EXPECT_NEAR(*found[1].frozen_from_s, 3.7, 0.15);
  EXPECT_NEAR(found[1].end_s, 5.2, 0.01);
  EXPECT_TRUE(found[1].cut_off);
  EXPECT_TRUE(found[2].after_gap);
  EXPECT_EQ(found[2].arrival, std::nullopt);  // it may have gone beyond 20 and come back
  EXPECT_NEAR(found[2].position.in_native(), 20.0, 1e-4);
  EXPECT_EQ(found[3].arrival, Direction::up);
  EXPECT_EQ(suspected(found), 1u);
}

TEST(Standstill, IsSuspectedWhereTheValueFreezesAtRestAndJumpsAtTheNextOne) {
  MadeUpRun run;
  const auto found = detect(frozen(run.record(path), 5.5, 9.0), standstill_options(run.plan));
  ASSERT_EQ(found.size(), path.size());
  ASSERT_TRUE(found[1].frozen_from_s);
  EXPECT_NEAR(*found[1].frozen_from_s, 5.5, 0.15);
  EXPECT_EQ(found[2].arrival, std::nullopt);
  EXPECT_EQ(suspected(found), 1u);
}

TEST(Standstill, IsSuspectedWhereverTheJumpLiesInACellAndHoweverTheRecordingIsCut) {
  MadeUpRun run;
  run.rate_hz = 90.0;
  for (int late = 0; late < 30; ++late) {
    const auto samples = frozen(run.record(path), 3.5, 5.0 + late / run.rate_hz);
    const auto whole = detect(samples, standstill_options(run.plan));
    EXPECT_EQ(suspected(whole), 1u) << late;
    for (const std::size_t piece : {1, 2, 3, 7, 50}) {
      const auto cut = detect(samples, standstill_options(run.plan), piece);
      ASSERT_EQ(cut.size(), whole.size()) << late;
      for (std::size_t k = 0; k < cut.size(); ++k) {
        EXPECT_EQ(cut[k].frozen_from_s, whole[k].frozen_from_s);
        EXPECT_EQ(cut[k].position, whole[k].position);
        EXPECT_EQ(cut[k].count, whole[k].count);
        EXPECT_EQ(cut[k].arrival, whole[k].arrival);
      }
    }
  }
}

/// At rest an instrument without noise shows one value, too.
TEST(Standstill, IsNotSuspectedWhereTheAxisLeavesAValueThatStoodStill) {
  for (const double rate_hz : {20.0, 100.0, 1000.0, 10'000.0})
    for (const double feed : {1200.0, 30'000.0}) {
      MadeUpRun run;
      run.rate_hz = rate_hz;
      run.quantum = 0.001;
      run.noise = 0.0;
      const StandstillOptions options = standstill_options(run.plan);
      run.plan.feed = feed;  // a jog is faster than the plan
      const auto found = detect(run.record(path), options);
      EXPECT_EQ(found.size(), path.size()) << rate_hz;
      EXPECT_EQ(suspected(found), 0u) << rate_hz;
    }
}

TEST(Standstill, IsNotSuspectedWhereAnInstrumentIsAskedMoreOftenThanItMeasures) {
  for (const std::size_t times : {5, 50, 200}) {
    MadeUpRun run;
    run.rate_hz = 1000.0;
    run.quantum = 0.001;
    run.noise = 0.0;
    const StandstillOptions options = standstill_options(run.plan);
    run.plan.feed = 6000.0;
    auto samples = run.record({{0.0, 0.0}, {20.0, 2.0}, {45.0, 2.0}, {20.0, 2.0}, {0.0, 2.0}});
    for (std::size_t k = 0; k < samples.size(); ++k) samples[k].position = samples[k - k % times].position;
    const auto found = detect(samples, options);
    EXPECT_EQ(suspected(found), 0u) << times;
  }
}

TEST(Standstill, IsNotSuspectedWhereSamplesAreFalse) {
  for (const double height : {5.0, -1000.0})
    for (std::size_t every = 90; every < 125; ++every) {
      MadeUpRun run;
      run.quantum = 0.001;
      run.noise = 0.0;
      auto samples = run.record(path);
      for (std::size_t k = 2000; k < samples.size(); k += every) samples[k].position += height;
      const auto found = detect(samples, standstill_options(run.plan));
      EXPECT_EQ(suspected(found), 0u) << every;
      std::size_t rejected = 0;
      for (const Standstill& s : found) rejected += s.rejected;
      EXPECT_GT(rejected, 15u) << every;
    }
}

TEST(Standstill, IsSuspectedWhereWhoHandsTheSamplesOnSawTheJump) {
  StandstillDetector detector(standstill_options(MadeUpRun{}.plan));
  std::vector<Sample> samples;
  for (int k = 0; k < 1000; ++k) samples.push_back({k / 500.0, k < 250 ? 10.0 + 0.04 * k : 20.0});
  EXPECT_TRUE(detector.push(samples).empty());
  const auto found = detector.jumped();
  ASSERT_EQ(found.size(), 1u);
  ASSERT_TRUE(found[0].frozen_from_s);
  EXPECT_NEAR(*found[0].frozen_from_s, 0.5, 0.13);
  for (int k = 0; k < 1000; ++k) samples[static_cast<std::size_t>(k)] = {3.0 + k / 500.0, 20.0 + (k % 2) * 1e-5};
  detector.push(samples);
  EXPECT_EQ(suspected(detector.jumped()), 0u);
}

}  // namespace
}  // namespace axiometry::capture
