// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <span>

#include "axiometry/capture/dynamics/motion_course.h"
#include "axiometry/capture/dynamics/motion_spectrum.h"
#include "axiometry/capture/dynamics/uniform_motion.h"
#include "tests/support/statistics_of_trials.h"

namespace axiometry::capture {
namespace {

constexpr double turn = 2.0 * std::numbers::pi;

MotionRecord recorded(double rate, std::size_t samples, const auto& place) {
  MotionRecord record{rate, 0.0, {}};
  for (std::size_t k = 0; k < samples; ++k) record.positions.push_back(place(static_cast<double>(k) / rate));
  return record;
}

TEST(MotionCourse, MeetsConstantAccelerationAtEverySample) {
  const auto record = recorded(1000, 5000, [](double t) { return 1234.5 - 80.0 * t + 6.5 * t * t; });
  const auto course = motion_course(record, 0.021);
  ASSERT_TRUE(course);
  EXPECT_EQ(course->half_window, 10u);
  for (std::size_t k = 0; k < record.positions.size(); ++k) {
    ASSERT_NEAR(course->velocity[k], -80.0 + 13.0 * record.time_s(k), 1e-6) << k;
    ASSERT_NEAR(course->acceleration[k], 13.0, 1e-3) << k;
  }
  EXPECT_LT(course->noise, 1e-12);
}

TEST(MotionCourse, LeavesOfAVibrationWhatTheHeaderSays) {
  const double f = 40.0, window = 0.0201;
  const auto record = recorded(10'000, 20'000, [&](double t) { return std::sin(turn * f * t); });
  const auto course = motion_course(record, window);
  const double z = std::numbers::pi * f * course->window_s;
  const double share = 3.0 * (std::sin(z) - z * std::cos(z)) / (z * z * z);
  const std::span inner = std::span(course->velocity).subspan(course->half_window, 19'000);
  EXPECT_NEAR(std::ranges::max(inner), turn * f * share, 0.001 * turn * f);
}

TEST(MotionCourse, TellsTheNoiseAndWhatItMakesOfVelocities) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal(0.0, 1e-4);
  const auto record = recorded(2000, 40'000, [&](double t) { return 50.0 * t + normal(random); });
  const auto course = motion_course(record, 0.0105);
  EXPECT_NEAR(course->noise, 1e-4, 3e-6);
  double v2 = 0.0, a2 = 0.0;
  for (std::size_t k = 100; k < 39'900; ++k) {
    v2 += std::pow(course->velocity[k] - 50.0, 2) / 39'800.0;
    a2 += std::pow(course->acceleration[k], 2) / 39'800.0;
  }
  EXPECT_NEAR(std::sqrt(v2) / course->velocity_noise, 1.0, 0.05);
  EXPECT_NEAR(std::sqrt(a2) / course->acceleration_noise, 1.0, 0.05);
}

/// At rest most differences of rounded positions are 0, and so is their median: what is smaller than a step is hidden,
/// and not absent.
TEST(MotionCourse, TakesPositionsThatComeInStepsForNoBetterThanThese) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal(0.0, 2e-4);
  const auto record = recorded(1000, 10'000, [&](double t) {
    const double place = t < 7.0 ? 0.0 : 10.0 * (t - 7.0);
    return std::round((place + normal(random)) * 1e3) / 1e3;
  });
  const auto course = motion_course(record, 0.011);
  EXPECT_NEAR(course->resolution, 1e-3, 1e-9);
  EXPECT_NEAR(course->noise, 1e-3 / std::sqrt(12.0), 1e-9);
  const auto exact = recorded(1000, 1000, [](double t) { return 100.0 * t; });
  EXPECT_LT(motion_course(exact, 0.011)->noise, 1e-12) << "equal ways are no steps";
  const auto corners = recorded(1000, 4000, [](double t) {  // 1 m/s² for 0.1 s, then even, from 1 s on
    const double s = std::max(0.0, t - 1.0), begun = std::min(s, 0.1);
    return 500.0 * begun * begun + 100.0 * (s - begun);
  });
  EXPECT_LT(motion_course(corners, 0.011)->noise, 1e-12) << "nor are corners";
}

TEST(MotionCourse, RefusesWindowsThatTheRecordingCannotHold) {
  const auto record = recorded(100, 100, [](double t) { return t; });
  for (const double window : {0.0, -1.0, 0.02, 0.5, 1e300, std::nan("")}) EXPECT_FALSE(motion_course(record, window));
  EXPECT_TRUE(motion_course(record, 0.05));
  EXPECT_TRUE(motion_course(record, usual_window_s(record)));
}

TEST(MotionCourse, HasAWindowForEveryLengthOfARecording) {
  for (const double rate : {10.0, 1000.0, 50'000.0})
    for (std::size_t samples = 64; samples <= 300; ++samples) {
      const auto record = recorded(rate, samples, [](double t) { return t; });
      const auto course = motion_course(record, usual_window_s(record));
      ASSERT_TRUE(course) << samples << ": " << course.error().message;
      EXPECT_LE(4 * (2 * course->half_window + 1), samples);
    }
}

TEST(MotionCourse, TellsWindowsInDigitsThatItTakes) {
  const auto record = recorded(50'000, 1002, [](double t) { return t; });
  const auto refused = motion_course(record, 3.0);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().message,
            "found a window of 3 s, expected 0.0001 s (5 samples) to 0.00501 s (a quarter of the recording)");
  EXPECT_TRUE(motion_course(record, 0.0001));
  EXPECT_TRUE(motion_course(record, 0.00501));
}

/// There and back at 20 mm/s with half a second of standstill at the ends and a ripple of 50 nm every 2 mm.
MotionRecord there_and_back() {
  return recorded(1000, 10'000, [](double t) {
    const double way = t < 0.5   ? 0.0
                       : t < 4.5 ? 20.0 * (t - 0.5)
                       : t < 5.5 ? 80.0
                       : t < 9.5 ? 80.0 - 20.0 * (t - 5.5)
                                 : 0.0;
    return way + 50e-6 * std::sin(turn * way / 2.0);
  });
}

TEST(UniformMotion, FindsEveryMovementAndTellsHowEvenItIs) {
  const MotionRecord record = there_and_back();
  const auto course = motion_course(record, 0.011);
  const auto stretches = uniform_stretches(record, *course, {});
  ASSERT_EQ(stretches.size(), 2u);
  EXPECT_NEAR(stretches[0].velocity, 20.0, 1e-4);
  EXPECT_NEAR(stretches[1].velocity, -20.0, 1e-4);
  for (const UniformStretch& s : stretches) {
    EXPECT_NEAR(static_cast<double>(s.count()), 4000.0, 120.0);  // the ripple has a period of 100 samples
    EXPECT_NEAR(s.deviation_rms, 50e-6 / std::sqrt(2.0), 1e-6);
    EXPECT_NEAR(s.deviation_range, 100e-6, 4e-6);
  }
}

TEST(UniformMotion, LeavesOutWhereTheAxisGathersSpeedAndBrakes) {
  const auto record = recorded(1000, 6000, [](double t) {  // 10 mm/s² to 10 mm/s, 2 s of it, and down again
    return t < 1 ? 5 * t * t : t < 3 ? 5 + 10 * (t - 1) : t < 4 ? 25 + 10 * (t - 3) - 5 * (t - 3) * (t - 3) : 30.0;
  });
  const auto stretches = uniform_stretches(record, *motion_course(record, 0.011), {});
  ASSERT_EQ(stretches.size(), 1u);
  EXPECT_NEAR(record.time_s(stretches[0].first), 1.0, 0.02);
  EXPECT_NEAR(record.time_s(stretches[0].last), 3.0, 0.02);
  EXPECT_LT(stretches[0].deviation_range, 1e-4);  // 12.5 µm would be left of 50 ms of either
}

TEST(UniformMotion, FindsAFeedBesideARapid) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal(0.0, 1e-5);
  const auto record = recorded(1000, 10'500, [&](double t) {
    return (t < 10.0 ? 10.0 * t : std::max(0.0, 100.0 - 400.0 * (t - 10.0))) + normal(random);
  });
  const auto stretches = uniform_stretches(record, *motion_course(record, 0.011), {});
  ASSERT_EQ(stretches.size(), 2u);
  EXPECT_NEAR(stretches[0].velocity, 10.0, 1e-4);
  EXPECT_NEAR(stretches[1].velocity, -400.0, 1e-2);
}

