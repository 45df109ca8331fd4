// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/identify/findings/reversal_causes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "axiometry/volumetric/identify/findings/finding_test_support.h"
#include "tests/support/statistics_of_trials.h"

namespace axiometry::volumetric {
namespace {

using test::beam;
using test::four_stations;
using test::identified;
using test::machine_with_repeatability;
using test::make_longer;
using test::measured;
using test::told;
using test::TrueMachine;
using testing::HasSubstr;

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

TEST(ReversalCauses, NamesAReversalThatChangesAlongItsAxis) {
  for (const unsigned seed : {31u, 32u, 33u}) {
    TrueMachine machine = machine_with_repeatability("XFYZ", seed);
    const auto found = [&](double varies_um, Reversal reversal) {
      return told(identified(machine, with_reversal_along_y(machine, 2.0, varies_um), {.reversal = reversal}),
                  "volumetric-reversal-varies");
    };
    EXPECT_EQ(found(0.0, Reversal::constant), "") << seed;
    EXPECT_THAT(found(1.0, Reversal::constant),
                HasSubstr("what both directions differ by changes along Y, most clearly of EYY: "))
        << seed;
    EXPECT_EQ(found(1.0, Reversal::curves), "") << seed;
  }
}

/// σ stated far too large hides it from χ², other scatter is more than it: it goes with directions all the same.
TEST(ReversalCauses, TellsAReversalThatNobodyAskedForHoweverLargeResidualsAre) {
  for (const double other_um : {0.0, 2.0})
    for (const double stated_um : {0.3, 5.0}) {
      TrueMachine machine = machine_with_repeatability("XFYZ", 34);
      VolumetricLengths lengths = with_reversal_along_y(machine, 3.0, 0.0);
      for (VolumetricReading& reading : lengths.readings) reading.length_mm += 1e-3 * other_um * machine.normal();
      machine.model.repeatability = Length::um(stated_um);
      const std::string found = told(identified(machine, lengths), "volumetric-reversal");
      EXPECT_THAT(found, HasSubstr("EYY differs")) << other_um << " " << stated_um;
      EXPECT_THAT(found, HasSubstr(" between both directions of Y")) << other_um << " " << stated_um;
    }
}

/// A fit that is tried holds the scales that the other one holds: without them it would look worse than it is.
TEST(ReversalCauses, TellsAReversalBesideScalesOfTheParts) {
  for (const unsigned seed : {35u, 36u, 37u}) {
    TrueMachine machine = machine_with_repeatability("XFYZ", seed);
    VolumetricLengths lengths = with_reversal_along_y(machine, 1.5, 0.0);
    make_longer(machine, lengths,
                [](std::size_t station, std::size_t tool) { return (station + tool) % 2 ? 3.0 : 0.0; });
    const Identification found = identified(machine, lengths);
    ASSERT_TRUE(found.part_scales && found.part_scales->held) << seed;
    EXPECT_THAT(told(found, "volumetric-reversal"), HasSubstr("EYY differs")) << seed;
  }
}

/// Curves of one span cannot follow the errors: what is left goes with places, not with directions.
TEST(ReversalCauses, TellsNoneOfCurvesThatAreTooStraight) {
  AXIOMETRY_STATISTICS_OF_TRIALS();
  for (unsigned seed = 140; seed < 150; ++seed) {
    TrueMachine machine = machine_with_repeatability("XFYZ", seed);
    const VolumetricLengths lengths = measured(machine, four_stations(), {.points = 60});
    const Identification result = identified(machine, lengths, {.sizes = {1, 1, 1}});
    EXPECT_NE(told(result, "volumetric-scatter"), "") << seed;
    EXPECT_EQ(told(result, "volumetric-reversal"), "") << seed;
  }
}

/// Row by row what curves leave alternates with the rows, and the first layer is one of places: neither is reversal.
TEST(ReversalCauses, TellsNoneOfGridsThatAreDrivenRowByRow) {
  for (unsigned seed = 160; seed < 162; ++seed) {
    TrueMachine machine = machine_with_repeatability("XFYZ", seed);
    VolumetricLengths lengths = measured(machine, four_stations(), {.grid = {7, 5, 5}});
    for (const bool is_coarse : {false, true}) {
      const IdentifyOptions options{.sizes =
                                        is_coarse ? std::array<std::size_t, 3>{2, 2, 2} : std::array<std::size_t, 3>{}};
      const Identification result = identified(machine, lengths, options);
      for (const char* id : {"volumetric-reversal", "volumetric-axes-changed"})
        EXPECT_EQ(told(result, id), "") << id << " " << seed << " " << is_coarse;
    }
    const Identification constant = identified(machine, lengths, {.sizes = {2, 2, 2}, .reversal = Reversal::constant});
    EXPECT_EQ(told(constant, "volumetric-reversal-varies"), "") << seed;
  }
}

/// With one tool a displacement of an axis and a rotation of it are one: no error is named that may be another.
TEST(ReversalCauses, NamesNoErrorThatMayBeAnother) {
  for (unsigned seed = 170; seed < 172; ++seed) {
    TrueMachine machine = machine_with_repeatability("XFYZ", seed);
    machine.model.tools.resize(1);
    const std::string found =
        told(identified(machine, with_reversal_along_y(machine, 3.0, 0.0)), "volumetric-reversal");
    if (found.find("between both directions of") != std::string::npos)
      EXPECT_THAT(found, HasSubstr("EYY")) << seed;
    else
      EXPECT_THAT(found, HasSubstr("do not tell which error")) << seed;
  }
}

}  // namespace
}  // namespace axiometry::volumetric
