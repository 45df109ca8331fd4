// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/monte_carlo/environment_recording.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "axiometry/numeric/random/random.h"

namespace axiometry {
namespace {

Metadata recorded(std::size_t count, double step_s, const auto& value) {
  Metadata metadata;
  for (std::size_t k = 0; k < count; ++k) metadata.gum.drift_recording.push_back(value(k));
  metadata.gum.drift_interval = Duration::s(step_s);
  return metadata;
}

TestCourse course(double duration_s) { return {{}, Duration::s(duration_s), 10, ""}; }

TEST(EnvironmentRecording, RangesOverTheTimeOfATestNotOverAllOfIt) {
  const Metadata trend = recorded(1001, 10.0, [](std::size_t k) { return 0.01 * double(k); });
  EXPECT_NEAR(recorded_environment(trend, course(1000.0))->range, 1.0, 1e-9);
  EXPECT_FALSE(recorded_environment(trend, course(1000.0))->whole);
  EXPECT_NEAR(recorded_environment(trend, course(1e6))->range, 10.0, 1e-9);
  EXPECT_TRUE(recorded_environment(trend, course(1e6))->whole);
}

TEST(EnvironmentRecording, PartsNoiseFromDrift) {
  std::vector<double> z(2000);
  numeric::fill_normal({1, 0, 0}, z);
  const Metadata metadata = recorded(2000, 1.0, [&](std::size_t k) {
    return 2.0 * std::sin(2.0 * std::numbers::pi * double(k) / 500.0) + 0.3 * z[k];
  });
  const auto found = recorded_environment(metadata, course(500.0));
  EXPECT_NEAR(found->white_sd, 0.3, 0.02);
  EXPECT_NEAR(found->covariance.front(), 2.0, 0.1);  // a²/2
  EXPECT_NEAR(found->covariance[32], -2.0, 0.4);     // half a period later, with fewer products
}

TEST(EnvironmentRecording, IsMadeOfTheSinusoidsThatItHolds) {
  const Metadata metadata = recorded(1000, 2.0, [](std::size_t k) {
    return 3.0 + 0.8 * std::sin(2.0 * std::numbers::pi * double(k) / 100.0) + 0.1 * (k % 2 == 0 ? 1.0 : -1.0);
  });
  const auto sinusoids = recorded_spectrum(metadata);
  ASSERT_EQ(sinusoids.size(), 500u);
  EXPECT_NEAR(sinusoids[9].period_s, 200.0, 1e-9);
  EXPECT_NEAR(sinusoids[9].amplitude, 0.8, 1e-9);
  EXPECT_NEAR(sinusoids.back().period_s, 4.0, 1e-9);
  double variance = 0.0;  // of the values: half the squares of the amplitudes
  for (const RecordedSinusoid& each : sinusoids) variance += 0.5 * each.amplitude * each.amplitude;
  EXPECT_NEAR(variance, 0.32 + 0.01, 1e-9);
}

TEST(EnvironmentRecording, SaysNothingOfTooLittle) {
  EXPECT_FALSE(recorded_environment({}, course(100.0)));
  EXPECT_FALSE(recorded_environment(recorded(19, 1.0, [](std::size_t k) { return double(k); }), course(100.0)));
  Metadata without_interval = recorded(100, 1.0, [](std::size_t k) { return double(k); });
  without_interval.gum.drift_interval.reset();
  EXPECT_FALSE(recorded_environment(without_interval, course(100.0)));
}

}  // namespace
}  // namespace axiometry
