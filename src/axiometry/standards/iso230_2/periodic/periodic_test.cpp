// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/periodic/periodic.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "axiometry/numeric/random/random.h"
#include "tests/support/series.h"
#include "tests/support/statistics_of_trials.h"

namespace axiometry::iso230_2 {
namespace {

using ::testing::Contains;
using ::testing::Field;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using testing_support::make_series;
using testing_support::RunDeviations;

constexpr double two_pi = 2.0 * std::numbers::pi;
using Truth = std::function<double(double)>;

std::vector<double> equal(std::size_t count, double step, double first = 0.0) {
  std::vector<double> targets;
  for (std::size_t k = 0; k < count; ++k) targets.push_back(first + step * static_cast<double>(k));
  return targets;
}

std::vector<double> uneven(std::size_t count, double step, std::uint64_t seed, double first = 0.0) {
  std::vector<double> shift(count);
  numeric::fill_uniform({seed, 0, 0}, shift);
  for (std::size_t k = 0; k < count; ++k) shift[k] = first + step * (static_cast<double>(k) + 0.6 * shift[k]);
  return shift;
}

/// One direction, with noise of this standard deviation.
axiometry::Test test_of(const std::vector<double>& targets, const Truth& truth, double sd = 0.0, std::uint64_t seed = 1,
                        std::size_t runs = 1) {
  std::vector<RunDeviations> up;
  for (std::size_t j = 0; j < runs; ++j) {
    std::vector<double> noise(targets.size());
    numeric::fill_normal({seed, 7, j}, noise);
    RunDeviations run;
    for (std::size_t i = 0; i < targets.size(); ++i) run.push_back(truth(targets[i]) + sd * noise[i]);
    up.push_back(std::move(run));
  }
  axiometry::Test test{{}, make_series(targets, up, {}), {}};
  test.metadata.conditions.cycle = TestCycle::unidirectional;
  return test;
}

PeriodicDirection only(const axiometry::Test& test, const PeriodicOptions& options = {}) {
  auto result = periodic_error(test, options);
  if (!result) throw std::logic_error(result.error().message);
  EXPECT_EQ(result->directions.size(), 1u);
  return result->directions.front();
}

PeriodicOptions known(double period) { return {.period = Position::native(period)}; }

TEST(Periodic, FindsPeriodAmplitudePhaseAndLineOfANoiselessScrew) {
  const auto targets = uneven(60, 1.0, 1, 100.0);
  const double first = targets.front();
  const auto d = only(test_of(
      targets, [&](double p) { return 2.0 + 0.05 * (p - first) + 1.5 * std::sin(two_pi * (p - first) / 10.0 + 0.5); }));
  EXPECT_NEAR(d.period.value.in_native(), 10.0, 1e-8);
  EXPECT_NEAR(d.harmonics.front().amplitude.value.in_native(), 1.5, 1e-9);
  EXPECT_NEAR(d.harmonics.front().phase.value.in_deg(), 0.5 * 180.0 / std::numbers::pi, 1e-6);
  EXPECT_NEAR(d.peak_to_valley.value.in_native(), 3.0, 1e-8);
  EXPECT_NEAR(d.slope_native.value, 0.05, 1e-10);
  EXPECT_NEAR(d.offset.value.in_native(), 2.0, 1e-8);
  EXPECT_NEAR(d.periods_covered, (targets.back() - first) / 10.0, 1e-8);
  EXPECT_TRUE(d.significant);
}

TEST(Periodic, ReckonsThePhaseFromTheFirstTargetAndFromZero) {
  const auto targets = equal(41, 1.0, 3.0);
  const auto d = only(test_of(targets, [](double p) { return std::sin(two_pi * p / 8.0 + 0.3); }), known(8.0));
  const double deg = 180.0 / std::numbers::pi;
  EXPECT_NEAR(d.phase_at_zero.value.in_deg(), 0.3 * deg, 1e-8);
  EXPECT_NEAR(d.harmonics.front().phase.value.in_deg(), 0.3 * deg + 360.0 * 3.0 / 8.0, 1e-8);
  for (const PeriodicPoint& p : d.points)
    EXPECT_NEAR(p.curve.in_native(), std::sin(two_pi * p.target.in_native() / 8.0 + 0.3), 1e-9);
}

TEST(Periodic, TruthLiesWithinTheStatedUncertaintyInAbout95PercentOfTrials) {
  AXIOMETRY_STATISTICS_OF_TRIALS();
  constexpr int trials = 600;
  int period = 0, amplitude = 0, phase = 0, at_zero = 0, range = 0, slope = 0;
  for (int t = 0; t < trials; ++t) {
    const auto seed = static_cast<std::uint64_t>(100 + t);
    const auto targets = uneven(45, 1.1, seed, 20.0);
    const double first = targets.front();
    const auto d = only(test_of(
        targets, [&](double p) { return 0.3 - 0.02 * p + 1.2 * std::sin(two_pi * p / 9.7 + 1.0); }, 0.4, seed));
    const double k = d.coverage_factor;
    const auto within = [&](double found, double u, double truth) { return std::abs(found - truth) <= k * u; };
    const auto angle_within = [&](const Estimate<Angle>& x, double truth_rad) {
      const double off = std::remainder(x.value.in_deg() - truth_rad * 180.0 / std::numbers::pi, 360.0);
      return std::abs(off) <= k * x.u.in_deg();
    };
    const auto& f = d.harmonics.front();
    period += within(d.period.value.in_native(), d.period.u.in_native(), 9.7);
    amplitude += within(f.amplitude.value.in_native(), f.amplitude.u.in_native(), 1.2);
    phase += angle_within(f.phase, 1.0 + two_pi * first / 9.7);
    at_zero += angle_within(d.phase_at_zero, 1.0);
    range += within(d.peak_to_valley.value.in_native(), d.peak_to_valley.u.in_native(), 2.4);
    slope += within(d.slope_native.value, d.slope_native.u, -0.02);
  }
  // 95.45 % of 600 is 573, with a standard deviation of 5; a curve that takes in a harmonic of the noise costs the
  // range a little.
  for (int count : {period, amplitude, phase, at_zero, slope}) {
    EXPECT_GE(count, 553);
    EXPECT_LE(count, 593);
  }
  EXPECT_GE(range, 545);
}

TEST(Periodic, PeakToValleyIsThatOfTheWholeCurve) {
  const auto truth = [](double p) {
    return std::sin(two_pi * p / 10.0) + 0.5 * std::sin(2.0 * two_pi * p / 10.0 + 0.4);
  };
  double high = -9.0, low = 9.0;
  for (int k = 0; k < 100000; ++k) high = std::max(high, truth(k * 1e-4)), low = std::min(low, truth(k * 1e-4));
  const auto d = only(test_of(uneven(60, 0.7, 3), truth));
  EXPECT_NEAR(d.peak_to_valley.value.in_native(), high - low, 1e-6);
  EXPECT_TRUE(d.harmonics[1].significant);
  EXPECT_NEAR(d.harmonics[1].amplitude.value.in_native(), 0.5, 1e-7);
  EXPECT_FALSE(d.harmonics[2].significant);
}

TEST(Periodic, PeakToValleyDoesNotGrowWithTheNoiseAsTheRawRangeDoes) {
  const auto truth = [](double p) { return 0.5 * std::sin(two_pi * p / 10.0); };
  double curve = 0.0, raw = 0.0;
  for (std::uint64_t t = 0; t < 50; ++t) {
    const auto d = only(test_of(uneven(200, 0.5, t), truth, 0.5, t), known(10.0));
    curve += d.peak_to_valley.value.in_native() / 50.0;
    raw += d.range_about_line.in_native() / 50.0;
  }
  EXPECT_NEAR(curve, 1.0, 0.05);
  EXPECT_GT(raw, 2.5);
}

TEST(Periodic, AveragesTheRuns) {
  const auto truth = [](double p) { return std::sin(two_pi * p / 10.0); };
  const auto d = only(test_of(equal(50, 1.0), truth, 0.3, 1, 4), known(10.0));
  EXPECT_EQ(d.runs, 4u);
  ASSERT_TRUE(d.scatter_of_means);
  EXPECT_NEAR(d.scatter_of_means->in_native(), 0.15, 0.02);
  EXPECT_NEAR(d.residual_sd.in_native(), 0.15, 0.04);
}

TEST(Periodic, TakesEachDirectionForItself) {
  const auto targets = equal(41, 1.0);
  RunDeviations up, down;
  for (double p : targets) {
    up.push_back(std::sin(two_pi * p / 10.0));
    down.push_back(5.0 + 2.0 * std::cos(two_pi * p / 10.0));
  }
  const auto result = periodic_error({{}, make_series(targets, {up}, {down}), {}}, known(10.0));
  ASSERT_TRUE(result);
  ASSERT_EQ(result->directions.size(), 2u);
  EXPECT_NEAR(result->directions[0].harmonics[0].amplitude.value.in_native(), 1.0, 1e-9);
  EXPECT_NEAR(result->directions[1].harmonics[0].amplitude.value.in_native(), 2.0, 1e-9);
  EXPECT_NEAR(result->directions[1].harmonics[0].phase.value.in_deg(), 90.0, 1e-7);
  EXPECT_THAT(result->findings, Contains(Field(&Finding::message, HasSubstr("both directions"))));
}

TEST(Periodic, RotaryAxesGiveArcsecondsAndDegrees) {
  auto test = test_of(uneven(72, 5.0, 4), [](double p) { return 3.0 * std::sin(two_pi * p / 60.0); });
  test.metadata.axis.kind = AxisKind::rotary;
  const auto d = only(test);
  EXPECT_NEAR(d.period.value.in_native(), 60.0, 1e-6);
  EXPECT_NEAR(d.peak_to_valley.value.in_native(), 6.0, 1e-6);
}

std::vector<Finding> findings_of(const axiometry::Test& test, const PeriodicOptions& options = {}) {
  return periodic_error(test, options).value().findings;
}

TEST(PeriodicFindings, AreNoneForAGoodTest) {
  const auto test = test_of(
      uneven(60, 1.0, 5), [](double p) { return std::sin(two_pi * p / 10.0); }, 0.1);
  EXPECT_THAT(findings_of(test), IsEmpty());
  EXPECT_TRUE(periodic_error(test)->conforming());
  EXPECT_EQ(periodic_error(test)->label, "");
}

TEST(PeriodicFindings, NameFewerThanTwoPeriodsAndFewTargets) {
  const auto truth = [](double p) { return std::sin(two_pi * p / 10.0); };
  const auto few = findings_of(test_of(uneven(16, 1.0, 6), truth, 0.05), known(10.0));
  EXPECT_THAT(few, Contains(Field(&Finding::message, HasSubstr("expected two or more"))));
  EXPECT_EQ(few.front().severity, Severity::departure);
  EXPECT_EQ(few.front().id, "periodic-few-periods");
  const auto coarse = findings_of(test_of(uneven(20, 3.0, 7), truth, 0.05), known(10.0));
  EXPECT_THAT(coarse, Contains(Field(&Finding::message, HasSubstr("expected four or more"))));
  EXPECT_THAT(coarse, Contains(Field(&Finding::id, "periodic-coarse-targets")));
}

TEST(PeriodicFindings, NameTheOtherPeriodThatEqualStepsCannotTellApart) {
  const auto truth = [](double p) { return std::sin(two_pi * p / 10.0); };
  const auto equal_steps = test_of(equal(41, 1.0), truth);
  EXPECT_THAT(findings_of(equal_steps),
              Contains(Field(&Finding::message, HasSubstr("a period of 10 mm and one of 1.1111 mm give the same"))));
  // It is true: the other period gives the same readings.
  const auto other = only(equal_steps, known(10.0 / 9.0));
  EXPECT_NEAR(other.harmonics.front().amplitude.value.in_native(), 1.0, 1e-9);
}

TEST(PeriodicFindings, SayWhenThereIsNothing) {
  const auto noise_only = test_of(
      uneven(60, 1.0, 8), [](double) { return 0.0; }, 1.0, 3);
  const auto result = periodic_error(noise_only);
  EXPECT_FALSE(result->directions.front().significant);
  EXPECT_THAT(result->findings, Contains(Field(&Finding::message, HasSubstr("no significant periodic error"))));
  const auto straight = periodic_error(test_of(uneven(60, 1.0, 9), [](double p) { return 0.3 * p; }));
  ASSERT_TRUE(straight);
  EXPECT_FALSE(straight->directions.front().significant);
  const auto zero = periodic_error(test_of(equal(60, 1.0), [](double) { return 0.0; }));
  ASSERT_TRUE(zero);
  EXPECT_FALSE(zero->directions.front().significant);
  EXPECT_EQ(zero->directions.front().peak_to_valley.value.in_native(), 0.0);
}

TEST(PeriodicFindings, CompareWithTheExpectedPeriod) {
  auto test = test_of(
      uneven(60, 1.0, 10), [](double p) { return std::sin(two_pi * p / 10.0); }, 0.1);
  test.metadata.axis.expected_period = Position::native(10.0);
  EXPECT_THAT(findings_of(test), IsEmpty());
  test.metadata.axis.expected_period = Position::native(12.0);
  EXPECT_THAT(findings_of(test), Contains(Field(&Finding::message, HasSubstr("expected 12 mm"))));
}

TEST(PeriodicFindings, OfNoiseTellWhereItWasSearchedAndJudgeNoTargetsByAPeakOfChance) {
  int searched = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    auto test = test_of(
        uneven(60, 1.0, seed), [](double) { return 0.0; }, 0.5);
    test.metadata.axis.expected_period = Position::native(0.5);
    if (only(test).significant) continue;
    ++searched;
    const auto findings = findings_of(test);
    EXPECT_THAT(findings, Not(Contains(Field(&Finding::severity, Severity::departure)))) << seed;
    EXPECT_THAT(findings, Contains(Field(&Finding::message, AllOf(HasSubstr("with a period from"),
                                                                  HasSubstr("0.5 mm after axis.expected_period, was "
                                                                            "not searched for")))))
        << seed;
  }
  EXPECT_GE(searched, 15);
}

TEST(PeriodicFindings, NameAFurtherPeriodAndWhoseHarmonicItMayBe) {
  const auto test = test_of(
      uneven(120, 1.0, 11),
      [](double p) { return 2.0 * std::sin(two_pi * p / 10.0) + 0.8 * std::sin(two_pi * p / 20.0); }, 0.1);
  const auto d = only(test);
  EXPECT_NEAR(d.period.value.in_native(), 10.0, 0.05);
  ASSERT_TRUE(d.further);
  EXPECT_NEAR(d.further->period.in_native(), 20.0, 0.3);
  EXPECT_THAT(findings_of(test), Contains(Field(&Finding::message, HasSubstr("it is 2 times the first"))));
}

TEST(PeriodicFindings, KeepTheLabelOfTheStepCycle) {
  auto test = test_of(
      uneven(60, 1.0, 12), [](double p) { return std::sin(two_pi * p / 10.0); }, 0.1);
  test.metadata.conditions.cycle = TestCycle::step;
  EXPECT_EQ(periodic_error(test)->label, "step cycle (Annex B), not for acceptance");
}

TEST(Periodic, HasOneChanceOfAPeakThatWasSearched) {
  const auto noise = test_of(
      uneven(41, 1.0, 3), [](double) { return 0.0; }, 1.0, 5);
  const PeriodicDirection d = only(noise);
  EXPECT_EQ(d.harmonics.front().chance, d.false_alarm);
  EXPECT_EQ(d.harmonics.front().significant, d.significant);
}

/// Values that go on from target to target by ρ, of standard deviation 1: a first-order autoregression.
axiometry::Test correlated_test(double rho, std::size_t count, std::uint64_t seed, const Truth& truth) {
  std::vector<double> noise(count);
  numeric::fill_normal({seed, 11, 0}, noise);
  for (std::size_t k = 1; k < count; ++k) noise[k] = rho * noise[k - 1] + std::sqrt(1.0 - rho * rho) * noise[k];
  const auto targets = equal(count, 1.0);
  RunDeviations run;
  for (std::size_t k = 0; k < count; ++k) run.push_back(truth(targets[k]) + noise[k]);
  axiometry::Test test{{}, make_series(targets, {run}, {}), {}};
  test.metadata.conditions.cycle = TestCycle::unidirectional;
  return test;
}

/// White noise has such a peak in fewer than 1 %; taken for white, a noise of ρ = 0.8 has one in nine of ten of these
/// tests. Counted by a simulation of its own: 2 to 4 % are left, since ρ is known from the residuals alone.
TEST(Periodic, DoesNotCallAPeakSignificantThatCorrelatedNoiseMakes) {
  AXIOMETRY_STATISTICS_OF_TRIALS();
  constexpr int trials = 200;
  int by_white = 0, significant = 0, told = 0, further = 0, at_known = 0;
  for (int t = 0; t < trials; ++t) {
    const auto test = correlated_test(0.8, 120, static_cast<std::uint64_t>(t), [](double) { return 0.0; });
    const auto d = only(test);
    by_white += d.false_alarm < 0.01;
    significant += d.significant;
    told += d.residual_correlation.told;
    further += d.further.has_value();
    at_known += only(test, known(25.0)).significant;
  }
  EXPECT_GT(by_white, trials * 3 / 4);
  EXPECT_LE(significant, trials / 20);
  EXPECT_LE(further, trials / 10);
  EXPECT_LE(at_known, trials / 10);
  EXPECT_GT(told, trials * 9 / 10);
}

TEST(Periodic, StillFindsAPeriodThatStandsOutOfCorrelatedNoise) {
  const auto test = correlated_test(0.8, 120, 1, [](double p) { return 4.0 * std::sin(two_pi * p / 10.0); });
  const auto d = only(test);
  EXPECT_TRUE(d.significant);
  EXPECT_GE(d.false_alarm_correlated, d.false_alarm);
  EXPECT_NEAR(d.period.value.in_native(), 10.0, 0.3);
  EXPECT_THAT(findings_of(test), Contains(Field(&Finding::id, "periodic-correlated-residuals")));
}

TEST(Periodic, DoesNotSayThatTheUncertaintyOfAShortPeriodWasEnlarged) {
  const auto test = correlated_test(0.8, 120, 1, [](double p) { return 9.0 * std::sin(two_pi * p / 3.0); });
  const auto found = periodic_error(test, known(3.0));
  ASSERT_TRUE(found);
  const PeriodicDirection& d = found->directions.front();
  EXPECT_EQ(d.curve_times, 1.0);
  EXPECT_GT(d.line_times, 1.5);
  const auto told = std::ranges::find(found->findings, "periodic-correlated-residuals", &Finding::id);
  ASSERT_NE(told, found->findings.end());
  EXPECT_EQ(told->message.find("curve"), std::string::npos) << told->message;
}

/// A line and a long curve among noise of ρ = 0.8.
TEST(Periodic, HasTheTruthWithinUAmongCorrelatedNoiseToo) {
  AXIOMETRY_STATISTICS_OF_TRIALS();
  constexpr int trials = 200;
  int slope = 0, amplitude = 0;
  for (int t = 0; t < trials; ++t) {
    const auto test = correlated_test(0.8, 120, static_cast<std::uint64_t>(1000 + t),
                                      [](double p) { return 0.05 * p + 3.0 * std::sin(two_pi * p / 30.0); });
    const auto d = only(test, known(30.0));
    slope += std::abs(d.slope_native.value - 0.05) <= d.coverage_factor * d.slope_native.u;
    amplitude += std::abs(d.harmonics.front().amplitude.value.in_native() - 3.0) <=
                 d.coverage_factor * d.harmonics.front().amplitude.u.in_native();
  }
  EXPECT_GE(slope, trials * 9 / 10);
  EXPECT_GE(amplitude, trials * 17 / 20) << "residuals have lost what the fit took for line and curve";
}

/// So little of it that one test does not show it beyond all chance, but that 95 % would be 82 to 85 %.
TEST(Periodic, HasTheTruthWithinUAmongLittleCorrelatedNoiseToo) {
  AXIOMETRY_STATISTICS_OF_TRIALS();
  constexpr int trials = 400;
  int slope = 0, amplitude = 0;
  for (int t = 0; t < trials; ++t) {
    const auto test = correlated_test(0.4, 60, static_cast<std::uint64_t>(2000 + t),
                                      [](double p) { return 0.05 * p + 3.0 * std::sin(two_pi * p / 14.0); });
    const auto d = only(test, known(14.0));
    slope += std::abs(d.slope_native.value - 0.05) <= d.coverage_factor * d.slope_native.u;
    amplitude += std::abs(d.harmonics.front().amplitude.value.in_native() - 3.0) <=
                 d.coverage_factor * d.harmonics.front().amplitude.u.in_native();
  }
  EXPECT_GE(slope, trials * 92 / 100);
  EXPECT_GE(amplitude, trials * 92 / 100);
}

/// The largest over ρ of (1 − ρ²)/(1 − 2ρ cos ω + ρ²) is 1/sin ω: 2 at twelve targets per period.
TEST(NoiseCorrelation, ComparesItsPowerWithThatOfWhiteNoise) {
  const NoiseCorrelation any{.lag_one = 0.9, .most = 1.0}, none{};
  EXPECT_NEAR(any.power_beside_white(12.0), 2.0, 1e-12);
  EXPECT_EQ(any.power_beside_white(3.0), 1.0);
  EXPECT_EQ(none.power_beside_white(12.0), 1.0);
  EXPECT_EQ(any.uncertain_beside_white(12.0), 1.0) << "not told";
  const NoiseCorrelation told{.lag_one = 0.9, .most = 1.0, .told = true};
  EXPECT_NEAR(told.uncertain_beside_white(12.0), std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(any.white_reduction(0.5, 12.0), 1.0 / 3.0, 1e-12);
  EXPECT_EQ(any.white_reduction(1.0, 12.0), 1.0);
  EXPECT_EQ(any.white_reduction(0.0, 12.0), 0.0);
  const NoiseCorrelation half{.lag_one = 0.3, .most = 0.5};
  EXPECT_NEAR(half.power_beside_white(1e9), 3.0, 1e-9);  // (1 + ρ)/(1 − ρ)
}

/// Readings of the second run, 4 µm off the first, are missing where `left_out` says.
axiometry::Test of_two_runs(const std::vector<double>& targets, const Truth& truth,
                            const std::function<bool(std::size_t)>& left_out) {
  std::vector<double> noise(2 * targets.size());
  numeric::fill_normal({5, 7, 0}, noise);
  RunDeviations first, second;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    first.push_back(truth(targets[i]) + 0.1 * noise[2 * i]);
    second.push_back(left_out(i) ? testing_support::none : truth(targets[i]) + 4.0 + 0.1 * noise[2 * i + 1]);
  }
  axiometry::Test test{{}, make_series(targets, {first, second}, {}), {}};
  test.metadata.conditions.cycle = TestCycle::unidirectional;
  return test;
}

TEST(Periodic, MakesNoErrorOfWhatRunsAreShiftedByWhereReadingsAreMissing) {
  const auto targets = uneven(41, 1.0, 2);
  const auto half = periodic_error(of_two_runs(
      targets, [](double p) { return 2.0 * std::sin(two_pi * p / 5.0); }, [](std::size_t i) { return i >= 20; }));
  ASSERT_TRUE(half);
  EXPECT_NEAR(half->directions[0].slope_native.value, 0.0, 0.005);
  EXPECT_NEAR(half->directions[0].period.value.in_native(), 5.0, 0.01);
  EXPECT_THAT(half->findings, Contains(Field(&Finding::message, HasSubstr("found 21 readings missing"))));
  const auto none = periodic_error(of_two_runs(
      targets, [](double) { return 0.0; }, [](std::size_t i) { return i % 10 >= 5; }));
  ASSERT_TRUE(none);
  EXPECT_FALSE(none->directions[0].significant);
}

/// Blocks of targets that the runs take in turn: a shift of 2 µm looks like a period of two blocks.
TEST(Periodic, RefusesRunsThatShareTooFewTargetsAndHoldsInUWhatFewTell) {
  const auto targets = uneven(60, 0.5, 4);
  const auto of_blocks = [&](std::size_t shared) {
    std::vector<double> noise(2 * targets.size());
    numeric::fill_normal({6, 7, 0}, noise);
    RunDeviations first, second;
    for (std::size_t i = 0; i < targets.size(); ++i) {
      const bool in_second = (i / 5) % 2 == 1;
      first.push_back(in_second && i >= shared ? testing_support::none : 0.2 * noise[2 * i]);
      second.push_back(!in_second && i >= shared ? testing_support::none : 2.0 + 0.2 * noise[2 * i + 1]);
    }
    axiometry::Test test{{}, make_series(targets, {first, second}, {}), {}};
    test.metadata.conditions.cycle = TestCycle::unidirectional;
    return test;
  };
  for (const std::size_t shared : {0u, 1u}) {
    const auto result = periodic_error(of_blocks(shared));
    ASSERT_FALSE(result) << shared;
    EXPECT_THAT(result.error().message, HasSubstr("found runs ↑ that share too few targets"));
  }
  const PeriodicDirection few = only(of_blocks(3)), many = only(of_blocks(40));
  EXPECT_FALSE(few.significant);
  EXPECT_LT(many.harmonics.front().amplitude.u, few.harmonics.front().amplitude.u);
  EXPECT_EQ(few.runs, 2u);
}

/// One period per turn, of which half a turn is searched: no chance is known of a period that nobody searched for.
TEST(Periodic, TellsThePeakAtTheEndOfTheBandWhereAPeriodBeyondFitsBetter) {
  const auto test = test_of(
      equal(37, 10.0), [](double p) { return 3.0 * std::sin(two_pi * p / 360.0); }, 0.1, 3, 3);
  const auto result = periodic_error(test);
  ASSERT_TRUE(result);
  const PeriodicDirection& d = result->directions.front();
  EXPECT_TRUE(d.beyond_band);
  EXPECT_DOUBLE_EQ(d.period.value.in_native(), 180.0);
  EXPECT_THAT(result->findings, Contains(Field(&Finding::id, "periodic-peak-at-end")));
  EXPECT_FALSE(only(test, {.longest = Position::native(400.0)}).beyond_band);
}

/// Two periods and no more, as plans make them where there is no room for three: their own end of the band.
TEST(Periodic, RefinesAPeriodThatStandsAtTheEndOfTheBand) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const auto targets = equal(25, 20.0 / 24.0);
    const auto d = only(test_of(
        targets, [](double p) { return 2.0 * std::sin(two_pi * p / 10.0); }, 0.1, seed, 3));
    EXPECT_FALSE(d.beyond_band) << seed;
    EXPECT_NEAR(d.period.value.in_native(), 10.0, 0.1) << seed;
    EXPECT_LT(d.period.u.in_native(), 0.1) << seed;
  }
}

TEST(Periodic, RefusesWhatCannotBeDone) {
  const auto truth = [](double p) { return std::sin(two_pi * p / 10.0); };
  const auto message = [](const axiometry::Test& test, const PeriodicOptions& options) {
    const auto result = periodic_error(test, options);
    return result ? std::string() : result.error().message;
  };
  const auto good = test_of(equal(41, 1.0), truth);
  EXPECT_THAT(message(good, known(-1.0)), HasSubstr("expected one above 0"));
  EXPECT_THAT(message(good, known(2.0)), HasSubstr("cannot show a period of 2 mm"));
  EXPECT_THAT(message(test_of(equal(5, 1.0), truth), {}), HasSubstr("found 5 targets"));
  EXPECT_THAT(message(good, {.shortest = Position::native(30.0)}),
              HasSubstr("expected the shortest below the longest"));
  EXPECT_THAT(message(good, {.shortest = Position::native(1e-6)}), HasSubstr("periods to search"));
  EXPECT_THAT(message(good, {.period = Position::native(3), .longest = Position::native(9)}), HasSubstr("one of them"));
}

}  // namespace
}  // namespace axiometry::iso230_2
