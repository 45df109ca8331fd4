// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "axiometry/simulation/presets.h"
#include "axiometry/simulation/test_support.h"

namespace axiometry::simulation {
namespace {

struct Recorded {
  std::vector<Sample> samples;
  TrueRecording truth;
};

Recorded recorded(const Request& request, const RecordingRequest& recording) {
  Recorded result;
  auto truth = record(request, recording, [&](std::span<const Sample> some) -> Result<void> {
    result.samples.insert(result.samples.end(), some.begin(), some.end());
    return {};
  });
  EXPECT_TRUE(truth) << truth.error().message;
  if (truth) result.truth = std::move(*truth);
  return result;
}

/// Mean deviation of the samples in a standstill, and how many.
std::pair<double, std::size_t> mean_in(const Recorded& r, const TrueStandstill& s, const Plan& plan) {
  double sum = 0.0;
  std::size_t count = 0;
  for (const Sample& sample : r.samples)
    if (sample.time_s >= s.begin.in_s() && sample.time_s <= s.end.in_s()) {
      sum += (sample.position - plan.targets[s.approach.target].in_native()) * deviation_per_position(plan.axis.kind);
      ++count;
    }
  return {sum / static_cast<double>(count), count};
}

TEST(Record, StandstillsWithoutNoiseAreTheReadings) {
  VirtualAxis axis;
  axis.backlash.size = um(6.0);
  axis.stick_slip = {um(1.0), um(2.0)};
  axis.cyclic = {{Position::native(10.0), um(2.0), {}}};
  axis.instrument.outlier_probability = 0.1;
  axis.instrument.outlier_size = um(10.0);
  const Request request = request_of(axis);
  const Recorded r = recorded(request, {.rate = 200.0});
  const auto simulated = simulate(request);
  ASSERT_EQ(r.truth.standstills.size(), simulated->readings.size());
  for (std::size_t k = 0; k < simulated->readings.size(); ++k) {
    const TrueReading& reading = simulated->readings[k];
    EXPECT_EQ(r.truth.standstills[k].approach, reading.approach);
    EXPECT_EQ(r.truth.standstills[k].end, reading.time);
    EXPECT_NEAR(r.truth.standstills[k].mean->in_native(), reading.deviation.in_native(), 1e-9);
    const auto [mean, count] = mean_in(r, r.truth.standstills[k], request.plan);
    EXPECT_NEAR(mean, reading.deviation.in_native() + reading.instrument.in_native(), 1e-6);
    EXPECT_NEAR(static_cast<double>(count), 200.0, 1.5);
  }
}

TEST(Record, StandstillsWithNoiseAreTheTruthWithinNoiseOverRootN) {
  VirtualAxis axis;
  axis.backlash.size = um(6.0);
  axis.instrument.noise = um(0.5);
  const Request request = request_of(axis);
  const Recorded r = recorded(request, {.rate = 500.0});
  double chi_squared = 0.0;
  for (const TrueStandstill& s : r.truth.standstills) {
    const auto [mean, count] = mean_in(r, s, request.plan);
    const double z = (mean - s.mean->in_native()) / (0.5 / std::sqrt(static_cast<double>(count)));
    EXPECT_LT(std::abs(z), 5.0);
    chi_squared += z * z;
  }
  EXPECT_NEAR(chi_squared, 24.0, 5.0 * std::sqrt(48.0));
}

TEST(Record, SlowErrorsAtTheEndOfTheDwellAreThoseOfTheReading) {
  Request request = request_of({});
  request.axis.thermal = {um(20.0), Duration::s(50.0), {}, false};
  request.axis.servo = Servo{Duration::s(0.4), 0.4};
  request.axis.hunting = {um(1.0), Duration::s(0.3)};
  request.axis.instrument.drift_per_root_hour = um(10.0);
  request.axis.instrument.air.slow = RelativeLength::um_per_m(20.0);
  request.axis.instrument.air.random = RelativeLength::um_per_m(5.0);
  request.axis.instrument.vibration = um(0.5);
  request.axis.instrument.vibration_period = Duration::s(0.7);
  request.axis.instrument.slip_probability = 0.2;
  request.axis.instrument.slip_size = um(3.0);
  const auto simulated = simulate(request);
  constexpr double rate = 20000.0;
  const Recorded r = recorded(request, {.rate = rate});
  for (const TrueReading& reading : simulated->readings) {
    const Sample& last = r.samples[static_cast<std::size_t>(std::floor(reading.time.in_s() * rate))];
    const double target = request.plan.targets[reading.approach.target].in_native();
    // Within one sample the table moves by 100 µm/s · 50 µs of ringing at most.
    EXPECT_NEAR((last.position - target) * 1000.0, reading.deviation.in_native() + reading.instrument.in_native(),
                0.02);
  }
}

TEST(Record, MovesWithinFeedAndAcceleration) {
  const Recorded r = recorded(request_of({}), {.rate = 1000.0});
  double fastest = 0.0, hardest = 0.0;
  for (std::size_t k = 2; k < r.samples.size(); ++k) {
    const double v = (r.samples[k].position - r.samples[k - 1].position) * 1000.0;
    const double before = (r.samples[k - 1].position - r.samples[k - 2].position) * 1000.0;
    fastest = std::max(fastest, std::abs(v));
    hardest = std::max(hardest, std::abs(v - before) * 1000.0);
  }
  EXPECT_NEAR(fastest, 50.0, 1e-6);
  EXPECT_NEAR(hardest, 500.0, 1e-3);
  EXPECT_EQ(r.samples.front().position, -5.0);
  EXPECT_EQ(r.samples.back().position, -5.0);
  EXPECT_EQ(r.samples[1234].time_s, 1.234);
  EXPECT_EQ(r.truth.samples, r.samples.size());
}

TEST(Record, TheServoIsTheSolutionOfItsEquation) {
  // y″ = ω² (c − y) − 2Dω y′ by Runge–Kutta of fine steps against the closed form.
  Request request = request_of({});
  request.axis.servo = Servo{Duration::s(0.2), 0.3};
  const auto timeline = Timeline::make(request.plan, request.axis, {});
  ASSERT_TRUE(timeline);
  const double omega = 2.0 * 3.14159265358979323846 / 0.2;
  double y = -5.0, v = 0.0;
  std::size_t leg = 0;
  constexpr double h = 1e-4;
  const auto command = [&](double t) {
    while (leg + 1 < timeline->legs().size() && t > timeline->legs()[leg].leave) ++leg;
    return Timeline::command(timeline->legs()[leg], Timeline::phase_at(timeline->legs()[leg], t), t);
  };
  const auto pull = [&](double c, double place, double speed) {
    return omega * omega * (c - place) - 2.0 * 0.3 * omega * speed;
  };
  double worst = 0.0;
  for (int k = 0; k < 100'000; ++k) {
    const double t = h * k, c0 = command(t);
    const Leg& now = timeline->legs()[leg];
    worst = std::max(worst, std::abs(c0 - timeline->following_error(Timeline::phase_at(now, t), t) - y));
    const double c1 = command(t + h / 2), c2 = command(t + h);
    const double a1 = pull(c0, y, v), v2 = v + h / 2 * a1;
    const double a2 = pull(c1, y + h / 2 * v, v2), v3 = v + h / 2 * a2;
    const double a3 = pull(c1, y + h / 2 * v2, v3), v4 = v + h * a3;
    const double a4 = pull(c2, y + h * v3, v4);
    y += h / 6 * (v + 2 * v2 + 2 * v3 + v4);
    v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
  }
  EXPECT_LT(worst, 1e-5);  // where a step of the integration lies across a jump of the acceleration: a·h²/…
  EXPECT_GT(timeline->legs()[3].settled, timeline->legs()[3].arrive);
}

TEST(Record, AServoThatRingsLongerThanTheDwellNeverSettles) {
  Request request = request_of({});
  request.axis.servo = Servo{Duration::s(1.0), 0.05};
  const Recorded r = recorded(request, {.rate = 100.0});
  for (const TrueStandstill& s : r.truth.standstills) {
    EXPECT_EQ(s.begin, s.end);
    EXPECT_LE(s.samples, 1u);
  }
}

Request noisy() {
  VirtualAxis axis;
  axis.instrument.noise = um(0.3);
  return request_of(axis);
}

TEST(Record, GapsAndDropOutsAreMissingSamplesAndCounted) {
  const Request request = noisy();
  const Recorded whole = recorded(request, {.rate = 100.0});
  const RecordingRequest holes{
      .rate = 100.0, .gaps = {{Duration::s(5.0), Duration::s(3.0)}}, .drop_out_probability = 0.05};
  const Recorded r = recorded(request, holes);
  EXPECT_EQ(r.truth.samples + r.truth.lost, whole.truth.samples);
  EXPECT_EQ(*count_samples(request, holes), r.samples.size());
  EXPECT_TRUE(std::ranges::none_of(r.samples, [](const Sample& s) { return s.time_s >= 5.0 && s.time_s < 8.0; }));
  const double outside = static_cast<double>(whole.truth.samples) - 300.0;
  EXPECT_NEAR(static_cast<double>(r.truth.lost) - 300.0, 0.05 * outside, 5.0 * std::sqrt(0.05 * outside));
  // What arrives is what would have arrived.
  for (const Sample& s : r.samples) {
    const auto k = static_cast<std::size_t>(std::lround(s.time_s * 100.0));
    EXPECT_EQ(s.position, whole.samples[k].position);
  }
}

TEST(Record, ADoubledApproachRestsTwiceAndAMissedOneNot) {
  Request request = request_of({});
  request.departures.doubled = {{1, Direction::up, 0}};
  request.departures.missed = {{2, Direction::up, 0}};
  const Recorded r = recorded(request, {.rate = 100.0});
  ASSERT_EQ(r.truth.standstills.size(), 24u);
  EXPECT_EQ(r.truth.standstills[2].approach, (Approach{1, Direction::up, 0}));
  EXPECT_TRUE(r.truth.standstills[2].extra);
  EXPECT_EQ(r.truth.standstills[3].approach, (Approach{3, Direction::up, 0}));
  // Between the two it goes back by the overrun.
  double lowest = 100.0;
  for (const Sample& s : r.samples)
    if (s.time_s > r.truth.standstills[1].end.in_s() && s.time_s < r.truth.standstills[2].begin.in_s())
      lowest = std::min(lowest, s.position);
  EXPECT_NEAR(lowest, 12.3 - 5.0, 0.1);
}

TEST(Record, TheSameSeedGivesTheSameBits) {
  Request request = request_of({});
  request.axis = find_preset("mixed")->make(request.plan);
  const Recorded a = recorded(request, {.rate = 300.0}), b = recorded(request, {.rate = 300.0});
  ASSERT_EQ(a.samples.size(), b.samples.size());
  for (std::size_t k = 0; k < a.samples.size(); ++k) ASSERT_EQ(a.samples[k].position, b.samples[k].position) << k;
  request.seed = 8;
  const Recorded c = recorded(request, {.rate = 300.0});
  EXPECT_NE(a.samples[100].position, c.samples[100].position);
}

std::string refused(const RecordingRequest& recording) {
  const auto r = record(request_of({}), recording, [](std::span<const Sample>) -> Result<void> { return {}; });
  return r ? "" : r.error().message;
}

TEST(Record, RefusesRatesGapsAndProbabilitiesThatCannotBe) {
  EXPECT_EQ(refused({.rate = 10.0}), "");
  EXPECT_EQ(refused({.rate = 0.0}), "found a rate of 0 samples a second, expected 0.001 to 10000000");
  EXPECT_NE(refused({.rate = std::nan("")}), "");
  EXPECT_NE(refused({.rate = 1e9}), "");
  EXPECT_NE(refused({.rate = 10.0, .gaps = {{Duration::s(-1.0), Duration::s(1.0)}}}), "");
  EXPECT_NE(refused({.rate = 10.0, .gaps = {{Duration::s(1.0), Duration::s(0.0)}}}), "");
  EXPECT_NE(refused({.rate = 10.0, .drop_out_probability = 1.0}), "");
  EXPECT_NE(refused({.rate = 10.0, .drop_out_probability = -0.1}), "");
}

TEST(Record, EndsWhenTheSinkDoes) {
  std::size_t calls = 0;
  const auto r = record(request_of({}), {.rate = 1000.0}, [&](std::span<const Sample>) -> Result<void> {
    return ++calls == 2 ? Result<void>(fail("disk full")) : Result<void>{};
  });
  EXPECT_EQ(r.error().message, "disk full");
  EXPECT_EQ(calls, 2u);
}

}  // namespace
}  // namespace axiometry::simulation
