// SPDX-License-Identifier: Apache-2.0
#include "axiometry/simulation/simulate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "axiometry/simulation/presets.h"
#include "axiometry/simulation/test_support.h"

namespace axiometry::simulation {
namespace {

double reading(const SimulatedTest& s, std::size_t target, Direction direction, std::size_t run) {
  return s.test.series.reading(target, direction, run)->in_native();
}

/// Every reading against a formula of position, direction and run.
template <typename Formula>
void expect_readings(const Request& request, Formula formula, double tolerance = 1e-9) {
  const auto simulated = simulate(request);
  ASSERT_TRUE(simulated) << simulated.error().message;
  for (std::size_t i = 0; i < request.plan.targets.size(); ++i)
    for (const Direction d : {Direction::up, Direction::down})
      for (std::size_t j = 0; j < request.plan.runs; ++j)
        EXPECT_NEAR(reading(*simulated, i, d, j), formula(request.plan.targets[i].in_native(), d, j), tolerance)
            << i << arrow(d) << j;
}

double towards(Direction d) { return d == Direction::up ? 1.0 : -1.0; }

TEST(Simulate, APerfectAxisReadsZero) {
  expect_readings(
      request_of({}), [](double, Direction, std::size_t) { return 0.0; }, 0.0);
}

TEST(Simulate, SlopePolynomialAndTableAddUp) {
  VirtualAxis axis;
  axis.pitch.slope = RelativeLength::um_per_m(100.0);
  axis.pitch.polynomial = {um(4.0), um(-2.0)};
  axis.pitch.table = {{Position::native(10.0), um(1.0)}, {Position::native(20.0), um(3.0)}};
  expect_readings(request_of(axis), [](double p, Direction, std::size_t) {
    const double u = p / 50.7;
    return 0.1 * p + 4.0 * u - 2.0 * u * u + 1.0 + 2.0 * std::clamp((p - 10.0) / 10.0, 0.0, 1.0);
  });
}

TEST(Simulate, SlopeOfARotaryAxisIsInSecondsOfArc) {
  Request request = request_of({});
  request.plan.axis.kind = AxisKind::rotary;
  request.axis.pitch.slope = RelativeLength::um_per_m(1e6 / 3600.0);
  expect_readings(request, [](double p, Direction, std::size_t) { return p; });
}

TEST(Simulate, CyclicErrorsAreSines) {
  VirtualAxis axis;
  axis.cyclic = {{Position::native(10.0), um(2.0), Angle::deg(30.0)}, {Position::native(4.0), um(0.5), {}}};
  expect_readings(request_of(axis), [](double p, Direction, std::size_t) {
    return 2.0 * std::sin(2.0 * std::numbers::pi * (p / 10.0 + 1.0 / 12.0)) +
           0.5 * std::sin(2.0 * std::numbers::pi * p / 4.0);
  });
}

TEST(Simulate, BacklashMakesReversalOfItsSizeBelowZero) {
  VirtualAxis axis;
  axis.backlash = {um(6.0), um(4.0), Position::native(25.1), Position::native(10.0)};
  expect_readings(request_of(axis), [](double p, Direction d, std::size_t) {
    return -towards(d) * 0.5 * (6.0 + 4.0 * std::exp(-std::pow((p - 25.1) / 10.0, 2)));
  });
}

TEST(Simulate, AnOverrunShorterThanTheGapLeavesPartOfIt) {
  Request request = request_of({});
  request.axis.backlash.size = um(30.0);
  request.plan.cycle = TestCycle::step;
  request.plan.overrun = Position::native(0.01);  // 10 µm beyond, then back over 10 µm
  const auto simulated = simulate(request);
  ASSERT_TRUE(simulated);
  EXPECT_NEAR(reading(*simulated, 1, Direction::up, 0), -15.0, 1e-9);  // after a long way
  EXPECT_NEAR(reading(*simulated, 1, Direction::down, 0), -5.0, 1e-9);
  EXPECT_NEAR(reading(*simulated, 1, Direction::up, 1), -5.0, 1e-9);  // 10 µm below, and back
}

TEST(Simulate, LostMotionNeedsAWayToTurnRound) {
  VirtualAxis axis;
  axis.lost_motion = {um(4.0), Position::native(10.0)};
  const Request request = request_of(axis);
  // ↓ from 55.7 after a way ↑ of 60.7 from −5, where it stood fully wound ↓.
  const double wound = 1.0 - 2.0 * std::exp(-60.7 / 10.0);
  const auto simulated = simulate(request);
  ASSERT_TRUE(simulated);
  for (std::size_t i = 0; i < 4; ++i) {
    const double p = request.plan.targets[i].in_native();
    EXPECT_NEAR(reading(*simulated, i, Direction::up, 0), -2.0 * (1.0 - 2.0 * std::exp(-(p + 5.0) / 10.0)), 1e-9);
    EXPECT_NEAR(reading(*simulated, i, Direction::down, 0),
                -2.0 * (-1.0 + (wound + 1.0) * std::exp(-(55.7 - p) / 10.0)), 1e-9);
  }
}

TEST(Simulate, ThermalGrowthFollowsTheClockAboutItsFixedPoint) {
  VirtualAxis axis;
  axis.thermal = {um(12.0), Duration::s(60.0), Position::native(25.1), false};
  const auto simulated = simulate(request_of(axis));
  ASSERT_TRUE(simulated);
  for (const TrueReading& r : simulated->readings) {
    const double p = request_of(axis).plan.targets[r.approach.target].in_native();
    EXPECT_NEAR(r.deviation.in_native(), 12.0 * (1.0 - std::exp(-r.time.in_s() / 60.0)) * (p - 25.1) / 50.7, 1e-9);
  }
  axis.thermal.everywhere = true;
  const auto everywhere = simulate(request_of(axis));
  EXPECT_NEAR(everywhere->readings[0].deviation.in_native(),
              12.0 * (1.0 - std::exp(-everywhere->readings[0].time.in_s() / 60.0)), 1e-9);
}

TEST(Simulate, TimesAreThoseOfFeedAccelerationAndDwell) {
  const auto simulated = simulate(request_of({}));
  ASSERT_TRUE(simulated);
  // 2 s of rest, 5 mm at 50 mm/s with 500 mm/s²: 5/50 + 50/500 s, 1 s of dwell.
  EXPECT_NEAR(simulated->readings[0].time.in_s(), 2.0 + 0.2 + 1.0, 1e-12);
  EXPECT_NEAR(simulated->readings[1].time.in_s(), 3.2 + 12.3 / 50.0 + 0.1 + 1.0, 1e-12);
  ASSERT_EQ(simulated->test.times_s.size(), 24u);
  EXPECT_EQ(simulated->test.times_s[3], simulated->readings[1].time.in_s());  // ↑, target 2, run 1
}

TEST(Simulate, ResolutionOfTheAxisStopsItAtMultiples) {
  VirtualAxis axis;
  axis.resolution = um(7.0);
  expect_readings(request_of(axis),
                  [](double p, Direction, std::size_t) { return std::nearbyint(p / 0.007) * 7.0 - 1000.0 * p; });
}

TEST(Simulate, ResolutionOfTheInstrumentRoundsWhatIsShownNotWhatIsTrue) {
  VirtualAxis axis;
  axis.pitch.slope = RelativeLength::um_per_m(100.0);
  axis.instrument.resolution = um(0.7);
  const auto simulated = simulate(request_of(axis));
  ASSERT_TRUE(simulated);
  for (const TrueReading& r : simulated->readings) {
    const double p = request_of(axis).plan.targets[r.approach.target].in_native();
    EXPECT_NEAR(r.deviation.in_native(), 0.1 * p, 1e-9);
    const double shown = (1000.0 * p + r.deviation.in_native() + r.instrument.in_native()) / 0.7;
    EXPECT_NEAR(shown, std::round(shown), 1e-6);
    EXPECT_LE(std::abs(r.instrument.in_native()), 0.35 + 1e-9);
  }
}

TEST(Simulate, AWrongExpansionCoefficientIsASlopeOfReadingsOnly) {
  VirtualAxis axis;
  axis.instrument.expansion = {.machine = Temperature::celsius(24.0),
                               .machine_expansion = ExpansionCoefficient::um_per_m_K(11.5),
                               .assumed_expansion = ExpansionCoefficient::um_per_m_K(8.5)};
  expect_readings(request_of(axis), [](double p, Direction, std::size_t) { return 3.0 * 4.0 * p / 1000.0; });
  const auto simulated = simulate(request_of(axis));
  for (const TrueReading& r : simulated->readings) EXPECT_EQ(r.deviation.in_native(), 0.0);
}

TEST(Simulate, NoiseHasItsStandardDeviationAndIsNotTrue) {
  VirtualAxis axis;
  axis.instrument.noise = um(0.8);
  Request request = request_of(axis);
  request.plan.runs = 500;  // 4000 readings: the standard deviation is known to 1.1 %
  const auto simulated = simulate(request);
  ASSERT_TRUE(simulated);
  double sum = 0.0, squares = 0.0;
  for (const TrueReading& r : simulated->readings) {
    EXPECT_EQ(r.deviation.in_native(), 0.0);
    sum += r.instrument.in_native();
    squares += r.instrument.in_native() * r.instrument.in_native();
  }
  EXPECT_NEAR(sum / 4000.0, 0.0, 5.0 * 0.8 / std::sqrt(4000.0));
  EXPECT_NEAR(std::sqrt(squares / 4000.0), 0.8, 5.0 * 0.8 / std::sqrt(8000.0));
}

TEST(Simulate, WhatIsExpectedIsTheMeanAndSpreadOfManyTests) {
  VirtualAxis axis;
  axis.stick_slip = {um(2.0), um(1.0)};
  axis.hunting = {um(0.5), Duration::s(0.1)};
  axis.thermal = {um(3.0), Duration::s(100.0), {}, false};
  axis.backlash.size = um(2.0);
  constexpr std::size_t tests = 2000;
  std::vector<double> means(8), variances(8);
  for (std::size_t seed = 0; seed < tests; ++seed) {
    const auto simulated = simulate(request_of(axis, seed));
    for (std::size_t k = 0; k < 8; ++k) {
      const auto cell = simulated->test.series.cell(k % 4, static_cast<Direction>(k / 4));
      const double mean = (cell[0] + cell[1] + cell[2]) / 3.0;
      means[k] += mean / tests;
      for (const double x : cell) variances[k] += (x - mean) * (x - mean) / 2.0 / tests;
    }
  }
  const auto simulated = simulate(request_of(axis));
  ASSERT_EQ(simulated->expected.size(), 8u);
  for (std::size_t k = 0; k < 8; ++k) {
    const ExpectedCell& cell = simulated->expected[k];
    EXPECT_EQ(cell.target, k % 4);
    EXPECT_EQ(cell.runs, 3u);
    // Five standard errors of 6000 readings; of a variance with 2 degrees of freedom, a little more than normal.
    EXPECT_NEAR(means[k], cell.mean.in_native(), 5.0 * cell.spread.in_native() / std::sqrt(3.0 * tests));
    EXPECT_NEAR(std::sqrt(variances[k]) / cell.spread.in_native(), 1.0, 5.0 * 0.6 / std::sqrt(1.0 * tests));
  }
}

TEST(Simulate, PitchWalkKeepsItsCurveFromRunToRunAndHasItsSize) {
  VirtualAxis axis;
  axis.pitch.walk = PitchError::Walk{um(2.0), Position::native(0.5)};  // far below the distance of targets
  double squares = 0.0;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    const auto simulated = simulate(request_of(axis, seed));
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_EQ(reading(*simulated, i, Direction::up, 0), reading(*simulated, i, Direction::down, 2));
      squares += std::pow(reading(*simulated, i, Direction::up, 0), 2) / 2000.0;
    }
  }
  // Between nodes a straight line of two numbers with correlation e^(−1/8): on average 0.96 of the variance.
  EXPECT_NEAR(std::sqrt(squares), 2.0 * std::sqrt(0.96), 5.0 * 2.0 / std::sqrt(2.0 * 2000.0));
}

