// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "axiometry/numeric/distributions/normal_and_student_t.h"
#include "axiometry/standards/error_motions/abbe_offset.h"
#include "axiometry/standards/error_motions/axis_motion.h"
#include "axiometry/standards/error_motions/squareness.h"

namespace axiometry::error_motions {
namespace {

using testing::DoubleNear;
using testing::HasSubstr;

MotionSeries series_of(std::vector<MotionReading> readings, MotionUnit unit = MotionUnit::um) {
  auto series = MotionSeries::make(std::move(readings), unit, 3);
  if (!series) throw std::logic_error(series.error().message);
  return *std::move(series);
}

/// One run in one direction.
MotionSeries one_run(double step_mm, const std::vector<double>& values, double first_mm = 0.0) {
  std::vector<MotionReading> readings;
  for (std::size_t i = 0; i < values.size(); ++i)
    readings.push_back({first_mm + step_mm * static_cast<double>(i), Direction::up, 1, values[i]});
  return series_of(std::move(readings));
}

/// Validation: a maker's manual of 1984, recomputed.
const std::vector<double> first_axis = {-0.3, 0.9, 1.5, 2.5, 2.9, 3.6, 4.2, 5.1, 5.9, 7.2};
const std::vector<double> second_axis = {-0.5, -1.2, -2.5, -3.8, -4.0, -4.8, -5.9, -6.2, -7.4, -8.8};

struct Golden {
  Reference reference;
  double slope_1, slope_2, intercept_1, intercept_2, theta_1, theta_2, square, range_1, range_2;
};

TEST(ErrorMotions, GiveTheFiguresOfAMakersManual) {
  for (const Golden& g :
       {Golden{Reference::least_squares, 7.65455, -17.41818, -0.09455, -0.59091, 1.579, -3.593, -5.172, 0.704, 1.084},
        Golden{Reference::end_points, 8.3333, -18.4444, -0.3, -0.5, 1.719, -3.804, -5.523, 0.867, 1.289}}) {
    const AxisMotion one = axis_motion(one_run(100, first_axis), {.reference = g.reference});
    const AxisMotion two = axis_motion(one_run(50, second_axis), {.reference = g.reference});
    EXPECT_NEAR(one.principal().slope_per_m.value, g.slope_1, 5e-5);
    EXPECT_NEAR(two.principal().slope_per_m.value, g.slope_2, 5e-5);
    EXPECT_NEAR(one.principal().intercept.value, g.intercept_1, 5e-6);
    EXPECT_NEAR(two.principal().intercept.value, g.intercept_2, 5e-6);
    EXPECT_NEAR(one.principal().range.value, g.range_1, 5e-4);
    EXPECT_NEAR(two.principal().range.value, g.range_2, 5e-4);
    const auto s = measured_squareness(one, two, {});
    ASSERT_TRUE(s);
    EXPECT_NEAR(s->theta_1_arcsec.value, g.theta_1, 5e-4);
    EXPECT_NEAR(s->theta_2_arcsec.value, g.theta_2, 5e-4);
    EXPECT_NEAR(s->squareness_arcsec.value, g.square, 5e-4);
  }
}

TEST(ErrorMotions, HaveTheSquarenessOfTheMachineInEitherOrder) {
  const AxisMotion one = axis_motion(one_run(100, first_axis), {}), two = axis_motion(one_run(50, second_axis), {});
  const SquarenessOptions in_axes{.square_error_arcsec = 1.5, .square_uncertainty_arcsec = 0.4, .in_axes = true};
  const auto s = measured_squareness(one, two, in_axes);
  // −1.579″ + 3.593″ of the golden example, + 1.5″.
  EXPECT_NEAR(s->squareness_arcsec.value, 2.014 + 1.5, 1e-3);
  EXPECT_NEAR(measured_squareness(two, one, in_axes)->squareness_arcsec.value, s->squareness_arcsec.value, 1e-12);
  for (const auto& [first, name, sign] :
       {std::tuple("EYX", "C0Y", 1.0), std::tuple("EXY", "C0Y", 1.0), std::tuple("EZX", "B0Z", -1.0),
        std::tuple("EXZ", "B0Z", -1.0), std::tuple("EZY", "A0Z", 1.0), std::tuple("EYZ", "A0Z", 1.0)}) {
    const LocationError error = location_error(*motion_name(first), *s);
    EXPECT_EQ(error.name, name);
    EXPECT_NEAR(error.urad.value, sign * 4.84813681 * s->squareness_arcsec.value, 1e-6) << first;
    EXPECT_NEAR(*error.urad.u, 4.84813681 * *s->squareness_arcsec.u, 1e-6);
    EXPECT_NEAR(error.urad.k, s->squareness_arcsec.k, 1e-12);
  }
}

TEST(ErrorMotions, AddTheErrorOfTheSquareInThatOrder) {
  const AxisMotion one = axis_motion(one_run(100, first_axis), {});
  const AxisMotion two = axis_motion(one_run(50, second_axis), {});
  const double plain = measured_squareness(one, two, {})->squareness_arcsec.value;
  EXPECT_NEAR(measured_squareness(one, two, {.square_error_arcsec = 1.5})->squareness_arcsec.value, plain + 1.5, 1e-12);
  EXPECT_NEAR(measured_squareness(two, one, {.square_error_arcsec = 1.5})->squareness_arcsec.value, 1.5 - plain, 1e-12);
}

TEST(ErrorMotions, OfOneRunAreAsUncertainAsTheResidualsLetALineBe) {
  // s about the least-squares line; 0.1 m apart Σ (x − x̄)² = 0.825 m², the ends 0.9 m.
  const AxisMotion squares = axis_motion(one_run(100, first_axis), {});
  double sum = 0.0;
  for (const double e : squares.principal().residuals) sum += e * e;
  const double s = std::sqrt(sum / 8.0);
  EXPECT_NEAR(*squares.principal().slope_per_m.u, s / std::sqrt(0.825), 1e-12);
  EXPECT_EQ(squares.principal().slope_per_m.scatter_degrees, 8.0);
  const AxisMotion ends = axis_motion(one_run(100, first_axis), {.reference = Reference::end_points});
  EXPECT_NEAR(*ends.principal().slope_per_m.u, s * std::sqrt(2.0) / 0.9, 1e-12);
  EXPECT_FALSE(squares.principal().range.u);  // of a range nothing is known
  EXPECT_FALSE(squares.repeatability_up);
}

TEST(ErrorMotions, OfSeveralRunsScatterAsTheirOwnFigures) {
  // A drift of the slope from run to run, 10, 12 and 17 µm/m, without any other noise.
  std::vector<MotionReading> readings;
  const double slopes[] = {10.0, 12.0, 17.0};
  for (std::size_t r = 0; r < 3; ++r)
    for (const double x : {0.0, 100.0, 300.0, 500.0})
      readings.push_back({x, Direction::up, r + 1, 1e-3 * slopes[r] * x + (x == 300.0 ? 2.0 : 0.0)});
  const AxisMotion motion = axis_motion(series_of(readings), {.reference = Reference::end_points});
  const MotionEstimate& slope = motion.principal().slope_per_m;
  EXPECT_NEAR(slope.value, 13.0, 1e-12);
  EXPECT_NEAR(*slope.u, std::sqrt(13.0) / std::sqrt(3.0), 1e-12);  // s² = (9 + 1 + 16)/2
  EXPECT_NEAR(slope.k, numeric::student_t_quantile(0.977249868, 2.0), 1e-6);
  EXPECT_NEAR(motion.principal().range.value, 2.0, 1e-12);  // the line takes the drift with it
  EXPECT_NEAR(*motion.principal().range.u, 0.0, 1e-12);
}

TEST(ErrorMotions, OfTwoRunsThatHappenToAgreeAreNotWithoutUncertainty) {
  // The ends agree, so the slopes by end points do; what lies between does not.
  std::vector<MotionReading> readings;
  const double runs[2][5] = {{0.0, 0.3, 0.1, 0.5, 1.0}, {0.0, 0.1, 0.4, 0.2, 1.0}};
  for (std::size_t r = 0; r < 2; ++r)
    for (std::size_t i = 0; i < 5; ++i)
      readings.push_back({100.0 * static_cast<double>(i), Direction::up, r + 1, runs[r][i]});
  const MotionEstimate slope =
      axis_motion(series_of(readings), {.reference = Reference::end_points}).principal().slope_per_m;
  EXPECT_EQ(slope.scatter, MotionEstimate::Scatter::noise);
  EXPECT_EQ(slope.scatter_degrees, 3.0);
  // Differences 0, 0.2, −0.3, 0.3, 0 less their line (mean 0.04, slope 0.01 for each position), s² = Σ/2/3.
  const double rest = 0.02 * 0.02 + 0.17 * 0.17 + 0.34 * 0.34 + 0.25 * 0.25 + 0.06 * 0.06;
  EXPECT_NEAR(*slope.u, std::sqrt(rest / 6.0) * std::sqrt(2.0 / 2.0) / 0.4, 1e-12);
}

TEST(ErrorMotions, OfBothDirectionsFollowTheFormulasOfPositions) {
  std::vector<MotionReading> readings;
  const double up[2][3] = {{0.0, 1.0, 0.2}, {0.2, 1.4, 0.2}}, down[2][3] = {{-1.0, 0.5, -0.4}, {-1.0, 0.7, -0.6}};
  for (std::size_t r = 0; r < 2; ++r)
    for (std::size_t i = 0; i < 3; ++i) {
      readings.push_back({100.0 * static_cast<double>(i), Direction::down, r + 1, down[r][i]});
      readings.push_back({100.0 * static_cast<double>(i), Direction::up, r + 1, up[r][i]});
    }
  const AxisMotion m = axis_motion(series_of(readings), {.reference = Reference::end_points});
  ASSERT_EQ(m.paths.size(), 3u);
  // Means ↑ 0.1 1.2 0.2, ↓ −1.0 0.6 −0.5, of both −0.45 0.9 −0.15.
  EXPECT_NEAR(m.paths[0].range.value, 1.2 - 0.15, 1e-12);
  EXPECT_NEAR(m.paths[1].range.value, 0.6 + 0.75, 1e-12);
  EXPECT_NEAR(m.principal().range.value, 0.9 + 0.3, 1e-12);
  EXPECT_NEAR(m.principal().line.at(100.0), -0.3, 1e-12);
  EXPECT_NEAR(m.range_both->value, (1.2 + 0.3) - (-1.0 + 0.45), 1e-12);
  EXPECT_NEAR(m.reversal->value, 1.1, 1e-12);  // largest |B_i|: 1.1, 0.6, 0.7
  EXPECT_NEAR(*m.reversal_mean, 0.8, 1e-12);
  const double s = std::sqrt(0.02), s1 = std::sqrt(0.08);  // of 0.0, 0.2 and 1.0, 1.4
  EXPECT_NEAR(*m.repeatability_up, 4.0 * s1, 1e-12);
  EXPECT_NEAR(*m.repeatability_down, 4.0 * s, 1e-12);
  EXPECT_NEAR(*m.repeatability, std::max({2 * s + 1.1, 2 * s1 + 2 * s + 0.6, 2 * s + 0.7, 4 * s1}), 1e-12);
}

TEST(ErrorMotions, OfReversalsThatCancelTheMeanIsNothingAndNotARounding) {
  std::vector<MotionReading> readings;
  const double up[3] = {0.1, 0.7, 0.5}, down[3] = {0.3, 0.4, 0.6};  // −0.2, 0.3, −0.1
  for (std::size_t i = 0; i < 3; ++i) {
    readings.push_back({100.0 * static_cast<double>(i), Direction::up, 1, up[i]});
    readings.push_back({100.0 * static_cast<double>(i), Direction::down, 1, down[i]});
  }
  EXPECT_EQ(*axis_motion(series_of(readings), {.reference = Reference::end_points}).reversal_mean, 0.0);
  readings[0].value += 1e-9;  // three reversals: a third of it
  EXPECT_NEAR(*axis_motion(series_of(readings), {.reference = Reference::end_points}).reversal_mean, 1e-9 / 3.0, 1e-15);
}

TEST(ErrorMotions, HoldTheInstrumentWhateverItsCorrelation) {
  // U = 0.2 µm + 0.5 µm/m · L; by end points both ends in full: (0.1 + 0.1 + 0.5 · 0.9 / 2) µm over 0.9 m.
  const MotionOptions options{.reference = Reference::end_points, .instrument = InstrumentUncertainty{0.2, 0.5}};
  const AxisMotion m = axis_motion(one_run(100, first_axis), options);
  EXPECT_NEAR(*m.principal().slope_per_m.instrument_u, (0.2 + 0.225) / 0.9, 1e-12);
  EXPECT_TRUE(m.principal().range.u);
  // More positions make it no smaller than an error that tilts from −a to a, whose slope is 2 a/L: for each count.
  for (const int count : {3, 10, 100, 1000}) {
    const AxisMotion fine = axis_motion(one_run(900.0 / (count - 1), std::vector<double>(count, 0.0)),
                                        {.instrument = InstrumentUncertainty{0.2, 0.0}});
    EXPECT_GE(*fine.principal().slope_per_m.instrument_u, 0.2 / 0.9 * (1.0 - 1e-12)) << count;
  }
  // Of the squareness that of both lines adds up.
  const AxisMotion two = axis_motion(one_run(50, second_axis), options);
  const auto s = measured_squareness(m, two, {.square_uncertainty_arcsec = 0.4});
  EXPECT_NEAR(*s->squareness_arcsec.instrument_u, *s->theta_1_arcsec.instrument_u + *s->theta_2_arcsec.instrument_u,
              1e-12);
  EXPECT_EQ(*s->squareness_arcsec.other_u, 0.2);
}

TEST(ErrorMotions, DoNotDependOnWhereZeroIs) {
  const AxisMotion near = axis_motion(one_run(100, first_axis), {});
  const AxisMotion far = axis_motion(one_run(100, first_axis, 1e8), {});
  EXPECT_NEAR(far.principal().slope_per_m.value, near.principal().slope_per_m.value, 1e-9);
  EXPECT_NEAR(far.principal().range.value, near.principal().range.value, 1e-9);
}

TEST(ErrorMotions, OfAnglesKeepTheirSlope) {
  auto series =
      series_of({{0, Direction::up, 1, 5}, {100, Direction::up, 1, 7}, {200, Direction::up, 1, 9}}, MotionUnit::urad);
  EXPECT_EQ(axis_motion(series, {.reference = Reference::none}).principal().range.value, 4.0);
  EXPECT_NEAR(axis_motion(series, {.reference = Reference::least_squares}).principal().range.value, 0.0, 1e-12);
  EXPECT_FALSE(measured_squareness(axis_motion(series, {}), axis_motion(series, {}), {}));
}

TEST(MotionSeries, RefusesWhatIsNotWhole) {
  const auto fault = [](std::vector<MotionReading> readings, std::size_t least = 3) {
    const auto series = MotionSeries::make(std::move(readings), MotionUnit::um, least);
    return series ? std::string() : series.error().message;
  };
  using enum Direction;
  EXPECT_THAT(fault({}), HasSubstr("no readings"));
  EXPECT_THAT(fault({{5, up, 1, 1}}), HasSubstr("1 different position,"));
  EXPECT_THAT(fault({{5, up, 1, 1}, {5, up, 2, 1}, {6, up, 1, 1}, {6, up, 2, 1}}), HasSubstr("2 different positions"));
  EXPECT_THAT(fault({{0, up, 1, 1}, {1, up, 1, 1}, {2, up, 1, 1}, {0, up, 2, 1}, {2, up, 2, 1}}),
              HasSubstr("no reading at position 1 mm ↑ of run 2"));
  EXPECT_THAT(fault({{0, up, 1, 1}, {1, up, 1, 1}, {2, up, 1, 1}, {0, down, 1, 1}, {1, down, 1, 1}}),
              HasSubstr("no reading at position 2 mm ↓ of run 1"));
  EXPECT_THAT(fault({{0, up, 1, 1}, {1, up, 1, 1}, {1, up, 1, 2}, {2, up, 1, 1}}),
              HasSubstr("1 mm ↑ of run 1 a second"));
  EXPECT_THAT(fault({{0, up, 1, 1}, {1, up, 1, 1}, {2, up, 1, 1}, {2, up, 1, 1}}),
              HasSubstr("2 mm ↑ of run 1 a second"));
  EXPECT_THAT(fault({{0, up, 1, 1}, {1e-8, up, 1, 1}, {2e-8, up, 1, 1}}), HasSubstr("within 2e-08 mm"));
  EXPECT_THAT(fault({{0, up, 1, 1}, {1, up, 1, 1}, {2, up, 1, NAN}}), HasSubstr("the reading nan"));
  EXPECT_EQ(fault({{-0.0, up, 7, 1}, {0.0, down, 7, 1}, {1, up, 7, 1}, {1, down, 7, 1}}, 2), "");
}

TEST(MotionName, SaysWhatKindItIs) {
  EXPECT_TRUE(motion_name("eyx")->straightness());
  EXPECT_FALSE(motion_name("EXX")->straightness());
  EXPECT_TRUE(motion_name("EAX")->roll());
  EXPECT_TRUE(motion_name("ECZ")->roll());
  EXPECT_FALSE(motion_name("EBX")->roll());
  for (const char* wrong : {"", "EY", "EYC", "EDX", "XYX", "EYXX", "E Y"}) EXPECT_FALSE(motion_name(wrong)) << wrong;
  EXPECT_TRUE(check_square_pair(*motion_name("EYX"), *motion_name("EXY")));
  EXPECT_TRUE(check_square_pair(*motion_name("EZY"), *motion_name("EYZ")));
  for (const auto& [one, two] : {std::pair("EYX", "EXZ"), {"EYX", "EYX"}, {"EYX", "EYZ"}, {"EZX", "EYX"}})
    EXPECT_FALSE(check_square_pair(*motion_name(one), *motion_name(two))) << one << two;
}

TEST(AbbeOffset, TurnsARigidBody) {
  // Exactly, by the rotation of a vector by 10 µrad about each axis in turn, against the first order.
  const double angle = 10e-6;
  const Vector3 r{30.0, 100.0, 250.0};
  for (std::size_t about = 0; about < 3; ++about) {
    AxisAngles angles;
    for (std::size_t k = 0; k < 3; ++k) angles.urad[k] = {k == about ? 10.0 : 0.0};
    Vector3 turned = r;
    const std::size_t a = (about + 1) % 3, b = (about + 2) % 3;
    turned[a] = std::cos(angle) * r[a] - std::sin(angle) * r[b];
    turned[b] = std::sin(angle) * r[a] + std::cos(angle) * r[b];
    const auto moved = abbe_displacement(angles, r);
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_THAT((*moved[k])[0], DoubleNear(1e3 * (turned[k] - r[k]), 1e-4)) << about << k;
  }
}

TEST(AbbeOffset, KeepsToTheSignsOfItsHeader) {
  AxisAngles angles;
  angles.urad[1] = {10.0};  // a pitch of an X axis
  const auto above = abbe_displacement(angles, {0, 0, 100});
  EXPECT_DOUBLE_EQ((*above[0])[0], 1.0);
  EXPECT_FALSE(above[1]);  // needs the roll
  EXPECT_EQ(missing_angles(angles, {0, 0, 100}, 1), "A");
  EXPECT_EQ((*above[2])[0], 0.0);
  angles.urad[2] = {10.0};  // a yaw
  EXPECT_DOUBLE_EQ((*abbe_displacement(angles, {0, 100, 0})[0])[0], -1.0);
  EXPECT_EQ(missing_angles({}, {0, 5, 5}, 0), "BC");
}

}  // namespace
}  // namespace axiometry::error_motions
