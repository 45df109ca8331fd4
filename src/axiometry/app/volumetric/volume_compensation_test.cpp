// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/volumetric/volume_compensation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "axiometry/volumetric/known_machine_test_support.h"

namespace axiometry::app {
namespace {

using ::testing::HasSubstr;
using volumetric::testing::known_errors;
using volumetric::testing::known_identification;
using volumetric::testing::known_machine;

const volumetric::ErrorModel& identified_model() {
  static const auto model = known_identification(known_machine(), 100).model;
  return model;
}

VolumeCompensationRequest asked_table(std::string control, std::size_t along, std::size_t component) {
  VolumeCompensationRequest request;
  request.tool = "T1";
  request.along = along;
  request.component = component;
  request.how.control = std::move(control);
  return request;
}

/// Range of the true machine's displacement along the line, with what the control adds.
double true_range(std::size_t along, std::size_t component, const AxisCorrection* added) {
  const Vector3 first{0, 0, -500}, last{1000, 600, 0}, tool{0, 0, -150};
  std::vector<double> values;
  for (int k = 0; k <= 60; ++k) {
    Vector3 q = 0.5 * (first + last);
    q[along] = first[along] + (last[along] - first[along]) * (0.02 + 0.96 * k / 60.0);
    values.push_back(volumetric::displacement_um(known_machine(), known_errors(q), q, tool)[component] +
                     (added ? added->at(q[along], Direction::up) : 0.0));
  }
  const auto [least, most] = std::ranges::minmax(values);
  return most - least;
}

TEST(VolumeCompensation, CorrectsTheTrueMachineAlongEachAxisInEachDirection) {
  for (std::size_t along = 0; along < 3; ++along)
    for (std::size_t component = 0; component < 3; ++component) {
      SCOPED_TRACE(::testing::Message() << "XYZ"[along] << " moves, "
                                        << "XYZ"[component] << " is corrected");
      const auto made = compensate_volume(identified_model(), asked_table("siemens-cec", along, component));
      ASSERT_TRUE(made) << made.error().to_string();
      EXPECT_LT(true_range(along, component, &made->applied), 0.25 * true_range(along, component, nullptr));
      EXPECT_LT(made->line_after_um, 0.2 * made->line_before_um);
      EXPECT_EQ(made->options.output_axis.empty(), along == component);
    }
}

TEST(VolumeCompensation, NamesTheErrorsOfATable) {
  const auto of = [](std::size_t along, std::size_t component) {
    return compensate_volume(identified_model(), asked_table("siemens-cec", along, component))->errors;
  };
  EXPECT_EQ(of(0, 0), "EXX");
  EXPECT_EQ(of(0, 1), "EYX");
  EXPECT_EQ(of(1, 0), "EXY, C0Y");
  EXPECT_EQ(of(2, 0), "EXZ, B0Z");
  EXPECT_EQ(of(2, 1), "EYZ, A0Z");
}

TEST(VolumeCompensation, TellsWhatOneTableLeavesOfTheVolume) {
  const auto made = compensate_volume(identified_model(), asked_table("siemens-cec", 1, 0));
  ASSERT_TRUE(made) << made.error().to_string();
  EXPECT_GT(made->effect.after.percent_95, 0.3 * made->effect.before.percent_95) << "the other errors stay";
  const auto value = to_json(*made);
  EXPECT_EQ(value.find("output_axis")->text(), "X");
  EXPECT_EQ(value.find("volume")->find("before")->find("percent_95")->number(), made->effect.before.percent_95);
}

TEST(VolumeCompensation, WritesTheTableOfOneAxisForEveryControlThatHoldsOne) {
  for (const nc::AxisTable* control : nc::axis_table_table()) {
    if (!control->limits.linear || control->limits.points == 1) continue;
    SCOPED_TRACE(control->id);
    auto request = asked_table(std::string(control->id), 0, 0);
    if (control->uses.magnification) request.how.table.magnification = 4;
    if (control->uses.steps_per_unit) request.how.table.steps_per_unit = 800;
    if (control->limits.origin == nc::TableOrigin::last) request.how.table.reference = 1000.0;
    const auto made = compensate_volume(identified_model(), request);
    ASSERT_TRUE(made) << made.error().to_string();
    EXPECT_LT(made->line_after_um, made->line_before_um);
  }
}

TEST(VolumeCompensation, RefusesACrossTableWhereTheFormatHasNone) {
  const auto refused = compensate_volume(identified_model(), asked_table("linuxcnc", 1, 0));
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("moves X by the position of Y for LinuxCNC"));
  auto request = asked_table("linuxcnc", 0, 0);
  request.how.table.output_axis = "AX2";
  EXPECT_THAT(compensate_volume(identified_model(), request).error().message, HasSubstr("output_axis"));
}

TEST(VolumeCompensation, ExtrapolatesNothing) {
  auto request = asked_table("siemens-cec", 0, 0);
  request.how.grid = {.start = -200.0, .end = 1000.0, .step = 100.0};
  const auto refused = compensate_volume(identified_model(), request);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("measured"));
}

}  // namespace
}  // namespace axiometry::app