TEST(Simulate, DriftWalksWithTheRootOfTime) {
  VirtualAxis axis;
  axis.instrument.drift_per_root_hour = um(6.0);
  double squares = 0.0, hours = 0.0;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    const auto simulated = simulate(request_of(axis, seed));
    squares += std::pow(simulated->readings.back().instrument.in_native(), 2) / 1000.0;
    hours = simulated->readings.back().time.in_s() / 3600.0;
  }
  EXPECT_NEAR(std::sqrt(squares / hours), 6.0, 5.0 * 6.0 / std::sqrt(2000.0) + 6.0 / 60.0);
}

TEST(Simulate, AirActsOnTheBeamFromTheDeadPathOn) {
  VirtualAxis axis;
  axis.instrument.air.slow = RelativeLength::um_per_m(10.0);
  axis.instrument.air.random = RelativeLength::um_per_m(4.0);
  axis.instrument.air.random_time = Duration::s(0.5);  // independent from reading to reading
  axis.instrument.air.dead_path = Position::native(100.0);
  double squares = 0.0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const auto simulated = simulate(request_of(axis, seed));
    for (const TrueReading& r : simulated->readings) {
      const double beam_m = (request_of(axis).plan.targets[r.approach.target].in_native() + 100.0) / 1000.0;
      squares += std::pow(r.instrument.in_native() / beam_m, 2) / (300.0 * 24.0);
      EXPECT_EQ(r.deviation.in_native(), 0.0);
    }
  }
  // A wave of random phase, and 0.96 of the variance of the random part (as for the pitch's). The wave is nearly the
  // same in all readings of a test: 300 values of 100·sin², whose mean is known to 100/√8/√300.
  EXPECT_NEAR(squares, 50.0 + 0.96 * 16.0, 5.0 * 100.0 / std::sqrt(8.0 * 300.0));
}

