// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/inputs/inputs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/series.h"

namespace axiometry::iso230_2 {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const Series& readings() {
  static const Series series = testing_support::make_series({0, 500, 1000}, {{1, 2, 3}, {2, 3, 4}}, {});
  return series;
}

UncertaintyInputs inputs_of(const Metadata& metadata) {
  auto inputs = uncertainty_inputs(metadata, readings());
  EXPECT_TRUE(inputs) << inputs.error().message;
  return inputs ? *std::move(inputs) : UncertaintyInputs{};
}

std::string refusal_of(const Metadata& metadata) {
  const auto inputs = uncertainty_inputs(metadata, readings());
  return inputs ? std::string("nothing") : inputs.error().message;
}

std::vector<std::string> keys_of(const UncertaintyInputs& inputs) {
  std::vector<std::string> keys;
  for (const auto& input : inputs.inputs) keys.push_back(input.key);
  return keys;
}

const UncertaintyInput& find(const UncertaintyInputs& inputs, std::string_view key) {
  for (const auto& input : inputs.inputs)
    if (input.key == key) return input;
  throw std::out_of_range(std::string(key));
}

double sd(const UncertaintyInputs& inputs, std::string_view key) {
  return find(inputs, key).distribution.standard_deviation().value();
}

TEST(UncertaintyInputs, AreNoneWhenNothingWasGiven) {
  Metadata m;
  EXPECT_THAT(inputs_of(m).inputs, IsEmpty());
  m.environment.sensors = {{"machine", "table", Temperature::celsius(22), Temperature::celsius(23)}};
  m.axis.scale_expansion = ExpansionCoefficient::um_per_m_K(11);
  EXPECT_THAT(inputs_of(m).inputs, IsEmpty()) << "items of clause 8.1 ask for no uncertainty";
  EXPECT_EQ(inputs_of(m).up_down_correlation, 1.0);
}

TEST(UncertaintyInputs, FollowFromTheItemsOfAnnexA) {
  const auto in = inputs_of(testing_support::table2::complete_test().metadata);
  EXPECT_THAT(keys_of(in), ElementsAre("machine_expansion", "machine_temperature", "alignment", "device",
                                       "environmental_variation"));
  EXPECT_EQ(find(in, "machine_expansion").distribution.mean(), 12.0) << "as Annex A, whatever the correction took";
  EXPECT_NEAR(sd(in, "machine_expansion"), 2.0 / std::sqrt(12.0), 1e-12);
  EXPECT_NEAR(find(in, "machine_temperature").distribution.mean(), 1.0, 1e-12);
  EXPECT_NEAR(sd(in, "machine_temperature"), 0.2 / std::sqrt(12.0), 1e-12);
  EXPECT_NEAR(sd(in, "alignment"), std::atan(1.0 / 1751.0) * 180.0 / M_PI / std::sqrt(3.0), 1e-12);
  EXPECT_NEAR(sd(in, "device"), 0.5, 1e-15);
  EXPECT_EQ(find(in, "device").unit, "µm/m");
  EXPECT_NEAR(sd(in, "environmental_variation"), 1.7 / std::sqrt(12.0), 1e-12);
}

TEST(UncertaintyInputs, AssumeWhatAnnexAAssumesAndSaySo) {
  Metadata m;
  m.uncertainty.environmental_variation = Deviation::native(1);
  m.environment.sensors = {{"Machine", "", Temperature::celsius(18), Temperature::celsius(21)}};
  const auto in = inputs_of(m);
  EXPECT_EQ(find(in, "machine_expansion").distribution.mean(), 12.0);
  EXPECT_NEAR(sd(in, "machine_expansion"), 2.0 / std::sqrt(12.0), 1e-12);
  EXPECT_EQ(find(in, "machine_temperature").distribution.mean(), -2.0) << "the largest, with its sign";
  EXPECT_EQ(sd(in, "machine_temperature"), 0.0);
  EXPECT_THAT(in.notes, ElementsAre(HasSubstr("R(θ)"), HasSubstr("12 µm/(m·°C) is assumed"),
                                    HasSubstr("2 µm/(m·°C) is assumed")));
}

TEST(UncertaintyInputs, TakeAnUnknownTemperatureForTwentyDegrees) {
  Metadata m;
  m.uncertainty.machine_temperature_range = TemperatureDifference::kelvin(1);
  m.uncertainty.machine_expansion_range = ExpansionCoefficient::um_per_m_K(3);
  const auto in = inputs_of(m);
  EXPECT_EQ(find(in, "machine_temperature").distribution.mean(), 0.0);
  EXPECT_EQ(sd(in, "machine_expansion"), 0.0);
}

/// 3 µm alone says what 3 µm + 0 µm/m · L says.
TEST(UncertaintyInputs, OfACalibrationKnowWhatTwoTargetsMayDifferBy) {
  Metadata m;
  m.uncertainty.length = Length::mm(2000);
  m.uncertainty.device_calibration = Deviation::native(3);
  m.uncertainty.device_error_range = RelativeLength::um_per_m(9);
  const auto in = inputs_of(m);
  EXPECT_EQ(sd(in, "device_constant"), 1.5);
  EXPECT_THAT(in.notes, ElementsAre(HasSubstr("the calibration was taken")));
  m.uncertainty.device_calibration_per_length = RelativeLength::um_per_m(0);
  EXPECT_EQ(sd(inputs_of(m), "device_constant"), 1.5);
  m.uncertainty.device_calibration_per_length.reset();
  m.gum.distributions = {{"device", "normal 0 0.7"}};
  EXPECT_THAT(keys_of(inputs_of(m)), ElementsAre("device")) << "the distribution takes the place of the certificate";
  m.gum.distributions.clear();
  m.uncertainty.device_calibration.reset();
  EXPECT_NEAR(sd(inputs_of(m), "device"), 9.0 / std::sqrt(12.0), 1e-12);
}

TEST(UncertaintyInputs, OfTheDevicesTemperatureNeedItsCoefficientOrItsDifference) {
  Metadata m;
  m.uncertainty.device_temperature_range = TemperatureDifference::kelvin(1);
  EXPECT_THAT(inputs_of(m).inputs, IsEmpty());
  m.uncertainty.device_expansion = ExpansionCoefficient::um_per_m_K(8);
  EXPECT_THAT(keys_of(inputs_of(m)), ElementsAre("device_expansion", "device_temperature"));
  m.uncertainty = {};
  m.uncertainty.device_temperature_difference = TemperatureDifference::kelvin(4);
  EXPECT_NEAR(sd(inputs_of(m), "device_expansion"), 2.0 / std::sqrt(12.0), 1e-12) << "A.8 without any α";
}

TEST(UncertaintyInputs, OfTheEnvironmentTakeTheAirTemperature) {
  Metadata m;
  m.gum.environment_sensitivity = ExpansionCoefficient::um_per_m_K(0.05);
  EXPECT_THAT(inputs_of(m).inputs, IsEmpty());
  m.environment.air_temperature_start = Temperature::celsius(20.6);
  m.environment.air_temperature_end = Temperature::celsius(20.9);
  EXPECT_NEAR(sd(inputs_of(m), "environment"), 0.05 * 0.75, 1e-12);
  m.gum.environment_temperature_difference = TemperatureDifference::kelvin(-2);
  EXPECT_NEAR(sd(inputs_of(m), "environment"), 0.1, 1e-12);
}

TEST(UncertaintyInputs, OnARotaryAxisAreThoseThatHaveAMeaningThere) {
  auto m = testing_support::table2::complete_test().metadata;
  m.axis.kind = AxisKind::rotary;
  m.uncertainty.device_calibration = Deviation::native(2);
  m.gum.axis_resolution = Deviation::native(0.1);
  const auto in = inputs_of(m);
  EXPECT_THAT(keys_of(in), ElementsAre("device", "axis_resolution", "environmental_variation"));
  EXPECT_EQ(find(in, "device").effect, Effect::target);
  EXPECT_EQ(find(in, "device").unit, "″");
}

TEST(UncertaintyInputs, AreReplacedByDistributionsThatAreGiven) {
  auto m = testing_support::table2::complete_test().metadata;
  m.gum.distributions = {{"machine_temperature", "triangular 0.5 2.5"}, {"device", "uniform 0 1"}};
  const auto in = inputs_of(m);
  EXPECT_THAT(keys_of(in), ElementsAre("machine_expansion", "machine_temperature", "alignment", "device",
                                       "environmental_variation"));
  EXPECT_EQ(find(in, "machine_temperature").distribution.mean(), 1.5);
  EXPECT_EQ(find(in, "machine_temperature").note, "as given");
  EXPECT_EQ(find(in, "device").distribution.mean(), 0.0);
  EXPECT_THAT(in.notes, testing::Contains(HasSubstr("used about its mean")));
}

TEST(UncertaintyInputs, AreJoinedByOnesOwn) {
  Metadata m;
  m.gum.distributions = {{"scale:optics", "normal 0 0.2"},
                         {"target: reflector", "uniform -1 1"},
                         {"run", "normal 0 0.1"},
                         {"reading:touch", "t 4 0 0.3"}};
  const auto in = inputs_of(m);
  ASSERT_THAT(keys_of(in), ElementsAre("scale:optics", "target: reflector", "run", "reading:touch"));
  EXPECT_EQ(in.inputs[0].title, "optics");
  EXPECT_EQ(in.inputs[0].unit, "µm/m");
  EXPECT_EQ(in.inputs[1].effect, Effect::target);
  EXPECT_EQ(in.inputs[1].title, "reflector");
  EXPECT_EQ(in.inputs[2].effect, Effect::run);
  EXPECT_EQ(in.inputs[3].distribution.degrees_of_freedom(), 4.0);
}

TEST(UncertaintyInputs, KeepExpansionAndTemperatureTogether) {
  Metadata m;
  m.gum.distributions = {{"machine_temperature", "uniform 1 3"}};
  auto in = inputs_of(m);
  EXPECT_NEAR(sd(in, "machine_expansion"), 2.0 / std::sqrt(12.0), 1e-12);
  m.gum.distributions = {{"machine_expansion", "uniform 10 12"}};
  in = inputs_of(m);
  EXPECT_EQ(sd(in, "machine_temperature"), 0.0);
}

TEST(UncertaintyInputs, RefuseDistributionsThatMakeNoSense) {
  const auto refusal = [](std::string input, std::string distribution, AxisKind kind = AxisKind::linear) {
    Metadata m;
    m.axis.kind = kind;
    m.gum.distributions = {{std::move(input), std::move(distribution)}};
    return refusal_of(m);
  };
  EXPECT_THAT(refusal("scale", "uniform 1 -1"), HasSubstr("\"scale\""));
  EXPECT_THAT(refusal("machine_temprature", "uniform 1 2"), HasSubstr("perhaps machine_temperature"));
  EXPECT_THAT(refusal("weather", "uniform 1 2"), HasSubstr("one of machine_expansion"));
  EXPECT_THAT(refusal("machine_temperature", "normal 2 50"), HasSubstr("at most 200"));
  EXPECT_THAT(refusal("machine_expansion", "t 2 11 1"), HasSubstr("without a standard deviation"));
  EXPECT_THAT(refusal("alignment", "uniform -91 91"), HasSubstr("at most 90"));
  EXPECT_EQ(refusal("alignment", "uniform -90 90"), "nothing");
  EXPECT_THAT(refusal("machine_temperature", "uniform 1 2", AxisKind::rotary), HasSubstr("rotary axis"));
  EXPECT_THAT(refusal("scale:ring", "uniform -1 1", AxisKind::rotary), HasSubstr("rotary axis"));
  Metadata twice;
  twice.gum.distributions = {{"scale", "normal 0 1"}, {"scale", "normal 0 2"}};
  EXPECT_THAT(refusal_of(twice), HasSubstr("found two distributions"));
  Metadata correlated;
  correlated.gum.up_down_correlation = 1.5;
  EXPECT_THAT(refusal_of(correlated), HasSubstr("from −1 to 1"));
}

TEST(UncertaintyInputs, TellHowMuchExpansionTheReadingsHold) {
  auto m = testing_support::table2::complete_test().metadata;
  m.nde.applied = false;
  m.nde.machine_expansion.reset();
  EXPECT_THAT(inputs_of(m).notes, testing::Contains(HasSubstr("about 12.00 µm")));
  m.nde.applied = true;
  EXPECT_THAT(inputs_of(m).notes, testing::Not(testing::Contains(HasSubstr("not corrected"))));
}

TEST(Measurand, IsThisTestUnlessSomethingElseIsGiven) {
  Metadata m;
  EXPECT_EQ(measurand_key(measurand_of(m)), "this-test");
  m.gum.measurand = Measurand::this_machine;
  EXPECT_EQ(measurand_key(measurand_of(m)), "this-machine");
}

}  // namespace
}  // namespace axiometry::iso230_2
