// SPDX-License-Identifier: Apache-2.0
#include "axiometry/capture/beam_watch.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace axiometry::capture {
namespace {

/// Every 2.4 s 30 mm on within 0.8 s, then at rest: lengths of a reflector that goes from stop to stop.
std::vector<Sample> from_stop_to_stop(double rate_hz, double duration_s) {
  std::vector<Sample> samples;
  for (int k = 0; k < static_cast<int>(rate_hz * duration_s); ++k) {
    const double t = k / rate_hz, stop = std::floor(t / 2.4);
    samples.push_back({t, 30.0 * (stop + std::min(1.0, (t - 2.4 * stop) / 0.8))});
  }
  return samples;
}

/// The same, handed over with one time for all that came since the last time.
std::vector<Sample> in_bursts(std::vector<Sample> samples, double burst_s) {
  for (Sample& s : samples) s.time_s = std::ceil(s.time_s / burst_s - 1e-9) * burst_s;
  return samples;
}

struct Heard {
  std::size_t samples = 0;
  std::vector<double> broken, missing;
};

Heard heard(const std::vector<Sample>& samples) {
  Heard h;
  BeamWatch watch({});
  const BeamWatch::Sink sink{.samples = [&](std::span<const Sample> some) { h.samples += some.size(); },
                             .broken = [&](double t) { h.broken.push_back(t); },
                             .missing = [&](double t) { h.missing.push_back(t); }};
  watch.push(samples, sink);
  watch.interrupt(sink);
  return h;
}

TEST(BeamWatch, MissesNoSamplesThatComeInBursts) {
  for (const double rate_hz : {10.0, 25.0, 1000.0})
    for (const double burst_s : {0.0, 0.2, 0.5, 1.0}) {
      SCOPED_TRACE(fmt::format("{} Hz, every {} s", rate_hz, burst_s));
      const auto samples = from_stop_to_stop(rate_hz, 60.0);
      const Heard h = heard(burst_s > 0.0 ? in_bursts(samples, burst_s) : samples);
      EXPECT_EQ(h.samples, samples.size());
      EXPECT_TRUE(h.missing.empty()) << h.missing.size();
      EXPECT_TRUE(h.broken.empty()) << h.broken.size();
    }
}

TEST(BeamWatch, MissesSamplesOfAWayAtAnyRate) {
  for (const double rate_hz : {100.0, 200.0, 1000.0}) {
    auto samples = from_stop_to_stop(rate_hz, 60.0);
    std::erase_if(samples, [](const Sample& s) { return s.time_s > 24.2 && s.time_s < 24.5; });
    const Heard h = heard(samples);
    ASSERT_EQ(h.missing.size(), 1u) << rate_hz;
    EXPECT_NEAR(h.missing[0], 24.5, 0.02);
    EXPECT_TRUE(h.broken.empty());
  }
}

TEST(BeamWatch, GetsUsedToSamplesThatComeRarely) {
  auto samples = from_stop_to_stop(1000.0, 30.0);
  for (const Sample& s : in_bursts(from_stop_to_stop(25.0, 30.0), 0.2))
    samples.push_back({s.time_s + 30.0, s.position + 375.0});
  EXPECT_LE(heard(samples).missing.size(), 1u);
}

}  // namespace
}  // namespace axiometry::capture