TEST(Simulate, VibrationHasItsAmplitude) {
  VirtualAxis axis;
  axis.instrument.vibration = um(0.6);
  double largest = 0.0, squares = 0.0;
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    const double x = simulate(request_of(axis, seed))->readings[3].instrument.in_native();
    largest = std::max(largest, std::abs(x));
    squares += x * x / 2000.0;
  }
  EXPECT_LE(largest, 0.6);
  EXPECT_GT(largest, 0.599);
  EXPECT_NEAR(squares, 0.18, 5.0 * 0.36 / std::sqrt(8.0 * 2000.0));
}

TEST(Simulate, OutliersComeAsOftenAndAsLargeAsToldAndAreMarked) {
  VirtualAxis axis;
  axis.instrument.outlier_probability = 0.1;
  axis.instrument.outlier_size = um(20.0);
  Request request = request_of(axis);
  request.plan.runs = 500;
  std::size_t count = 0;
  const auto simulated = simulate(request);
  for (const TrueReading& r : simulated->readings) {
    const double size = std::abs(r.instrument.in_native());
    EXPECT_EQ(r.outlier, size > 0.0);
    count += r.outlier;
    EXPECT_TRUE(!r.outlier || (size >= 10.0 && size <= 30.0)) << size;
  }
  EXPECT_NEAR(static_cast<double>(count), 400.0, 5.0 * std::sqrt(4000.0 * 0.09));
}