TEST(UniformMotion, FindsTheMotionOnBothSidesOfAFalseSample) {
  MotionRecord record = recorded(1000, 10'000, [](double t) { return t + 1e-5 * std::sin(1e6 * t * t); });
  record.positions[5000] += 1.0;
  const auto stretches = uniform_stretches(record, *motion_course(record, 0.011), {});
  ASSERT_EQ(stretches.size(), 2u);
  for (const UniformStretch& s : stretches) {
    EXPECT_NEAR(s.velocity, 1.0, 1e-4);
    EXPECT_NEAR(static_cast<double>(s.count()), 5000.0, 60.0);
  }
}

TEST(UniformMotion, TakesNoRoundingForMotion) {
  const auto record = recorded(1000, 30'000, [](double t) { return 1000.0 / 3.0 + 400.0 * std::min(t, 1.0); });
  EXPECT_EQ(uniform_stretches(record, *motion_course(record, 0.011), {}).size(), 1u);
}

TEST(UniformMotion, FindsNoneWhereNothingMovesOrNothingIsEven) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal(0.0, 1e-4);
  const auto rest = recorded(1000, 5000, [&](double) { return normal(random); });
  EXPECT_TRUE(uniform_stretches(rest, *motion_course(rest, 0.011), {}).empty());
  const auto swing = recorded(1000, 5000, [](double t) { return std::sin(turn * t); });
  EXPECT_TRUE(uniform_stretches(swing, *motion_course(swing, 0.011), {}).empty());
  const MotionRecord flat = recorded(1000, 5000, [](double) { return 3.0; });
  EXPECT_TRUE(uniform_stretches(flat, *motion_course(flat, 0.011), {}).empty());
}

TEST(MotionSpectrum, FindsSinusoidsBetweenItsLinesWithTheirAmplitudes) {
  std::vector<double> values;
  for (int k = 0; k < 3000; ++k)
    values.push_back(7.0 + 2.0 * std::sin(turn * 31.37 * k / 1000.0) + 0.01 * std::cos(turn * 211.11 * k / 1000.0));
  const MotionSpectrum s = motion_spectrum(values, {.rate_hz = 1000.0});
  ASSERT_EQ(s.peaks.size(), 2u);  // what the window leaves beside them is no vibration
  EXPECT_NEAR(s.peaks[0].frequency_hz, 31.37, 1e-3);
  EXPECT_NEAR(s.peaks[0].amplitude, 2.0, 2e-4);
  EXPECT_NEAR(s.peaks[1].frequency_hz, 211.11, 1e-3);
  EXPECT_NEAR(s.peaks[1].amplitude, 0.01, 1e-6);
}

TEST(MotionSpectrum, TakesNoDriftForVibrations) {
  for (const double bend : {0.0, 3.0}) {
    std::vector<double> values;
    for (int k = 0; k < 4000; ++k) {
      const double t = k / 4000.0;
      values.push_back(t - bend * t * t + 0.001 * std::sin(turn * 47.3 * k / 1000.0));
    }
    const MotionSpectrum s = motion_spectrum(values, {.rate_hz = 1000.0});
    ASSERT_EQ(s.peaks.size(), 1u) << bend;
    EXPECT_NEAR(s.peaks[0].amplitude, 0.001, 1e-6);
  }
}

TEST(MotionSpectrum, TakesNeighboursWithinItsResolutionForOne) {
  std::vector<double> values;
  for (int k = 0; k < 1000; ++k)
    values.push_back(std::sin(turn * 100.0 * k / 1000.0) + std::sin(turn * 101.0 * k / 1000.0));
  const MotionSpectrum s = motion_spectrum(values, {.rate_hz = 1000.0});
  EXPECT_DOUBLE_EQ(s.resolution_hz, 2.0);
  std::size_t near = 0;
  for (const SpectrumPeak& peak : s.peaks) near += std::abs(peak.frequency_hz - 100.5) < 1.5 ? 1 : 0;
  EXPECT_EQ(near, 1u);
}

TEST(MotionSpectrum, CountsThePeaksThatItDoesNotList) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal(0.0, 1e-3);
  std::vector<double> values;
  for (int k = 0; k < 4000; ++k) {
    double x = normal(random);
    for (int i = 1; i <= 14; ++i) x += std::sin(turn * 40.0 * i * k / 2000.0);
    values.push_back(x);
  }
  const MotionSpectrum s = motion_spectrum(values, {.rate_hz = 2000.0});
  EXPECT_EQ(s.peaks.size(), 10u);
  EXPECT_EQ(s.peaks_more, 4u);
}

