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

}  // namespace
}  // namespace axiometry::volumetric
