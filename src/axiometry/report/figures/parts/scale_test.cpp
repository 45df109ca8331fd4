// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/figures/parts/scale.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace axiometry::report::plot {
namespace {

using ::testing::ElementsAre;

TEST(Divide, PlacesRoundNumbers) {
  const Ticks ticks = divide(-5.9, 4.2, 8, Division::decimal);
  EXPECT_THAT(ticks.major, ElementsAre(-4, -2, 0, 2, 4));
  EXPECT_EQ(ticks.decimals, 0);
  EXPECT_EQ(ticks.minor.size(), 15u);  // every half from −5.5 to 4 that is not even
}

TEST(Divide, CountsAnEdgeThatIsATick) {
  using ::testing::DoubleEq;
  const Ticks ticks = divide(0.0, 0.3, 3, Division::decimal);
  EXPECT_THAT(ticks.major, ElementsAre(0.0, DoubleEq(0.1), DoubleEq(0.2), DoubleEq(0.3)));
}

TEST(Divide, TakesPartsOfACircleOnRotaryAxes) {
  EXPECT_THAT(divide(0, 360, 9, Division::angular).major, ElementsAre(0, 45, 90, 135, 180, 225, 270, 315, 360));
  EXPECT_THAT(divide(0, 1800, 6, Division::angular).major, ElementsAre(0, 360, 720, 1080, 1440, 1800));
}

TEST(Divide, TellsTheDecimalsItsLabelsNeed) {
  EXPECT_EQ(divide(0, 0.013, 6, Division::decimal).decimals, 3);
  EXPECT_EQ(divide(0, 13000, 6, Division::decimal).decimals, 0);
}

TEST(Divide, NeverRunsAwayAtTheEdgesOfDouble) {
  EXPECT_LT(divide(1e300, std::nextafter(1e300, 2e300), 8, Division::decimal).major.size(), 1000u);
  EXPECT_LT(divide(-100.0, 100.0, 11, Division::decimal).major.size(), 20u);
}

TEST(TickLabel, GroupsDigitsFromFiveOn) {
  EXPECT_EQ(tick_label(1500, 0, {}), "1500");
  EXPECT_EQ(tick_label(12500, 0, {}), "12\u2009500");
  EXPECT_EQ(tick_label(-1234567.5, 1, {.decimal_mark = ','}), "\u22121\u2009234\u2009567,5");
}

TEST(AxisUnit, ChangesWhereNumbersWouldGetHugeOrTiny) {
  const auto name = [](const AxisUnit& unit) { return unit.name.back().text; };
  EXPECT_EQ(name(deviation_axis_unit(AxisKind::linear, DisplayUnit::native, 9.6)), "µm");
  EXPECT_EQ(name(deviation_axis_unit(AxisKind::linear, DisplayUnit::native, 50000)), "mm");
  EXPECT_EQ(name(deviation_axis_unit(AxisKind::linear, DisplayUnit::native, 0.001)), "nm");
  EXPECT_EQ(name(deviation_axis_unit(AxisKind::linear, DisplayUnit::native, 0.008)), "nm");
  EXPECT_EQ(deviation_axis_unit(AxisKind::linear, DisplayUnit::native, 0.008).name.size(), 1u);  // no power of ten
  EXPECT_EQ(name(deviation_axis_unit(AxisKind::linear, DisplayUnit::nm, 9.6)), "nm");
  EXPECT_EQ(name(deviation_axis_unit(AxisKind::rotary, DisplayUnit::native, 12)), "″");
  EXPECT_EQ(name(deviation_axis_unit(AxisKind::rotary, DisplayUnit::native, 36000)), "°");
  EXPECT_EQ(name(position_axis_unit(AxisKind::linear, 4000)), "mm");
  EXPECT_EQ(name(position_axis_unit(AxisKind::linear, 250000)), "m");
}

TEST(AxisUnit, TakesAPowerOfTenWhenNoUnitIsLargeEnough) {
  const AxisUnit unit = position_axis_unit(AxisKind::linear, 3e15);
  EXPECT_DOUBLE_EQ(unit.native, 1e15);
  EXPECT_EQ(unit.name[1].text, "12");
  EXPECT_EQ(unit.name[1].script, Script::super);
}

}  // namespace
}  // namespace axiometry::report::plot