TEST(MotionSpectrum, TakesNothingThatADriftLeavesForAVibration) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal(0.0, 2e-6);
  std::vector<double> values;
  for (int k = 0; k < 4000; ++k) {
    const double t = k / 2000.0;
    values.push_back(250.0 * t * t - 500.0 * t + 0.05 * std::sin(turn * 5.0 * t) + normal(random));
  }
  const MotionSpectrum s = motion_spectrum(values, {.rate_hz = 2000.0});
  for (const SpectrumPeak& peak : s.peaks) EXPECT_GT(peak.frequency_hz, 6.0);
}

TEST(MotionSpectrum, CountsWhatAHigherPeakMayHaveLeft) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal(0.0, 2e-6);
  std::vector<double> values;
  for (int k = 0; k < 4000; ++k) values.push_back(std::sin(turn * 100.3 * k / 2000.0) + normal(random));
  const MotionSpectrum s = motion_spectrum(values, {.rate_hz = 2000.0});
  ASSERT_EQ(s.peaks.size(), 1u);
  EXPECT_NEAR(s.peaks[0].frequency_hz, 100.3, 1e-3);
  EXPECT_GT(s.peaks_beside, 0u);
}

TEST(MotionSpectrum, TakesNoRoundingForAVibration) {
  MotionRecord record = recorded(10'000, 20'000, [](double) { return 0.0; });
  for (std::size_t k = 0; k < 20'000; ++k) record.positions[k] = 1000.0 + 0.001 * static_cast<double>(k);
  const auto values = residuals_of(record, whole_stretch(record));
  EXPECT_FALSE(motion_spectrum(values, {.rate_hz = 10'000.0}).peaks.empty());
  EXPECT_TRUE(motion_spectrum(values, {.rate_hz = 10'000.0, .least = 4.0 * 1020.0 * 2.3e-16}).peaks.empty());
}

TEST(MotionSpectrum, OfNoiseHasNoPeaks) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal(0.0, 1.0);
  std::vector<double> values;
  for (int k = 0; k < 4096; ++k) values.push_back(normal(random));
  EXPECT_TRUE(motion_spectrum(values, {.rate_hz = 1000.0}).peaks.empty());
}

/// Of 200 recordings each: no more than 5 % have peaks. Against one floor of all frequencies every random walk had.
TEST(MotionSpectrum, TakesNoCorrelatedNoiseForVibrations) {
  AXIOMETRY_STATISTICS_OF_TRIALS();
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  for (const double kept : {0.0, 0.5, 0.9, 0.99, 1.0})
    for (const std::size_t count : {256u, 1000u, 4000u}) {
      std::size_t recordings = 0;
      for (int k = 0; k < 200; ++k) {
        MotionRecord record{1000.0, 0.0, {}};
        double x = 0.0;
        for (std::size_t i = 0; i < count; ++i) record.positions.push_back(x = kept * x + normal(random));
        const auto values = residuals_of(record, whole_stretch(record));
        recordings += motion_spectrum(values, {.rate_hz = 1000.0}).peaks.empty() ? 0 : 1;
      }
      EXPECT_LE(recordings, 10u) << kept << " of " << count;
    }
}

/// Of 200 recordings each: no more than 5 % have peaks. From medians of bands with gaps in them 90 % had.
TEST(MotionSpectrum, TakesNoNoiseThatWasAveragedOrHeldForVibrations) {
  AXIOMETRY_STATISTICS_OF_TRIALS();
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  for (const bool held : {false, true})
    for (const std::size_t over : {4u, 10u, 25u}) {
      const std::size_t count = 100 * over;  // as told: MotionSpectrum::averaging_told_s()
      std::size_t recordings = 0;
      for (int k = 0; k < 200; ++k) {
        std::vector<double> white;
        for (std::size_t i = 0; i < count + over; ++i) white.push_back(normal(random));
        MotionRecord record{1000.0, 0.0, {}};
        for (std::size_t i = 0; i < count; ++i)
          record.positions.push_back(held ? white[i / over] : std::accumulate(&white[i], &white[i + over], 0.0));
        const auto values = residuals_of(record, whole_stretch(record));
        recordings += motion_spectrum(values, {.rate_hz = 1000.0}).peaks.empty() ? 0 : 1;
      }
      EXPECT_LE(recordings, 10u) << (held ? "held" : "averaged") << " over " << over;
    }
}

TEST(MotionSpectrum, FindsAVibrationInARandomWalkWithItsFrequencyAndAmplitude) {
  std::mt19937_64 random(4);
  std::normal_distribution<double> normal;
  for (const double frequency : {20.0, 70.7, 200.0}) {
    MotionRecord record{1000.0, 0.0, {}};
    double walk = 0.0;
    for (int k = 0; k < 4000; ++k) record.positions.push_back(walk += normal(random));
    const auto noise = motion_spectrum(residuals_of(record, whole_stretch(record)), {.rate_hz = 1000.0});
    const double amplitude = 10.0 * noise.floors[static_cast<std::size_t>(frequency / noise.step_hz)];
    for (int k = 0; k < 4000; ++k)
      record.positions[static_cast<std::size_t>(k)] += amplitude * std::sin(turn * frequency * k / 1000.0);
    const auto s = motion_spectrum(residuals_of(record, whole_stretch(record)), {.rate_hz = 1000.0});
    ASSERT_EQ(s.peaks.size(), 1u) << frequency;
    EXPECT_NEAR(s.peaks[0].frequency_hz, frequency, 0.1 * s.resolution_hz);
    EXPECT_NEAR(s.peaks[0].amplitude, amplitude, 0.25 * amplitude);
  }
}

TEST(MotionSpectrum, OfNothingHasNoPeaks) {
  EXPECT_TRUE(motion_spectrum(std::vector<double>(64, 5.0), {.rate_hz = 10.0}).peaks.empty());
}

}  // namespace
}  // namespace axiometry::capture
