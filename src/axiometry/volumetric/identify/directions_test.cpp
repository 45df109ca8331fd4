// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "axiometry/volumetric/field/curve_nodes.h"
#include "axiometry/volumetric/identify/identification.h"
#include "axiometry/volumetric/identify/identification_test_support.h"

namespace axiometry::volumetric {
namespace {

using test::four_stations;
using test::measured;
using test::TrueMachine;
using testing::HasSubstr;

constexpr std::size_t points = 100;  // of each station with each tool
constexpr std::size_t runs = 12;

/// Every axis plays by 8 µm, and came up to the first point of each station with each tool, of which no length tells.
VolumetricLengths with_play(TrueMachine& machine, VolumetricLengths lengths) {
  Vector3 side{1.0, 1.0, 1.0};
  for (std::size_t i = 0; i < lengths.readings.size(); ++i) {
    VolumetricReading& r = lengths.readings[i];
    for (std::size_t a = 0; a < axis_count; ++a)
      if (i % points == 0)
        side[a] = 1.0;
      else if (r.axes_mm[a] != lengths.readings[i - 1].axes_mm[a])
        side[a] = r.axes_mm[a] > lengths.readings[i - 1].axes_mm[a] ? 1.0 : -1.0;
    const Vector3 u = unit(r.axes_mm + machine.model.tools[r.tool].offset_mm - four_stations()[r.station].at_mm);
    r.length_mm += 0.004 * dot(side, u);
  }
  return lengths;
}

IdentifyOptions with_reversal() {
  IdentifyOptions options;
  options.sizes = {6, 6, 6};
  options.reversal = Reversal::constant;
  return options;
}

std::string directions_told(const Identification& result) {
  std::string told;
  for (const VolumetricFinding& f : result.findings)
    if (f.id == "volumetric-unknown-directions") told += (told.empty() ? "" : "\n") + f.message;
  return told;
}

/// With the mean of both they would be 4 µm off along each axis, and what is not set aside for it bends curves.
TEST(Directions, OfTheFirstLengthsAreNotGuessed) {
  TrueMachine machine("XFYZ", 31);
  machine.model.repeatability = Length::um(0.3);
  const VolumetricLengths lengths = with_play(machine, measured(machine, four_stations(), {.points = points}));
  const auto result = identify(machine.model, lengths, with_reversal());
  ASSERT_TRUE(result) << result.error().message;
  ASSERT_EQ(result->set_aside.size(), runs);
  for (std::size_t k = 0; k < runs; ++k) {
    EXPECT_EQ(result->set_aside[k].reading, k * points);
    EXPECT_EQ(result->set_aside[k].reason, SetAside::Reason::unknown_direction);
  }
  for (const IdentifiedStation& station : result->stations) EXPECT_EQ(station.readings, points - 1);
  EXPECT_EQ(result->degrees_of_freedom, runs * (points - 1) - result->rank.unknowns);
  EXPECT_NEAR(result->chi_squared_per_dof(), 1.0, 0.15);
  EXPECT_THAT(directions_told(*result), HasSubstr("at 12 lengths before their first move"));
  EXPECT_THAT(directions_told(*result), HasSubstr("they are left out"));
  // Where nobody asks for directions they matter to nothing.
  const auto plain = identify(machine.model, lengths, {});
  ASSERT_TRUE(plain) << plain.error().message;
  EXPECT_EQ(directions_told(*plain), "");
}

/// Else a plan that goes through the volume plane by plane would lose a plane of each run.
TEST(Directions, OfAnAxisThatStoodStillForLongAreTheMeanOfBoth) {
  TrueMachine machine("XFYZ", 32);
  VolumetricLengths lengths = measured(machine, four_stations(), {.points = points});
  for (std::size_t i = 0; i < lengths.readings.size(); ++i)
    if (i % points < points / 2) lengths.readings[i].axes_mm.z = -500.0;
  for (VolumetricReading& r : lengths.readings)
    r.length_mm = distance(r.axes_mm + machine.model.tools[r.tool].offset_mm, four_stations()[r.station].at_mm);
  const auto result = identify(machine.model, lengths, with_reversal());
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_TRUE(result->set_aside.empty());
  EXPECT_THAT(directions_told(*result), HasSubstr("at 600 lengths before their first move"));
  EXPECT_THAT(directions_told(*result), HasSubstr("with a tool: they count as of the mean of both"));
}

/// Z stands still at the second station, where nothing is "before its first move".
TEST(Directions, OfAnAxisThatNeverMovesAreToldAsThat) {
  TrueMachine machine("XFYZ", 33);
  VolumetricLengths lengths = measured(machine, four_stations(), {.points = points});
  for (VolumetricReading& r : lengths.readings)
    if (r.station == 1) r.axes_mm.z = -500.0;
  for (VolumetricReading& r : lengths.readings)
    r.length_mm = distance(r.axes_mm + machine.model.tools[r.tool].offset_mm, four_stations()[r.station].at_mm);
  const auto result = identify(machine.model, lengths, with_reversal());
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_THAT(directions_told(*result), HasSubstr("with a tool, or where Z did not move at all: they count"));
}

/// What X does at an end to which it came from one side alone is told by the bend of its curves there and nothing else.
/// Its direction has shares of some 1e-4 in what Y and Z do, of which it makes no number more uncertain: those are
/// told, and rightly.
TEST(Directions, NamesOnlyErrorsThatTakePartInWhatIsWeaklyTold) {
  TrueMachine machine("XYFZ", 1);
  machine.model.repeatability = Length::um(0.05);
  IdentifyOptions options;
  options.sizes = {8, 8, 8};
  options.reversal = Reversal::curves;
  const auto result = identify(machine.model, measured(machine, four_stations(), {.points = 140}), options);
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(result->rank.null_directions, 1u);
  std::vector<std::string> names;
  for (const std::size_t e : result->model.unseen_errors()) names.push_back(error_names()[e]);
  EXPECT_THAT(names, testing::ElementsAre("EXX", "EYX", "EZX", "EAX", "EBX", "ECX", "C0Y", "B0Z"));
  // The machine has no reversal: what both directions differ by is 0, as far as is stated.
  double squares = 0.0, count = 0.0;
  for (const std::size_t axis : {1u, 2u})
    for (std::size_t m = 0; m < motion_count; ++m)
      for (const CurveNode& node : curve_nodes(result->model, {axis, m})) {
        const auto up = result->model.motion({axis, m}, node.position_mm, 1.0);
        ASSERT_TRUE(up) << error_names()[axis * motion_count + m];
        const double u = node.mean.u + up->u;  // no less than that of the difference
        squares += (up->value - node.mean.value) * (up->value - node.mean.value) / (u * u);
        count += 1.0;
      }
  EXPECT_GT(count, 100.0);
  EXPECT_LT(squares / count, 1.2);
}

}  // namespace
}  // namespace axiometry::volumetric
