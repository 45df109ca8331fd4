// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "axiometry/volumetric/identify/identification.h"
#include "axiometry/volumetric/identify/identification_test_support.h"

namespace axiometry::volumetric {
namespace {

constexpr std::size_t break_points = 110;  // of each station and tool

/// Half of what each tool saw of the third station is of another day: it stands elsewhere by some micrometres then, and
/// the beam was broken. What is taken for a break before the others are found must not be told in the end.
TEST(Identify, TellsNoBreakWhereNothingJumps) {
  for (const unsigned seed : {32u, 37u, 39u}) {
    SCOPED_TRACE(seed);
    test::TrueMachine machine("XYZF", seed);
    VolumetricLengths lengths = test::measured(machine, test::four_stations(), {.points = break_points});
    for (std::size_t i = 0; i < lengths.readings.size(); ++i)
      if (VolumetricReading& r = lengths.readings[i]; r.station == 2 && i % break_points >= break_points / 2)
        r.length_mm += 0.05 + 0.004 * r.axes_mm.x / 500.0;
    const auto result = identify(machine.model, lengths, {});
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_GE(result->breaks.size(), 3u);
    for (const FoundBreak& found : result->breaks) EXPECT_GT(std::abs(found.jump_um), 0.3) << found.before_reading;
  }
}

/// The dead path is that of the middle of a stretch; what jumps is the length, from its end to the begin of the next.
TEST(Identify, TellsTheJumpOfABreakBesideADrift) {
  test::TrueMachine machine("XFYZ", 41);
  VolumetricLengths lengths = test::measured(machine, test::four_stations(), {.points = 120});
  for (std::size_t i = 0; i < lengths.readings.size(); ++i)
    lengths.readings[i].length_mm += 0.02 * static_cast<double>(i % 120) / 120.0;
  constexpr std::size_t broken = 5 * 120 + 70;
  for (std::size_t i = broken; i < 6 * 120; ++i) lengths.readings[i].length_mm += 0.3;
  const auto result = identify(machine.model, lengths, {});
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_TRUE(result->drift);
  ASSERT_EQ(result->breaks.size(), 1u);
  EXPECT_EQ(result->breaks[0].before_reading, broken);
  EXPECT_NEAR(result->breaks[0].jump_um, 300.0 + 20.0 / 120.0, 1.0);
}

/// Between two breaks there are so few readings that with a drift neither is clear: one of them must be told still, for
/// before the one and behind the other all lengths differ.
TEST(Identify, TellsOneOfTwoBreaksThatAreUnclearBesideEachOther) {
  test::TrueMachine machine("XFYZ", 43);
  VolumetricLengths lengths = test::measured(machine, test::four_stations(), {.points = 120, .noise = false});
  constexpr std::size_t first = 5 * 120 + 60, second = first + 4;
  const auto step_mm = [&](std::size_t i) { return 7.5e-3 * machine.model.sigma_um(lengths.readings[i].length_mm); };
  for (std::size_t i = first; i < 6 * 120; ++i) lengths.readings[i].length_mm += (i < second ? 1.0 : 2.0) * step_mm(i);
  const auto result = identify(machine.model, lengths, {.drift = DriftModel::linear});
  ASSERT_TRUE(result) << result.error().message;
  ASSERT_EQ(result->breaks.size(), 1u);
  EXPECT_GE(result->breaks[0].before_reading, first);
  EXPECT_LE(result->breaks[0].before_reading, second);
}

}  // namespace
}  // namespace axiometry::volumetric