TEST(Simulate, SlipsStay) {
  VirtualAxis axis;
  axis.instrument.slip_probability = 0.1;
  axis.instrument.slip_size = um(5.0);
  const auto simulated = simulate(request_of(axis));
  std::size_t changes = 0;
  for (std::size_t k = 1; k < simulated->readings.size(); ++k)
    changes += simulated->readings[k].instrument != simulated->readings[k - 1].instrument;
  EXPECT_GT(changes, 0u);
  EXPECT_LT(changes, 12u);
}

TEST(Simulate, TheSameSeedGivesTheSameBitsAndAnotherOneOthers) {
  for (const Preset& preset : presets()) {
    Request request = request_of({});
    request.axis = preset.make(request.plan);
    const auto first = simulate(request), second = simulate(request);
    ASSERT_TRUE(first) << preset.id << ": " << first.error().message;
    Request other = request;
    other.seed = 8;
    const auto third = simulate(other);
    std::size_t different = 0;
    for (std::size_t k = 0; k < first->readings.size(); ++k) {
      EXPECT_EQ(first->readings[k].instrument, second->readings[k].instrument) << preset.id;
      EXPECT_EQ(first->readings[k].deviation, second->readings[k].deviation) << preset.id;
      different += first->readings[k].deviation != third->readings[k].deviation;
    }
    EXPECT_EQ(different, first->readings.size()) << preset.id;
  }
}

