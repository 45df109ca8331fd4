// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/identify/findings/mixed_days.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "axiometry/volumetric/identify/findings/finding_test_support.h"
#include "tests/support/statistics_of_trials.h"

namespace axiometry::volumetric {
namespace {

using test::beam;
using test::four_stations;
using test::identified;
using test::machine_with_repeatability;
using test::measured;
using test::told;
using test::TrueMachine;

constexpr std::size_t points_of_stretch = 80;

VolumetricLengths of_one_day(TrueMachine& machine) {
  return measured(machine, four_stations(), {.points = points_of_stretch});
}

bool is_later_half(std::size_t reading) { return reading % points_of_stretch >= points_of_stretch / 2; }

/// All axes longer on the second day, and another zero of the lengths.
void make_second_day(const TrueMachine& machine, double um_per_m, VolumetricReading& reading) {
  reading.length_mm += 1e-6 * um_per_m * dot(reading.axes_mm, beam(machine, reading)) + 0.5e-3;
}

/// Not that single stretches have axes of their own.
std::string days_told(const Identification& result) {
  for (const VolumetricFinding& f : result.findings)
    if (f.id == "volumetric-axes-changed" &&
        f.message.find("in later lengths of the same station") != std::string::npos)
      return f.message;
  return "";
}
std::string days_told(const TrueMachine& machine, const VolumetricLengths& lengths) {
  return days_told(identified(machine, lengths));
}

TEST(MixedDays, AreToldInMostAndNotWhereThereAreNone) {
  AXIOMETRY_STATISTICS_OF_TRIALS();
  std::size_t found = 0, halves = 0;
  for (unsigned seed = 200; seed < 240; ++seed) {
    TrueMachine machine = machine_with_repeatability(seed % 2 == 0 ? "XFYZ" : "FXYZ", seed);
    VolumetricLengths lengths = of_one_day(machine);
    const Identification of_one = identified(machine, lengths);
    EXPECT_EQ(days_told(of_one), "") << seed;
    EXPECT_EQ(told(of_one, "volumetric-reversal"), "") << seed;
    if (seed % 2 != 0) continue;
    ++halves;
    for (std::size_t i = 0; i < lengths.readings.size(); ++i)
      if (is_later_half(i)) make_second_day(machine, 2.0, lengths.readings[i]);
    found += days_told(machine, lengths).empty() ? 0u : 1u;
  }
  EXPECT_GE(found, halves * 3 / 4) << "of " << halves;
}

/// One file behind the other: what was measured later is told by the order, wherever it begins.
TEST(MixedDays, AreToldOfTwoFilesOfUnequalLength) {
  std::size_t found = 0;
  for (unsigned seed = 241; seed < 249; ++seed) {
    TrueMachine machine = machine_with_repeatability("XFYZ", seed);
    VolumetricLengths lengths = of_one_day(machine);
    std::vector<VolumetricReading> first, second;
    for (std::size_t i = 0; i < lengths.readings.size(); ++i) {
      const bool is_second = i % points_of_stretch >= points_of_stretch / 4;
      if (is_second) make_second_day(machine, seed % 2 == 0 ? 6.0 : 3.0, lengths.readings[i]);
      (is_second ? second : first).push_back(lengths.readings[i]);
    }
    lengths.readings = first;
    lengths.readings.insert(lengths.readings.end(), second.begin(), second.end());
    found += days_told(machine, lengths).empty() ? 0u : 1u;
  }
  EXPECT_GE(found, 7u);
}

/// An instrument that slipped in the middle, dead paths that drift, points in the order of an axis: no axis is longer.
TEST(MixedDays, AreNotToldOfOtherThings) {
  AXIOMETRY_STATISTICS_OF_TRIALS();
  for (unsigned seed = 250; seed < 256; ++seed) {
    TrueMachine machine = machine_with_repeatability("XFYZ", seed);
    const VolumetricLengths clean = of_one_day(machine);
    VolumetricLengths slipped = clean, slipped_early = clean, drifted = clean, ordered = clean;
    for (std::size_t i = 0; i < clean.readings.size(); ++i) {
      const double along = static_cast<double>(i % points_of_stretch) / points_of_stretch;
      if (clean.readings[i].station == 1) {
        const double by_mm = dot({0.004, -0.003, 0.002}, beam(machine, clean.readings[i]));
        if (is_later_half(i)) slipped.readings[i].length_mm += by_mm;
        if (along > 0.3) slipped_early.readings[i].length_mm += by_mm;
      }
      drifted.readings[i].length_mm += 5e-3 * along * along;
    }
    for (std::size_t from = 0; from < clean.readings.size(); from += points_of_stretch)
      std::ranges::sort(ordered.readings.begin() + static_cast<std::ptrdiff_t>(from),
                        ordered.readings.begin() + static_cast<std::ptrdiff_t>(from + points_of_stretch), {},
                        [](const VolumetricReading& r) { return r.axes_mm.x; });
    EXPECT_EQ(days_told(machine, slipped), "") << seed;
    EXPECT_EQ(days_told(machine, slipped_early), "") << seed;
    EXPECT_EQ(days_told(machine, drifted), "") << seed;
    EXPECT_EQ(days_told(machine, ordered), "") << seed;
  }
}

}  // namespace
}  // namespace axiometry::volumetric
