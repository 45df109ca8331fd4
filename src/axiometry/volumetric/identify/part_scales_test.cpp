// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/identify/part_scales.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "axiometry/volumetric/identify/findings/finding_test_support.h"
#include "tests/support/statistics_of_trials.h"

namespace axiometry::volumetric {
namespace {

using test::four_stations;
using test::identified;
using test::machine_with_repeatability;
using test::make_longer;
using test::measured;
using test::told;
using test::TrueMachine;
using ::testing::HasSubstr;

TEST(PartScales, AreThoseOfEachStationAndToolLessWhatAllHaveInCommon) {
  TrueMachine machine = machine_with_repeatability("XFYZ", 31);
  VolumetricLengths lengths = measured(machine, four_stations(), {.points = 80});
  const auto scale = [](std::size_t station, std::size_t tool) { return 4.0 * double(station) - 3.0 * double(tool); };
  make_longer(machine, lengths, scale);
  const Identification found = identified(machine, lengths);
  ASSERT_TRUE(found.part_scales);
  EXPECT_TRUE(found.part_scales->held);
  EXPECT_LT(found.part_scales->chance, 1e-6);
  EXPECT_LT(found.chi_squared_per_dof(), 1.15);
  double mean = 0.0;
  for (const IdentifiedStation& s : found.stations) mean += (*s.scale_um_per_m - scale(s.station, s.tool)) / 12.0;
  for (const IdentifiedStation& s : found.stations)
    EXPECT_NEAR(*s.scale_um_per_m - mean, scale(s.station, s.tool), 3.0) << s.station << " " << s.tool;
  EXPECT_THAT(told(found, "volumetric-part-scales"), HasSubstr("the axes differ in length from part to part"));
  EXPECT_EQ(told(found, "volumetric-axes-changed"), "");
  EXPECT_EQ(told(found, "volumetric-scatter"), "");
}

// A part that is longer by 12 µm/m makes its far readings look like outliers; with its scale they fit.
TEST(PartScales, MakeNoReadingAnOutlier) {
  for (const unsigned seed : {34u, 35u, 36u}) {
    TrueMachine machine = machine_with_repeatability("XFYZ", seed);
    VolumetricLengths lengths = measured(machine, four_stations(), {.points = 80});
    make_longer(machine, lengths,
                [](std::size_t station, std::size_t tool) { return station == 2 && tool == 1 ? 12.0 : 0.0; });
    const Identification found = identified(machine, lengths);
    ASSERT_TRUE(found.part_scales) << seed;
    EXPECT_LE(found.set_aside.size(), 1u) << seed;
  }
}

// Of lengths without noise scales explain all: that is no chance.
TEST(PartScales, AreFoundWhereTheyExplainAllThereIs) {
  TrueMachine machine = machine_with_repeatability("XFYZ", 37);
  VolumetricLengths lengths = measured(machine, four_stations(), {.points = 80, .noise = false});
  make_longer(machine, lengths, [](std::size_t station, std::size_t) { return 4.0 * double(station); });
  const Identification found = identified(machine, lengths);
  ASSERT_TRUE(found.part_scales);
  EXPECT_LT(found.part_scales->chance, 1e-6);
}

TEST(PartScales, AreNotLookedForWhereNobodyWantsThem) {
  TrueMachine machine = machine_with_repeatability("XFYZ", 32);
  VolumetricLengths lengths = measured(machine, four_stations(), {.points = 80});
  make_longer(machine, lengths, [](std::size_t station, std::size_t) { return 5.0 * double(station); });
  EXPECT_FALSE(identified(machine, lengths, {.find_part_scales = false}).part_scales);
  EXPECT_TRUE(identified(machine, lengths).part_scales);
}

TEST(PartScales, OfFewPartsAreASeriousFinding) {
  TrueMachine machine = machine_with_repeatability("XFYZ", 33);
  machine.model.tools.resize(1);
  auto stations = four_stations();
  stations.resize(3);
  VolumetricLengths lengths = measured(machine, stations, {.points = 200});
  make_longer(machine, lengths, [](std::size_t station, std::size_t) { return station == 1 ? 40.0 : 0.0; });
  const Identification found = identified(machine, lengths);
  ASSERT_TRUE(found.part_scales);
  EXPECT_FALSE(found.part_scales->held);
  EXPECT_FALSE(found.stations.front().scale_um_per_m);
  EXPECT_THAT(told(found, "volumetric-part-scales"), HasSubstr("so few parts do not tell by how much"));
  EXPECT_TRUE(found.findings.front().serious);
}

TEST(PartScales, OfVeryManyPartsAreNotLookedForWhichIsTold) {
  AXIOMETRY_STATISTICS_OF_TRIALS();
  TrueMachine machine = machine_with_repeatability("XFYZ", 38);
  std::vector<NamedStation> stations;
  for (int k = 0; k < 101; ++k) {
    NamedStation station = four_stations()[static_cast<std::size_t>(k % 4)];
    station.name = std::to_string(k);
    station.at_mm.y -= 2.0 * k;
    stations.push_back(station);
  }
  const VolumetricLengths lengths = measured(machine, stations, {.points = 10});
  const std::string what = "was not looked for: found 303 parts, expected at most 300";
  EXPECT_THAT(told(identified(machine, lengths, {.sizes = {2, 2, 2}}), "volumetric-part-scales"), HasSubstr(what));
  EXPECT_EQ(
      told(identified(machine, lengths, {.sizes = {2, 2, 2}, .find_part_scales = false}), "volumetric-part-scales"),
      "");
}

TEST(PartScales, AreSeldomFoundWhereThereAreNone) {
  AXIOMETRY_STATISTICS_OF_TRIALS();
  std::size_t found = 0, tried = 0;
  for (unsigned seed = 400; seed < 450; ++seed, ++tried) {
    TrueMachine machine = machine_with_repeatability("XFYZ", seed);
    found += identified(machine, measured(machine, four_stations(), {.points = 80})).part_scales ? 1u : 0u;
  }
  EXPECT_LE(static_cast<double>(found), 0.4 * static_cast<double>(tried));  // 0.2 are asked for
}

}  // namespace
}  // namespace axiometry::volumetric