TEST(Simulate, EveryPresetIsAnAxisOfEitherKindButForTheExpansion) {
  for (const Preset& preset : presets())
    for (const AxisKind kind : {AxisKind::linear, AxisKind::rotary}) {
      Request request = request_of({});
      request.plan.axis.kind = kind;
      request.axis = preset.make(request.plan);
      const bool expands = request.axis.instrument.expansion.has_value();
      EXPECT_EQ(simulate(request).has_value(), kind == AxisKind::linear || !expands) << preset.id;
      EXPECT_EQ(expands, preset.id == "wrong-expansion-coefficient");
      EXPECT_EQ(find_preset(preset.id), &preset);
    }
  EXPECT_EQ(find_preset("nonsense"), nullptr);
}

TEST(Simulate, TheBitsAreThoseOfEverySystem) {  // regression: of our own making
  Request request = request_of({});
  request.axis = find_preset("mixed")->make(request.plan);
  const auto simulated = simulate(request);
  EXPECT_EQ(simulated->readings[5].deviation.in_native(), 0x1.771b59277b093p+2);
  EXPECT_EQ(simulated->readings[17].deviation.in_native(), 0x1.43667a19ceb85p+0);
}

TEST(Simulate, MissedApproachesHaveNoReadingAndDoubledOnesTwo) {
  Request request = request_of({});
  request.departures.missed = {{1, Direction::up, 2}};
  request.departures.doubled = {{2, Direction::down, 0}};
  const auto simulated = simulate(request);
  ASSERT_TRUE(simulated) << simulated.error().message;
  EXPECT_EQ(simulated->test.series.reading_count(), 23u);
  EXPECT_FALSE(simulated->test.series.reading(1, Direction::up, 2));
  ASSERT_EQ(simulated->readings.size(), 24u);
  EXPECT_EQ(simulated->readings[5].approach, (Approach{2, Direction::down, 0}));
  EXPECT_EQ(simulated->readings[6].approach, (Approach{2, Direction::down, 0}));
  EXPECT_FALSE(simulated->readings[5].extra);
  EXPECT_TRUE(simulated->readings[6].extra);
}

TEST(Simulate, AReversedRunBeginsAtTheLastTarget) {
  Request request = request_of({});
  request.departures.reversed_runs = {1};
  const auto simulated = simulate(request);
  ASSERT_TRUE(simulated) << simulated.error().message;
  EXPECT_EQ(simulated->readings[7].approach, (Approach{0, Direction::down, 0}));
  EXPECT_EQ(simulated->readings[8].approach, (Approach{3, Direction::down, 1}));
  EXPECT_EQ(simulated->readings[12].approach, (Approach{0, Direction::up, 1}));
  EXPECT_EQ(simulated->readings[16].approach, (Approach{0, Direction::up, 2}));
  EXPECT_TRUE(simulated->test.series.complete());
}

