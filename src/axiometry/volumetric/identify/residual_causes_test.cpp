// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/identify/residual_causes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <string_view>

#include "axiometry/volumetric/identify/identification_test_support.h"

namespace axiometry::volumetric {
namespace {

using test::four_stations;
using test::measured;
using test::TrueMachine;
using testing::HasSubstr;

TrueMachine machine_with_repeatability(const char* chain, unsigned seed) {
  TrueMachine machine(chain, seed);
  machine.model.repeatability = Length::um(0.3);
  return machine;
}

Identification identified(const TrueMachine& machine, const VolumetricLengths& lengths,
                          const IdentifyOptions& options = {}) {
  auto result = identify(machine.model, lengths, options);
  if (!result) {
    ADD_FAILURE() << result.error().message;
    std::abort();
  }
  return *std::move(result);
}

std::string told(const Identification& result, std::string_view id) {
  for (const VolumetricFinding& f : result.findings)
    if (f.id == id) return f.message;
  return "";
}

std::size_t causes_told(const Identification& result) {
  std::size_t count = 0;
  for (const char* id : {"volumetric-chain-order", "volumetric-reversal", "volumetric-axes-changed"})
    count += told(result, id).empty() ? 0u : 1u;
  return count;
}

Vector3 beam(const TrueMachine& machine, const VolumetricReading& reading) {
  return unit(reading.axes_mm + machine.model.tools[reading.tool].offset_mm - four_stations()[reading.station].at_mm);
}

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

/// Along Y both directions differ by ±`varies_um` at its ends beside a constant, of a travel of 600 mm.
VolumetricLengths with_reversal_along_y(TrueMachine& machine, double constant_um, double varies_um) {
  VolumetricLengths lengths = measured(machine, four_stations(), {.points = 120});
  for (std::size_t i = 1; i < lengths.readings.size(); ++i) {
    VolumetricReading& reading = lengths.readings[i];
    const double way = reading.axes_mm.y - lengths.readings[i - 1].axes_mm.y;
    const double half_um = 0.5 * (constant_um + varies_um * (reading.axes_mm.y / 300.0 - 1.0));
    reading.length_mm += 1e-3 * (way > 0.0 ? half_um : -half_um) * beam(machine, reading).y;
  }
  return lengths;
}

TEST(ResidualCauses, NamesAReversalThatChangesAlongItsAxis) {
  for (const unsigned seed : {31u, 32u, 33u}) {
    TrueMachine machine = machine_with_repeatability("XFYZ", seed);
    const auto found = [&](double varies_um, Reversal reversal) {
      return told(identified(machine, with_reversal_along_y(machine, 2.0, varies_um), {.reversal = reversal}),
                  "volumetric-reversal-varies");
    };
    EXPECT_EQ(found(0.0, Reversal::constant), "") << seed;
    EXPECT_THAT(found(1.0, Reversal::constant), HasSubstr("what both directions of an axis differ by changes")) << seed;
    EXPECT_EQ(found(1.0, Reversal::curves), "") << seed;
  }
}

TEST(ResidualCauses, SaysThatLengthsOfAWarmerMachineAreAmongThem) {
  TrueMachine machine = machine_with_repeatability("YFXZ", 23);
  VolumetricLengths lengths = measured(machine, four_stations(), {.points = 80});
  for (VolumetricReading& reading : lengths.readings)
    if (reading.station > 1) reading.length_mm += 30e-6 * dot(reading.axes_mm, beam(machine, reading));
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
