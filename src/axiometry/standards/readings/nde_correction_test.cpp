// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/readings/nde_correction.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/series.h"

namespace axiometry {
namespace {

using testing::HasSubstr;
using testing_support::none;
using Measured = axiometry::Test;  // within a TEST, Test is the fixture
using testing_support::exact_um;
using testing_support::x;

std::optional<Temperature> at(double celsius) { return Temperature::celsius(celsius); }

/// A perfect machine and a perfect instrument of α = 12 and 8 µm/(m·°C): what is read when the machine has 22 °C and
/// the instrument 21 °C. Machine and metadata know their temperatures.
Measured warm() {
  const auto reading = [](double target) { return target * 1000.0 * ((1 + 24e-6) / (1 + 8e-6) - 1); };
  Measured test{{}, testing_support::make_series({0, 500, 1000}, {{0, reading(500), reading(1000)}}, {}), {}};
  test.metadata.nde.machine_expansion = ExpansionCoefficient::um_per_m_K(12);
  test.metadata.nde.equipment_expansion = ExpansionCoefficient::um_per_m_K(8);
  test.metadata.environment.sensors = {{"machine", "table", at(21.5), at(21.5)},
                                       {"machine", "column", at(22.5), at(22.5)},
                                       {"equipment", "scale", at(21), at(21)},
                                       {"air", "", at(25), at(25)}};
  return test;
}

std::string refusal_of(Measured test) {
  const auto result = correct_expansion(std::move(test));
  return result ? "nothing" : result.error().message;
}

TEST(NdeCorrection, MakesAPerfectMachinePerfectAgain) {
  const Measured before = warm();
  const Measured after = correct_expansion(before).value();
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(x(after.series, i, Direction::up, 0), 0.0, exact_um);
    EXPECT_EQ(x(*after.as_measured, i, Direction::up, 0), x(before.series, i, Direction::up, 0));
  }
  EXPECT_EQ(after.metadata.nde.applied, true);
}

TEST(NdeCorrection, TellsWhatItDid) {
  Measured test = warm();
  const auto record = correct_expansion(test)->provenance.expansion_correction.value();
  EXPECT_EQ(record.machine.sensors, 2u);
  EXPECT_NEAR(record.machine.start.in_celsius(), 22.0, 1e-12);
  EXPECT_NEAR(record.smallest.in_native(), -15.9996, 1e-3);
  EXPECT_NEAR(record.largest.in_native(), 0.0, exact_um);
  ASSERT_TRUE(record.equipment);
  EXPECT_EQ(record.equipment->expansion.in_um_per_m_K(), 8.0);
  EXPECT_EQ(record.datum.in_native(), 0.0);
}

/// Zero readings of 11.5 µm/m·°C · ΔT; what is added then tells the time at which a reading counts.
Measured clocked(TestCycle cycle, bool both) {
  std::vector<testing_support::RunDeviations> runs = {{0, 0, 0}, {0, none, 0}};
  Measured test{{}, testing_support::make_series({1000, 2000, 3000}, runs, both ? runs : decltype(runs){}), {}};
  test.metadata.conditions.cycle = cycle;
  test.metadata.nde.datum = Position::native(0);
  test.metadata.axis.scale_expansion = ExpansionCoefficient::um_per_m_K(10);
  test.metadata.environment.sensors = {{"machine", "", at(20), at(21)}};
  return test;
}

/// The time, from 0 to 1, that the correction of a reading stands for.
double time_of(const Measured& test, std::size_t i, Direction d, std::size_t run) {
  const double relative = -x(test.series, i, d, run) / (test.series.targets()[i].in_native() * 1000.0);
  return relative / (1.0 - relative) / 10e-6;
}

TEST(NdeCorrection, FollowsTheCourseOfTheStandardCycle) {
  const Measured test = correct_expansion(clocked(TestCycle::standard, true)).value();
  EXPECT_NEAR(time_of(test, 0, Direction::up, 0), 0.0, exact_um);
  EXPECT_NEAR(time_of(test, 2, Direction::up, 0), 2.0 / 11.0, exact_um);
  EXPECT_NEAR(time_of(test, 2, Direction::down, 0), 3.0 / 11.0, exact_um);
  EXPECT_NEAR(time_of(test, 0, Direction::down, 0), 5.0 / 11.0, exact_um);
  EXPECT_NEAR(time_of(test, 2, Direction::up, 1), 8.0 / 11.0, exact_um) << "a missing reading keeps its time";
  EXPECT_NEAR(time_of(test, 0, Direction::down, 1), 1.0, exact_um);
  EXPECT_FALSE(test.series.reading(1, Direction::up, 1));
}

TEST(NdeCorrection, FollowsTheCourseOfOtherCycles) {
  const Measured step = correct_expansion(clocked(TestCycle::step, true)).value();
  EXPECT_NEAR(time_of(step, 0, Direction::down, 0), 1.0 / 11.0, exact_um);
  EXPECT_NEAR(time_of(step, 0, Direction::down, 1), 3.0 / 11.0, exact_um);
  EXPECT_NEAR(time_of(step, 1, Direction::up, 0), 4.0 / 11.0, exact_um);
  const Measured one_way = correct_expansion(clocked(TestCycle::unidirectional, false)).value();
  EXPECT_NEAR(time_of(one_way, 0, Direction::up, 1), 3.0 / 5.0, exact_um);
}

TEST(NdeCorrection, TakesTheFirstTargetForTheDatumAndASingleReadingForBoth) {
  Measured test = clocked(TestCycle::standard, true);
  test.metadata.nde.datum.reset();
  test.metadata.environment.sensors = {{"Machine", "", {}, at(21)}};
  test = correct_expansion(test).value();
  EXPECT_NEAR(x(test.series, 0, Direction::up, 0), 0.0, exact_um);
  EXPECT_NEAR(x(test.series, 1, Direction::up, 0), -10.0 / (1 + 10e-6), exact_um);
}

TEST(NdeCorrection, IsRefusedWhereSomethingIsMissingOrItWasDone) {
  Measured test = warm();
  test.metadata.nde.applied = true;
  EXPECT_THAT(refusal_of(test), HasSubstr("nde.applied = yes"));
  test = warm();
  test.metadata.axis.kind = AxisKind::rotary;
  EXPECT_THAT(refusal_of(test), HasSubstr("rotary"));
  test = warm();
  test.metadata.nde.machine_expansion.reset();
  EXPECT_THAT(refusal_of(test), HasSubstr("axis.scale_expansion_um_per_m_C"));
  test = warm();
  test.metadata.environment.sensors.erase(test.metadata.environment.sensors.begin(),
                                          test.metadata.environment.sensors.begin() + 2);
  EXPECT_THAT(refusal_of(test), HasSubstr("role machine"));
  test = warm();
  test.metadata.nde.equipment_expansion.reset();
  EXPECT_THAT(refusal_of(test), HasSubstr("nde.equipment_expansion_um_per_m_C"));
  test = warm();
  test.metadata.environment.sensors.resize(2);
  EXPECT_THAT(refusal_of(test), HasSubstr("role equipment"));
  test.metadata.nde.equipment_expansion = ExpansionCoefficient::um_per_m_K(0);
  EXPECT_EQ(refusal_of(test), "nothing") << "an interferometer";
}

TEST(NdeCorrection, IsNotAppliedTwice) {
  EXPECT_THAT(refusal_of(correct_expansion(warm()).value()), HasSubstr("nde.applied = yes"));
}

}  // namespace
}  // namespace axiometry