std::string refused(void (*spoil)(Request&)) {
  Request request = request_of({});
  spoil(request);
  const auto simulated = simulate(request);
  return simulated ? "" : simulated.error().message;
}

TEST(Simulate, RefusesWhatNoAxisIs) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refused([](Request& r) { r.axis.instrument.noise = um(-0.1); }),
            "found a noise of -0.1, expected 0 to 1000000");
  EXPECT_NE(refused([](Request& r) { r.axis.instrument.noise = um(nan); }), "");
  EXPECT_NE(refused([](Request& r) { r.axis.backlash.size = um(1e9); }), "");
  EXPECT_NE(refused([](Request& r) { r.axis.pitch.slope = RelativeLength::um_per_m(nan); }), "");
  EXPECT_NE(refused([](Request& r) { r.axis.pitch.polynomial = {um(nan)}; }), "");
  EXPECT_NE(refused([](Request& r) { r.axis.cyclic = {{Position::native(0.0), um(1.0), {}}}; }), "");
  EXPECT_NE(refused([](Request& r) { r.axis.pitch.walk = PitchError::Walk{um(1.0), Position::native(1e-8)}; }), "");
  EXPECT_NE(refused([](Request& r) {
              r.axis.pitch.table = {{Position::native(1.0), um(0.0)}, {Position::native(1.0), um(1.0)}};
            }),
            "");
  EXPECT_NE(refused([](Request& r) { r.axis.backlash.wear = um(1000.0); }), "");
  EXPECT_NE(refused([](Request& r) { r.axis.acceleration = 0.0; }), "");
  EXPECT_NE(refused([](Request& r) { r.axis.servo = Servo{Duration::s(0.05), 1.0}; }), "");
  EXPECT_NE(refused([](Request& r) { r.axis.instrument.outlier_probability = 1.5; }), "");
  EXPECT_NE(refused([](Request& r) { r.axis.thermal.time_constant = Duration::s(0.0); }), "");
  EXPECT_NE(refused([](Request& r) { r.plan.feed = -1.0; }), "");
  EXPECT_NE(refused([](Request& r) { r.plan.targets.resize(1); }), "");
  EXPECT_EQ(refused([](Request& r) {
              r.plan.axis.kind = AxisKind::rotary;
              r.axis.instrument.expansion = decltype(r.axis.instrument.expansion)::value_type{};
            }),
            "found an expansion coefficient for a rotary axis, expected it for a linear one only");
}

TEST(Simulate, RefusesDeparturesFromWhatThePlanDoesNotHave) {
  EXPECT_EQ(refused([](Request& r) {
              r.departures.missed = {{4, Direction::up, 0}};
            }),
            "found run 1 ↑ of target 5, expected an approach that the plan has");
  EXPECT_NE(refused([](Request& r) { r.departures.doubled = {{0, Direction::up, 9}}; }), "");
  EXPECT_NE(refused([](Request& r) { r.departures.reversed_runs = {3}; }), "");
  EXPECT_NE(refused([](Request& r) { r.departures.reversed_runs = {0, 0}; }), "");
  EXPECT_NE(refused([](Request& r) {
              r.departures.missed = {{0, Direction::up, 0}};
              r.departures.doubled = {{0, Direction::up, 0}};
            }),
            "");
  EXPECT_NE(refused([](Request& r) {
              r.plan.cycle = TestCycle::step;
              r.departures.reversed_runs = {0};
            }),
            "");
  EXPECT_NE(refused([](Request& r) { r.departures.missed = approaches(r.plan); }), "");
}

}  // namespace
}  // namespace axiometry::simulation
