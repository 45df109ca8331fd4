// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/identify/findings/one_sided_places.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "axiometry/volumetric/identify/identification_test_support.h"

namespace axiometry::volumetric {
namespace {

using detail::one_sided_places;
using detail::OneSidedPlaces;
using testing::HasSubstr;

auto reached_between(double lowest, double highest, bool is_up) {
  return testing::AllOf(testing::Field(&OneSidedPlaces::lowest_mm, lowest),
                        testing::Field(&OneSidedPlaces::highest_mm, highest),
                        testing::Field(&OneSidedPlaces::is_up, is_up));
}

TEST(OneSidedPlaces, AreThoseBeyondTheReachOfTheOtherDirection) {
  const auto both = one_sided_places({{0, 10, 20, 30}, {30, 20, 10, 0}, 0, 30}, 5.0);
  EXPECT_THAT(both, testing::IsEmpty());
  // There and back along a line: its ends are reached from one side alone.
  const auto ends = one_sided_places({{10, 20, 30}, {20, 10, 0}, 0, 30}, 5.0);
  EXPECT_THAT(ends, testing::ElementsAre(reached_between(30, 30, true), reached_between(0, 0, false)));
  // Nearer to the next place of the other direction than the curves can bend.
  EXPECT_THAT(one_sided_places({{10, 20, 30}, {20, 10, 0}, 0, 30}, 10.0), testing::IsEmpty());
}

TEST(OneSidedPlaces, AreFoundInTheMiddleAndWhereADirectionIsMissingAltogether) {
  const auto middle = one_sided_places({{0, 10, 12, 14, 30}, {0, 30}, 0, 30}, 15.0);
  EXPECT_THAT(middle, testing::ElementsAre(reached_between(10, 14, true)));
  const auto all = one_sided_places({{}, {20, 5, 10}, 0, 30}, 5.0);
  EXPECT_THAT(all, testing::ElementsAre(reached_between(5, 20, false)));
  EXPECT_THAT(one_sided_places({{}, {}, 0, 30}, 5.0), testing::IsEmpty());
}

std::vector<std::string> one_sided_findings(const Identification& result) {
  std::vector<std::string> found;
  for (const VolumetricFinding& f : result.findings)
    if (f.id == "volumetric-one-sided-places") found.push_back(f.message);
  return found;
}

/// X rests above 800 mm only where it came from below: those that came from above are left out.
TEST(OneSidedPlaces, OfTheLengthsAreToldWithCurvesOfBothDirectionsAlone) {
  test::TrueMachine machine("XFYZ", 3);
  VolumetricLengths lengths = test::measured(machine, test::four_stations(), {.points = 200});
  std::vector<VolumetricReading> some;
  for (const VolumetricReading& r : lengths.readings)
    if (some.empty() || some.back().tool != r.tool || r.axes_mm.x <= 800.0 || r.axes_mm.x > some.back().axes_mm.x)
      some.push_back(r);
  lengths.readings = some;
  IdentifyOptions options;
  options.sizes = {4, 4, 4};
  options.reversal = Reversal::curves;
  const auto result = identify(machine.model, lengths, options);
  ASSERT_TRUE(result) << result.error().message;
  const auto found = one_sided_findings(*result);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_THAT(found[0], HasSubstr("X came to rest from "));
  EXPECT_THAT(found[0], HasSubstr("mm moving up only: what it does there moving down"));
  options.reversal = Reversal::constant;  // is the same everywhere
  const auto constant = identify(machine.model, lengths, options);
  ASSERT_TRUE(constant) << constant.error().message;
  EXPECT_THAT(one_sided_findings(*constant), testing::IsEmpty());
}

}  // namespace
}  // namespace axiometry::volumetric
