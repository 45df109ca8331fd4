// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "axiometry/app/volumetric/tables/volume_compensation.h"
#include "axiometry/volumetric/known_machine_test_support.h"

namespace axiometry::app {
namespace {

using volumetric::ErrorModel;
using volumetric::testing::known_machine;

/// EXX of 40 µm/m that is 3 µm more upwards and less downwards; of one error nothing tells the directions apart.
ErrorModel model_without_directions_of(volumetric::ErrorMotion untold) {
  const auto machine = known_machine();
  const auto coefficients = *volumetric::Coefficients::make(volumetric::CurveKind::nodes, machine.travel, {1, 1, 1},
                                                            volumetric::Reversal::constant);
  const std::size_t n = coefficients.raw();
  std::vector<double> values(n, 0.0), direction(n, 0.0);
  values[coefficients.curve(0)] = -20.0;
  values[coefficients.curve(0) + volumetric::motion_count] = 20.0;
  values[coefficients.half(0)] = 3.0;
  direction[coefficients.half(untold.axis) + untold.motion] = 1.0;
  return ErrorModel({machine, coefficients, values, std::vector<double>(n * n, 0.0), {direction}, machine.travel});
}

VolumeCompensation table_along_x(const ErrorModel& model) {
  VolumeCompensationRequest request;
  request.tool = "T1";
  request.how.control = "siemens-cec";
  return *compensate_volume(model, request);
}

TEST(VolumeCompensationOfDirections, HoldsTheirMeanWhereNothingTellsThemApartOnTheLineAndSaysSo) {
  const VolumeCompensation means = table_along_x(model_without_directions_of({0, 5}));
  EXPECT_EQ(means.line.up_um, means.line.down_um);
  const auto found = std::ranges::find(means.findings, "volume-table-of-means", &NamedFinding::id);
  ASSERT_NE(found, means.findings.end());
  EXPECT_EQ(
      found->message,
      "nothing tells by what the directions differ of ECX: the table holds the mean of both on this line, and what "
      "they differ by stays beside what remains here");

  const VolumeCompensation each = table_along_x(model_without_directions_of({1, 5}));  // Y stands still
  EXPECT_NEAR(each.line.up_um[7] - each.line.down_um[7], 6.0, 1e-9);
  EXPECT_EQ(std::ranges::find(each.findings, "volume-table-of-means", &NamedFinding::id), each.findings.end());
}

}  // namespace
}  // namespace axiometry::app
