// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/singles/measured_square.h"

#include <gtest/gtest.h>

#include <cmath>

namespace axiometry::volumetric {
namespace {

/// EYX rises by 1 µm from 0 to 10 mm and by 3 µm from 10 to 20 mm; EXY is level.
SquareMeasurement bent_square() {
  SquareMeasurement m;
  m.which = Squareness::C0Y;
  m.lines = {SquareLine{{0, 1}, {0, 10, 20}, {0, 1, 4}, {-0.05, 0, 0.05}},
             SquareLine{{1, 0}, {0, 10, 20}, {5, 5, 5}, {-0.05, 0, 0.05}}};
  m.square_urad = 3.0;
  m.u_scatter_urad = 4.0;
  m.u_instrument_urad = 0.0;
  m.u_square_urad = 3.0;
  return m;
}

SingleErrors yaw_over(double from_mm, double to_mm) {
  SingleErrors errors;
  errors.motions.push_back({{0, 5}, {from_mm, to_mm}, {0, 0}, {0.1, 0.1}});
  return errors;
}

TEST(MeasuredSquare, CountsItsLinesOverTheRangeOfTheErrors) {
  // By hand: the best line for the curve has the slope 12/20³ ∫ (q − 10) y dq : of the
  // pieces q/10 and 1 + 3 (q − 10)/10: ∫_{-10}^{0} x (x + 10)/10 dx = −16.667, ∫_0^{10} x (1 + 0.3 x) dx = 150;
  // 1.5e-3 · 133.333 = 0.2 µm/mm = 200 µrad. Within 0 to 10 mm it is 100, within 10 to 20 mm 300 µrad.
  EXPECT_NEAR(squareness_over_common_range(bent_square(), {})->urad, -200.0 + 3.0, 1e-9);
  EXPECT_NEAR(squareness_over_common_range(bent_square(), yaw_over(0, 10))->urad, -100.0 + 3.0, 1e-9);
  EXPECT_NEAR(squareness_over_common_range(bent_square(), yaw_over(10, 20))->urad, -300.0 + 3.0, 1e-9);
  EXPECT_NEAR(squareness_over_common_range(bent_square(), yaw_over(12, 18))->urad, -300.0 + 3.0, 1e-9);
  SquareMeasurement other_order = bent_square();
  std::swap(other_order.lines[0], other_order.lines[1]);
  EXPECT_NEAR(squareness_over_common_range(other_order, {})->urad, -200.0 + 3.0, 1e-9);
  EXPECT_TRUE(squareness_over_common_range(bent_square(), {})->over_common_range);
  other_order.lines[0].direction = -1.0;  // EXY, the first of C0Y in square_lines
  EXPECT_EQ(squareness_over_common_range(other_order, {})->directions, (std::array<double, 2>{-1.0, 0.0}));
}

TEST(MeasuredSquare, KeepsItsUncertaintyOrMakesItLarger) {
  // Three equidistant readings: the weights of the model are those of least squares, −1/20, 0, 1/20.
  EXPECT_NEAR(squareness_over_common_range(bent_square(), {})->u_urad, 5.0, 1e-9);
  // Over half the range the weights are ±1/10: readings that scatter alike make a slope twice as uncertain.
  EXPECT_NEAR(squareness_over_common_range(bent_square(), yaw_over(0, 10))->u_urad, std::hypot(8.0, 3.0), 1e-9);
  SquareMeasurement by_instrument = bent_square();
  by_instrument.u_scatter_urad = 0.0;
  by_instrument.u_instrument_urad = 1.0;
  EXPECT_NEAR(squareness_over_common_range(by_instrument, yaw_over(0, 10))->u_urad, std::hypot(2.0, 3.0), 1e-9);
}

TEST(MeasuredSquare, RefusesLinesOfAnotherPlaneOrAShorterWay) {
  SquareMeasurement other = bent_square();
  other.which = Squareness::B0Z;
  EXPECT_FALSE(squareness_over_common_range(other, {}));
  const auto shorter = squareness_over_common_range(bent_square(), yaw_over(0, 25));
  ASSERT_FALSE(shorter);
  EXPECT_EQ(shorter.error().message,
            "found the line EYX of C0Y read from 0 to 20 mm, expected it over the range that the errors of X have in "
            "common, from 0 to 25 mm");
}

}  // namespace
}  // namespace axiometry::volumetric
