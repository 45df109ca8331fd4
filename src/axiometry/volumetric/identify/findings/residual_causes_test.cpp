// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/identify/findings/residual_causes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "axiometry/volumetric/identify/findings/finding_test_support.h"

namespace axiometry::volumetric {
namespace {

using test::beam;
using test::causes_told;
using test::four_stations;
using test::identified;
using test::machine_with_repeatability;
using test::measured;
using test::told;
using test::TrueMachine;
using testing::HasSubstr;

TEST(ResidualCauses, NamesTheOrderOfTheAxesThatFits) {
  TrueMachine machine = machine_with_repeatability("XZFY", 21);
  machine.model.repeatability = Length::um(0.15);
  const VolumetricLengths lengths = measured(machine, four_stations(), {.points = 80});
  EXPECT_EQ(causes_told(identified(machine, lengths)), 0u);
  machine.model.chain = KinematicChain::make("XFYZ").value();
  const Identification result = identified(machine, lengths);
  EXPECT_THAT(told(result, "volumetric-chain-order"), HasSubstr("in the order X, Z, Y from the workpiece to the tool"));
  EXPECT_EQ(causes_told(result), 1u);
  // The side of the foundation that an axis is on makes no difference to lengths.
  machine.model.chain = KinematicChain::make("FXZY").value();
  EXPECT_EQ(causes_told(identified(machine, lengths)), 0u);
}

TEST(ResidualCauses, NamesAReversalThatNobodyAskedFor) {
  TrueMachine machine = machine_with_repeatability("XFYZ", 22);
  VolumetricLengths lengths = measured(machine, four_stations(), {.points = 80});
  for (std::size_t i = 1; i < lengths.readings.size(); ++i) {
    VolumetricReading& reading = lengths.readings[i];
    const double way = reading.axes_mm.y - lengths.readings[i - 1].axes_mm.y;
    reading.length_mm += (way > 0.0 ? 0.0015 : -0.0015) * beam(machine, reading).y;
  }
  const Identification result = identified(machine, lengths);
  EXPECT_THAT(told(result, "volumetric-reversal"), HasSubstr("EYY differs most, by "));
  EXPECT_THAT(told(result, "volumetric-reversal"), HasSubstr(" µm between both directions of Y"));
  EXPECT_EQ(causes_told(result), 1u);
  EXPECT_EQ(causes_told(identified(machine, lengths, {.reversal = Reversal::constant})), 0u);
}

TEST(ResidualCauses, SaysThatLengthsOfAnAxisThatBecameLongerAreAmongThem) {
  TrueMachine machine = machine_with_repeatability("YFXZ", 23);
  VolumetricLengths lengths = measured(machine, four_stations(), {.points = 80});
  for (VolumetricReading& reading : lengths.readings)
    if (reading.station > 1) reading.length_mm += 30e-6 * reading.axes_mm.x * beam(machine, reading).x;
  const Identification result = identified(machine, lengths);
  EXPECT_THAT(told(result, "volumetric-axes-changed"), HasSubstr("lengths of two days are mixed"));
  EXPECT_EQ(causes_told(result), 1u);
}

TEST(ResidualCauses, NamesNoneWhereReadingsScatterMore) {
  TrueMachine machine = machine_with_repeatability("XFYZ", 24);
  VolumetricLengths lengths = measured(machine, four_stations(), {.points = 80});
  for (VolumetricReading& reading : lengths.readings) reading.length_mm += 2e-3 * machine.normal();
  const Identification result = identified(machine, lengths);
  EXPECT_NE(told(result, "volumetric-scatter"), "");
  EXPECT_EQ(causes_told(result), 0u);
}

}  // namespace
}  // namespace axiometry::volumetric
