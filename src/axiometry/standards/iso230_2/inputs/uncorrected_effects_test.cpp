// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/inputs/uncorrected_effects.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "axiometry/model/fields.h"
#include "axiometry/standards/readings/reading_correction.h"
#include "tests/support/series.h"

namespace axiometry::iso230_2 {
namespace {

using ::testing::HasSubstr;

/// 1 m long, nothing known.
axiometry::Test bare_test() { return {{}, testing_support::make_series({0, 500, 1000}, {{1, 2, 3}}, {{2, 3, 4}}), {}}; }

axiometry::Test with(axiometry::Test test, std::initializer_list<std::pair<std::string_view, std::string_view>> items) {
  for (const auto& [key, text] : items) {
    const auto set = set_field_text(test.metadata, key, text);
    EXPECT_TRUE(set) << set.error().message;
  }
  return test;
}

const ParameterInfo& parameter(std::string_view key) { return *find_parameter(key); }

TEST(UncorrectedEffects, AreNoneWhereNothingIsKnown) { EXPECT_TRUE(uncorrected_effects(bare_test()).empty()); }

TEST(UncorrectedEffects, HoldTheExpansionOfSensorsOffTwentyDegrees) {
  const auto test = with(bare_test(), {{"sensors", "machine | bed | 25 | 25"}, {"nde.applied", "no"}});
  const auto effects = uncorrected_effects(test);
  ASSERT_EQ(effects.size(), 1u);
  EXPECT_EQ(effects[0].key, "expansion");
  EXPECT_NEAR(effects[0].on(parameter("E"))->in_native(), 60.0, 1e-9);  // 12 µm/(m·°C) · 5 °C · 1 m
  EXPECT_EQ(effects[0].on(parameter("R"))->in_native(), 0.0);           // the same in every run
  EXPECT_THAT(effects[0].reason(), HasSubstr("about 60.0 µm over the travel, is neither corrected"));
}

/// Their mean would be 20 °C.
TEST(UncorrectedEffects, AreNotCancelledBySensorsOnBothSidesOfTwentyDegrees) {
  const auto test =
      with(bare_test(),
           {{"sensors", "machine | bed | 15 | 15"}, {"sensors", "machine | head | 25 | 25"}, {"nde.applied", "no"}});
  EXPECT_NEAR(uncorrected_effects(test)[0].on(parameter("E"))->in_native(), 60.0, 1e-9);
}

TEST(UncorrectedEffects, BeginWhereTheUncertaintyOfTheTemperatureEnds) {
  const auto warm = with(bare_test(), {{"sensors", "machine | bed | 20.1 | 20.1"}, {"nde.applied", "no"}});
  EXPECT_NEAR(uncorrected_effects(warm)[0].on(parameter("E"))->in_native(), 1.2, 1e-9);
  EXPECT_EQ(uncorrected_effects(with(warm, {{"uncertainty.machine_temperature_range_C", "0.1"}})).size(), 1u);
  EXPECT_TRUE(uncorrected_effects(with(warm, {{"uncertainty.machine_temperature_range_C", "0.2"}})).empty());
}

// 4.1, A.2.4: what the correction left over.
TEST(UncorrectedEffects, HoldWhatACorrectionWithAnotherCoefficientLeaves) {
  const auto test = with(bare_test(), {{"nde.applied", "yes"},
                                       {"nde.machine_expansion_um_per_m_C", "12"},
                                       {"uncertainty.machine_expansion_um_per_m_C", "20"},
                                       {"uncertainty.machine_temperature_difference_C", "1"}});
  const auto effects = uncorrected_effects(test);
  ASSERT_EQ(effects.size(), 1u);
  EXPECT_EQ(effects[0].key, "expansion-coefficient");
  EXPECT_NEAR(effects[0].on(parameter("E"))->in_native(), 8.0, 1e-9);
  EXPECT_EQ(effects[0].on(parameter("B"))->in_native(), 0.0);
  EXPECT_TRUE(uncorrected_effects(with(test, {{"uncertainty.machine_expansion_range_um_per_m_C", "16"}})).empty())
      << "within R(α), which the uncertainty contains";
  EXPECT_EQ(uncorrected_effects(with(bare_test(), {{"sensors", "machine | bed | 25 | 25"},
                                                   {"nde.applied", "yes"},
                                                   {"nde.machine_expansion_um_per_m_C", "0"}}))
                .size(),
            1u)
      << "a correction with 0 is none";
}

TEST(UncorrectedEffects, OfATemperatureThatChangesActOnRepeatabilityToo) {
  const auto test = with(bare_test(), {{"sensors", "machine | bed | 20 | 21"}, {"nde.applied", "no"}});
  EXPECT_NEAR(uncorrected_effects(test)[0].on(parameter("R_up"))->in_native(), 12.0, 1e-9);
}

TEST(UncorrectedEffects, HoldAStatedTemperatureDifferenceToo) {
  const auto test = with(
      bare_test(), {{"uncertainty.machine_temperature_difference_C", "-2"}, {"axis.scale_expansion_um_per_m_C", "10"}});
  const auto effects = uncorrected_effects(test);
  ASSERT_EQ(effects.size(), 1u);
  EXPECT_NEAR(effects[0].on(parameter("A"))->in_native(), 20.0, 1e-9);
  EXPECT_THAT(effects[0].what, HasSubstr("nobody said whether it was corrected"));
}

TEST(UncorrectedEffects, LeaveOutWhatWasCorrected) {
  auto test = with(bare_test(), {{"sensors", "machine | bed | 25 | 25"}, {"nde.applied", "yes"}});
  EXPECT_TRUE(uncorrected_effects(test).empty());
  test = with(bare_test(), {{"sensors", "machine | bed | 25 | 25"}, {"nde.machine_expansion_um_per_m_C", "12"}});
  EXPECT_EQ(uncorrected_effects(test).size(), 1u);
  EXPECT_TRUE(uncorrected_effects(correct_readings(test, {.expansion = true}).value()).empty());
}

// 4.1: machine and equipment at one temperature, of one coefficient.
TEST(UncorrectedEffects, LeaveOutAnExpansionThatCorrectsItself) {
  const auto test = with(bare_test(), {{"sensors", "machine | bed | 25 | 25"},
                                       {"sensors", "equipment | scale | 25 | 25"},
                                       {"nde.machine_expansion_um_per_m_C", "11.5"},
                                       {"nde.equipment_expansion_um_per_m_C", "11.5"},
                                       {"nde.applied", "no"}});
  EXPECT_EQ(test.metadata.environment.sensors.size(), 2u);
  EXPECT_TRUE(uncorrected_effects(test).empty());
}

TEST(UncorrectedEffects, HoldADeadPathInAirThatChanges) {
  const auto steady = with(bare_test(), {{"instrument.dead_path_mm", "500"},
                                         {"environment.air_temperature_start_C", "20"},
                                         {"environment.air_temperature_end_C", "20"},
                                         {"environment.air_pressure_start_kPa", "101.3"},
                                         {"environment.air_humidity_start_percent", "50"},
                                         {"nde.applied", "yes"}});
  EXPECT_TRUE(uncorrected_effects(steady).empty());
  const auto warming = with(steady, {{"environment.air_temperature_end_C", "23"}});
  const auto effects = uncorrected_effects(warming);
  ASSERT_EQ(effects.size(), 1u);
  EXPECT_EQ(effects[0].key, "dead-path");
  EXPECT_NEAR(effects[0].on(parameter("B"))->in_native(), 1.4, 0.1);  // about −0.93e-6 per °C · 3 °C · 0.5 m
  EXPECT_TRUE(uncorrected_effects(correct_readings(warming, {.dead_path = true}).value()).empty());
}

TEST(UncorrectedEffects, OfADeadPathInAirThatNobodyMeasuredHaveNoKnownSize) {
  const auto effects = uncorrected_effects(with(bare_test(), {{"instrument.dead_path_mm", "500"}}));
  ASSERT_EQ(effects.size(), 1u);
  EXPECT_FALSE(effects[0].on(parameter("E")));
}

TEST(UncorrectedEffects, HoldAnIndexOfRefractionThatTheInstrumentAssumed) {
  const auto test = with(bare_test(), {{"instrument.refractive_index", "1"},
                                       {"environment.air_temperature_start_C", "20"},
                                       {"environment.air_pressure_start_kPa", "101.325"},
                                       {"environment.air_humidity_start_percent", "50"}});
  const auto effects = uncorrected_effects(test);
  ASSERT_EQ(effects.size(), 1u);
  EXPECT_NEAR(effects[0].on(parameter("M"))->in_native(), 271.4, 0.5);
}

TEST(UncorrectedEffects, HoldGainSignAndAStationThatCannotBeUsed) {
  const auto test =
      with(bare_test(),
           {{"instrument.gain", "1.001"}, {"instrument.sign_reversed", "yes"}, {"tracking.station_position", "300"}});
  const auto effects = uncorrected_effects(test);
  ASSERT_EQ(effects.size(), 3u);
  EXPECT_NEAR(effects[0].on(parameter("E"))->in_native(), 1000.0, 1e-6);
  EXPECT_EQ(effects[1].key, "sign");
  EXPECT_FALSE(effects[1].on(parameter("B")));
  EXPECT_EQ(effects[2].key, "station");
  EXPECT_EQ(effects[2].on(parameter("B"))->in_native(), 0.0);
}

}  // namespace
}  // namespace axiometry::iso230_2
