// SPDX-License-Identifier: Apache-2.0
#include "axiometry/tracking/station/station.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "axiometry/numeric/random/random.h"
#include "axiometry/tracking/station/station_fit.h"

namespace axiometry::tracking {
namespace {

constexpr Vector3 station{653.60, -27.13, 262.18};  // of the paper's Table 2
constexpr double L0 = 412.7;

/// Six points of an ordinary layout.
const std::vector<Vector3> six = {{250, 180, 520},  {900, 260, 610}, {420, -310, 900},
                                  {980, -240, 480}, {610, 300, 980}, {300, 40, 720}};

std::vector<LocationPoint> measured(std::span<const Vector3> points, Vector3 s = station) {
  std::vector<LocationPoint> result;
  for (Vector3 p : points) result.push_back({p, distance(p, s) - L0});
  return result;
}

StationLocation located(std::span<const LocationPoint> points, const StationOptions& options = {}) {
  auto location = locate_station(points, options);
  EXPECT_TRUE(location) << (location ? "" : location.error().to_string());
  return location ? *location : StationLocation{};
}

std::string error_of(std::span<const LocationPoint> points, const StationOptions& options = {}) {
  const auto location = locate_station(points, options);
  return location ? "no error" : location.error().to_string();
}

std::string messages(const StationLocation& location) {
  std::string all;
  for (const Finding& f : location.findings) all += (f.serious ? "! " : "- ") + f.id + ": " + f.message + "\n";
  return all;
}

bool says(const StationLocation& location, std::string_view words) {
  return messages(location).find(words) != std::string::npos;
}

void expect_near(Vector3 found, Vector3 expected, double tolerance) {
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(found[k], expected[k], tolerance) << "coordinate " << k;
}

TEST(Station, ExactLengthsGiveTheTruthByBothEstimators) {
  const auto location = located(measured(six));
  ASSERT_TRUE(location.has_linear());
  expect_near(location.linear->station_mm, station, 1e-9);
  expect_near(location.refined.station_mm, station, 1e-9);
  EXPECT_NEAR(location.linear->L0_mm, L0, 1e-9);
  EXPECT_NEAR(location.refined.L0_mm, L0, 1e-9);
  EXPECT_NEAR(location.linear->misclosure_mm2, 0.0, 1e-7);
  EXPECT_NEAR(location.linear->psi_mm2, dot(station, station) - L0 * L0, 1e-6);
  EXPECT_NEAR(location.linear->redundant_residual_mm2, 0.0, 1e-7);
  EXPECT_EQ(location.surface, CriticalSurface::none);
  EXPECT_FALSE(location.is_serious()) << messages(location);
  EXPECT_TRUE(says(location, "- station-residuals-small: the residuals"));
  EXPECT_TRUE(says(location, "far smaller than the stated uncertainties"));
}

TEST(Station, AnyMomentMayBeTheZeroOfTheLengths) {
  for (const double zero : {0.0, 1e4, -300.0}) {
    auto points = measured(six);
    for (LocationPoint& p : points) p.length_difference_mm += L0 - zero;
    const auto location = located(points);
    expect_near(location.refined.station_mm, station, 1e-9);
    EXPECT_NEAR(location.refined.L0_mm, zero, 1e-8);
    EXPECT_NEAR(location.linear->L0_mm, zero, 1e-8);
  }
}

// Golden: Lee et al., Table 2, as the exact theorem behind it: coordinates that are all wrong by o move the station by
// -o.
TEST(Station, AConstantOffsetMovesBothStationsByItsNegative) {
  for (const Vector3 offset : {Vector3{0.1, 0, 0}, Vector3{0, -0.1, 0}, Vector3{0, 0, 0.05}, Vector3{1, 1, -1}}) {
    auto points = measured(six);
    const auto before = located(points);
    for (LocationPoint& p : points) p.at_mm -= offset;
    const auto after = located(points);
    expect_near(after.refined.station_mm - before.refined.station_mm, -offset, 1e-9);
    expect_near(after.linear->station_mm - before.linear->station_mm, -offset, 1e-9);
    EXPECT_NEAR(after.linear->misclosure_mm2, 0.0, 1e-6);
  }
}

struct Fixture {
  double e;
  Vector3 origin;
  bool linear;
  std::vector<Vector3> points;
  std::vector<Vector3> predicted;
};

std::vector<LocationPoint> scaled_machine(const Fixture& f, Vector3 scale) {
  std::vector<LocationPoint> points;
  for (Vector3 p : f.points) {
    Vector3 actual = p;
    for (std::size_t k = 0; k < 3; ++k) actual[k] += f.e * scale[k] * (p[k] - f.origin[k]);
    points.push_back({p, norm(actual) - 100.0});
  }
  return points;
}

// Golden: shared reference of Lee et al., Table 3: points relative to the station, lengths of a machine whose axes are
// scaled by 1 + e about the origin; predictions computed independently, printed to five decimals.
TEST(Station, ProportionalErrorsMoveTheStationAsPredicted) {
  const Fixture fixtures[] = {
      {1e-3,
       {0, 0, 0},
       true,
       {{-52, -18, 337}, {103, 80, 84}, {93, 124, 387}, {88, 28, 217}, {-99, -66, 147}, {-183, 297, 511}},
       {{0.05836, -0.10225, -0.0124},
        {-0.05838, 0.10231, 0.0128},
        {0.14392, -0.24427, -0.03265},
        {-0.14384, 0.24417, 0.03305},
        {0.00479, -0.00837, -0.04048},
        {-0.00496, 0.00879, 0.04301},
        {0.20221, -0.34635, -0.04461},
        {-0.2023, 0.34664, 0.04629},
        {0.06326, -0.11087, -0.05383},
        {-0.06322, 0.11084, 0.05486},
        {0.14883, -0.25292, -0.07433},
        {-0.14868, 0.25268, 0.07486}}},
      {1e-3,
       {0, 0, 0},
       false,
       {{-78, -110, 125}, {-458, 462, 267}, {244, 471, 246}, {143, 130, 101}, {269, 31, 210}, {104, -4, 116}},
       {{0.05896, -0.10201, -0.01184},
        {-0.05917, 0.10255, 0.01424},
        {0.14422, -0.24482, -0.03045},
        {-0.14431, 0.24533, 0.03358},
        {0.00526, -0.00846, -0.04201},
        {-0.00535, 0.0087, 0.04301},
        {0.20277, -0.34588, -0.03877},
        {-0.20392, 0.34892, 0.05174},
        {0.06409, -0.1101, -0.05243},
        {-0.06466, 0.11165, 0.05881},
        {0.14925, -0.25275, -0.07054},
        {-0.1499, 0.25459, 0.07868}}},
      {1e-4,
       {-653.6, 27.13, -262.18},
       false,
       {{-163, 412, 146}, {-608, 479, 218}, {-248, 166, 95}, {-86, 248, 166}, {-62, 226, 107}, {-82, 142, 110}},
       {{0.0575, -0.10171, -0.01316},
        {-0.05785, 0.10218, 0.01337},
        {0.14327, -0.24378, -0.03291},
        {-0.14372, 0.24434, 0.03338},
        {0.00734, -0.01037, -0.04158},
        {-0.00734, 0.01036, 0.04158},
        {0.20029, -0.34486, -0.04571},
        {-0.20203, 0.34715, 0.04711},
        {0.06478, -0.112, -0.05472},
        {-0.06524, 0.11262, 0.05497},
        {0.15055, -0.25407, -0.07449},
        {-0.15111, 0.25478, 0.07495}}},
      {1e-4,
       {0, 0, 0},
       true,
       {{178, 178, 80}, {189, -163, 369}, {-249, -360, 111}, {301, -408, 417}, {-134, 55, 160}, {150, -497, 400}},
       {{0.05697, -0.102, -0.0129},
        {-0.05662, 0.1014, 0.01274},
        {0.14627, -0.24303, -0.03247},
        {-0.14566, 0.24197, 0.03215},
        {0.00321, -0.01226, -0.04464},
        {-0.0032, 0.01225, 0.04464},
        {0.20272, -0.34413, -0.04517},
        {-0.20281, 0.34429, 0.04509},
        {0.06024, -0.11437, -0.05755},
        {-0.05976, 0.11355, 0.05737},
        {0.14947, -0.25528, -0.07706},
        {-0.14887, 0.25424, 0.07683}}}};
  const Vector3 scales[] = {{1, 0, 0}, {-1, 0, 0},  {0, 1, 0}, {0, -1, 0},  {0, 0, 1}, {0, 0, -1},
                            {1, 1, 0}, {-1, -1, 0}, {1, 0, 1}, {-1, 0, -1}, {0, 1, 1}, {0, -1, -1}};
  StationOptions unweighted;  // the reference weighs all lengths alike
  unweighted.ranging.per_length = RelativeLength::um_per_m(0.0);
  for (const Fixture& f : fixtures)
    for (std::size_t row = 0; row < 12; ++row) {
      SCOPED_TRACE(testing::Message() << "e " << f.e << (f.linear ? ", linear" : ", refined") << ", row " << row);
      const auto points = scaled_machine(f, scales[row]);
      const auto location = located(points, unweighted);
      ASSERT_TRUE(location.linear);
      expect_near(f.linear ? location.linear->station_mm : location.refined.station_mm, f.predicted[row], 6e-6);
    }
}

// Golden: first-order formulas of the same reference, against differences of the estimators themselves.
TEST(Station, SmallProportionalErrorsFollowTheFirstOrderFormulas) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double e = 1e-8;
    const Vector3 origin{-653.6, 27.13, -262.18};
    Vector3 scale{};
    scale[axis] = 1.0;
    Fixture f{e, origin, true, {}, {}};
    for (Vector3 p : six) f.points.push_back(p - station);
    const auto location = located(scaled_machine(f, scale));
    const auto exact = solve_linear(scaled_machine({0.0, origin, true, f.points, {}}, scale));
    Minimum truth;
    truth.L0_mm = 100.0;
    const auto refined = describe(scaled_machine({0.0, origin, true, f.points, {}}, scale), {}, truth);
    Vector3 linear{}, nonlinear{};
    for (std::size_t i = 0; i < six.size(); ++i) {
      const Vector3 u = unit(f.points[i]);
      const double error = e * (f.points[i][axis] - origin[axis]) * u[axis];  // of the length
      linear += error * exact.gain[i];
      nonlinear += error * refined.gain[i];
    }
    expect_near(location.linear->station_mm, linear, 1e-4 * norm(linear) + 1e-11);
    expect_near(location.refined.station_mm, nonlinear, 1e-4 * norm(nonlinear) + 1e-11);
  }
}

TEST(Station, CovarianceAndChiSquaredDescribeNoisyLengths) {
  constexpr std::size_t trials = 500;
  std::vector<double> noise(trials * six.size());
  numeric::fill_normal({.seed = 7, .stream = 1, .block = 0}, noise);
  double squares = 0.0, chi = 0.0, linear_squares = 0.0;
  std::size_t inside = 0;
  for (std::size_t t = 0; t < trials; ++t) {
    auto points = measured(six);
    const StationOptions options{.ranging = {Length::um(2.0), RelativeLength::um_per_m(0.0)}};  // σ = 1 µm
    for (std::size_t i = 0; i < six.size(); ++i) points[i].length_difference_mm += 1e-3 * noise[t * six.size() + i];
    const auto location = located(points, options);
    const Vector3 error = location.refined.station_mm - station;
    EXPECT_LT(norm(error), 0.02);
    for (std::size_t k = 0; k < 3; ++k) {
      squares += error[k] * error[k] / location.refined.covariance_stated_mm2[k][k];
      const double linear_error = location.linear->station_mm[k] - station[k];
      linear_squares += linear_error * linear_error / location.linear->covariance_mm2[k][k];
      inside += std::abs(error[k]) < 1.96 * std::sqrt(location.refined.covariance_mm2[k][k]) ? 1 : 0;
    }
    chi += location.refined.chi_squared;
  }
  // 1500 z-scores, correlated by threes: their mean square is 1 within 4·√(2/500); χ² of ν = 2 likewise
  EXPECT_NEAR(squares / (3.0 * trials), 1.0, 0.25);
  EXPECT_NEAR(linear_squares / (3.0 * trials), 1.0, 0.25);
  EXPECT_NEAR(chi / trials, 2.0, 0.36);
  EXPECT_NEAR(static_cast<double>(inside) / (3.0 * trials), 0.97, 0.02);
}

TEST(Station, PointsOnAPlaneLeaveTwoStations) {
  const std::vector<Vector3> flat = {{100, 100, 600}, {900, 150, 600}, {850, 700, 600},
                                     {120, 650, 600}, {500, 300, 600}, {400, 800, 600}};
  const Vector3 mirror{station.x, station.y, 1200 - station.z};
  const auto location = located(measured(flat));
  EXPECT_EQ(location.surface, CriticalSurface::plane);
  EXPECT_EQ(location.linear->rank, 4);
  EXPECT_GT(location.linear->condition, 1e9);
  expect_near(location.refined.station_mm, station, 1e-6);
  ASSERT_TRUE(location.refined.mirror_mm);
  expect_near(*location.refined.mirror_mm, mirror, 1e-6);
  EXPECT_TRUE(location.is_serious());
  EXPECT_TRUE(says(location, "! station-mirror-image: the lengths fit"));
  EXPECT_TRUE(says(location, "the lower was taken"));

  const auto near = located(measured(flat), {.near_mm = Vector3{600, 0, 1000}});
  expect_near(near.refined.station_mm, mirror, 1e-6);
  EXPECT_FALSE(near.is_serious()) << messages(near);
}

/// Of thousands only some show where minima are; what is found is that of all.
TEST(Station, ThousandsOfPointsOnAPlaneLeaveTwoStationsAsWell) {
  std::vector<Vector3> grid;
  for (int i = 0; i < 70; ++i)
    for (int k = 0; k < 70; ++k) grid.push_back({100.0 + 12.0 * i, 50.0 + 10.0 * k, 600.0});
  const auto location = located(measured(grid));
  expect_near(location.refined.station_mm, station, 1e-6);
  ASSERT_TRUE(location.refined.mirror_mm);
  expect_near(*location.refined.mirror_mm, {station.x, station.y, 1200 - station.z}, 1e-6);
  EXPECT_EQ(location.refined.residuals_mm.size(), grid.size());
}

TEST(Station, APlaneOfMicrometresIsCriticalAsWell) {
  std::vector<Vector3> flat = {{100, 100, 600.001}, {900, 150, 599.999}, {850, 700, 600.001},
                               {120, 650, 600},     {500, 300, 599.999}, {400, 800, 600}};
  const auto location = located(measured(flat));
  EXPECT_EQ(location.linear->numerical_rank, 5);
  EXPECT_EQ(location.linear->rank, 4);
  EXPECT_EQ(location.surface, CriticalSurface::plane);
}

/// Points with L = k + e·(p − s)·axis in directions all around: on a quadric with the focus s.
std::vector<Vector3> on_quadric(double eccentricity, double k) {
  const Vector3 axis = unit({0.3, -0.2, 0.9});
  const Vector3 beams[] = {{0.6, 0.1, 0.7}, {-0.5, 0.3, 0.6},  {0.1, -0.7, 0.5},
                           {0.2, 0.6, 0.9}, {-0.3, -0.4, 0.8}, {0.8, -0.3, 0.2}};
  std::vector<Vector3> points;
  for (Vector3 beam : beams) {
    const Vector3 u = unit(beam);
    points.push_back(station + k / (1.0 - eccentricity * dot(u, axis)) * u);
  }
  return points;
}

TEST(Station, QuadricsWithTheirFocusAtTheStationAreNamed) {
  const auto sphere = located(measured(on_quadric(0.0, 500)));
  EXPECT_EQ(sphere.surface, CriticalSurface::sphere);
  EXPECT_EQ(sphere.linear->rank, 4);
  expect_near(sphere.refined.station_mm, station, 1e-6);
  const auto ellipsoid = located(measured(on_quadric(0.4, 400)));
  EXPECT_EQ(ellipsoid.surface, CriticalSurface::ellipsoid);
  EXPECT_NEAR(ellipsoid.eccentricity.value_or(0), 0.4, 1e-6);
  expect_near(ellipsoid.refined.station_mm, station, 1e-6);
  const auto paraboloid = located(measured(on_quadric(1.0, 100)));
  EXPECT_EQ(paraboloid.surface, CriticalSurface::paraboloid);
  expect_near(paraboloid.refined.station_mm, station, 1e-6);
  EXPECT_TRUE(says(paraboloid, "eq. 14 has rank 4 of 5"));
}

TEST(Station, AHyperboloidHasTheStationAtEitherFocus) {
  // the sheet around the focus: k < 0 with beams for which 1 − e·cos < 0
  const Vector3 axis{0, 0, 1};
  const double e = 3.0, k = -600;
  const Vector3 beams[] = {{0.3, 0.1, 0.7}, {-0.5, 0.3, 0.8},  {0.1, -0.6, 0.6},
                           {0.2, 0.4, 0.9}, {-0.3, -0.4, 0.8}, {0.5, -0.3, 0.6}};
  std::vector<Vector3> points;
  for (Vector3 beam : beams) {
    const Vector3 u = unit(beam);
    ASSERT_LT(1.0 - e * dot(u, axis), -0.3);
    points.push_back(station + k / (1.0 - e * dot(u, axis)) * u);
  }
  const auto location = located(measured(points), {.near_mm = station + Vector3{20, 30, -40}});
  EXPECT_EQ(location.surface, CriticalSurface::hyperboloid);
  EXPECT_NEAR(location.eccentricity.value_or(0), 3.0, 1e-6);
  expect_near(location.refined.station_mm, station, 1e-6);
  ASSERT_TRUE(location.refined.mirror_mm);
  for (std::size_t i = 1; i < points.size(); ++i)
    EXPECT_NEAR(distance(points[i], *location.refined.mirror_mm) - distance(points[0], *location.refined.mirror_mm),
                distance(points[i], station) - distance(points[0], station), 1e-6);
}

TEST(Station, NoEstimatorKnowsTheStationBelowACone) {
  std::vector<Vector3> points;
  for (int i = 0; i < 7; ++i) {
    const double turn = 2.0 * std::numbers::pi * i / 7.0, length = 300.0 + 70.0 * i;
    points.push_back(station + length * Vector3{0.6 * std::cos(turn), 0.6 * std::sin(turn), 0.8});
  }
  std::vector<double> noise(points.size());
  numeric::fill_normal({.seed = 3, .stream = 1, .block = 0}, noise);
  for (const double size : {0.0, 1.5e-4}) {
    auto readings = measured(points);
    for (std::size_t i = 0; i < readings.size(); ++i) readings[i].length_difference_mm += size * noise[i];
    const auto location = located(readings);
    EXPECT_EQ(location.surface, CriticalSurface::cone);
    EXPECT_TRUE(location.is_serious());
    EXPECT_GT(location.refined.condition, 500.0);
    EXPECT_TRUE(says(location, "! station-points-on-cone: all beams lie on a cone")) << messages(location);
    EXPECT_TRUE(says(location, "half angle of 36.8")) << messages(location);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_TRUE(std::isfinite(location.refined.covariance_mm2[i][i]));
  }
}

TEST(Station, PointsOnOneLineAreNotCalledAPlane) {
  for (const double off_mm : {0.0, 1e-6}) {
    std::vector<Vector3> points;
    for (int k = 0; k < 8; ++k)
      points.push_back({100.0 + 70.0 * k, 200.0 + 35.0 * k + (k % 2) * off_mm, 300.0 - 20.0 * k});
    const auto location = located(measured(points));
    EXPECT_EQ(location.surface, CriticalSurface::line);
    EXPECT_TRUE(location.is_serious());
    EXPECT_TRUE(says(location, "station-points-on-line: all points lie on one line along")) << messages(location);
    EXPECT_FALSE(says(location, "plane")) << messages(location);
    EXPECT_FALSE(location.refined.mirror_mm);
  }
}

TEST(Station, NonsenseAsAPlaceDoesNotDisturb) {
  for (const Vector3 near : {station + Vector3{50, -50, 50}, Vector3{-1e5, 3e4, 2e5}, six[0], Vector3{0, 0, 0}}) {
    const auto location = located(measured(six), {.near_mm = near});
    expect_near(location.refined.station_mm, station, 1e-9);
  }
}

TEST(Station, AStationFarFromWhereItWasSaidToBeIsTold) {
  const auto mistaken = located(measured(six), {.near_mm = Vector3{station.x, station.y, station.z - 2000}});
  EXPECT_TRUE(says(mistaken, "the station is 2000 mm from where it was said to stand")) << messages(mistaken);
  const auto rough = located(measured(six), {.near_mm = station + Vector3{20, -30, 10}});
  EXPECT_FALSE(says(rough, "from where it was said to stand")) << messages(rough);
}

TEST(Station, FewPointsAreAFindingAndThreeAnError) {
  const auto five = located(measured(std::span(six).first(5)));
  expect_near(five.refined.station_mm, station, 1e-6);
  EXPECT_EQ(five.refined.degrees_of_freedom, 1);
  EXPECT_TRUE(says(five, "found 5 different points, expected 6 or more"));
  const auto four = located(measured(std::span(six).first(4)), {.near_mm = station + Vector3{10, 10, 10}});
  expect_near(four.refined.station_mm, station, 1e-6);
  EXPECT_FALSE(four.linear);
  EXPECT_TRUE(four.is_serious());
  EXPECT_NE(error_of(measured(std::span(six).first(3))).find("found 3 different points, expected 6"),
            std::string::npos);
  EXPECT_NE(error_of(std::span<const LocationPoint>{}).find("found 0 different points"), std::string::npos);
  const std::vector<LocationPoint> one_place(6, LocationPoint{{1, 2, 3}, 4});
  EXPECT_NE(error_of(one_place).find("found 1 different point,"), std::string::npos);
}

TEST(Station, RepeatedPointsAreChecksOfTheLengths) {
  auto points = measured(six);
  points.push_back(points[1]);
  points.back().length_difference_mm += 0.0001;
  EXPECT_TRUE(says(located(points), "station-repeated-point: point 7 stands where point 2 stood"));
  points.back().length_difference_mm += 0.3;
  const auto broken = located(points);
  EXPECT_TRUE(says(broken, "the beam was broken or the reflector moved"));
  EXPECT_TRUE(broken.is_serious());
}

TEST(Station, LengthsInAnotherUnitOrSignAreRefused) {
  auto points = measured(six);
  for (LocationPoint& p : points) p.length_difference_mm *= 1000.0;
  EXPECT_NE(error_of(points).find("the lengths fit when they are read in µm"), std::string::npos) << error_of(points);
  for (LocationPoint& p : points) p.length_difference_mm *= 1e-6;
  EXPECT_NE(error_of(points).find("they fit when they are read in m"), std::string::npos) << error_of(points);
  points = measured(six);
  for (LocationPoint& p : points) p.length_difference_mm /= 25.4;
  EXPECT_NE(error_of(points).find("they fit when they are read in in"), std::string::npos) << error_of(points);
  points = measured(six);
  for (LocationPoint& p : points) p.length_difference_mm *= -1.0;
  EXPECT_NE(error_of(points).find("with the other sign"), std::string::npos) << error_of(points);
  EXPECT_NE(error_of(measured(six, {653'600, -27'130, 262'180})).find("are units mixed up"), std::string::npos)
      << error_of(measured(six, {653'600, -27'130, 262'180}));
}

TEST(Station, LengthsThatNoTriangleHasAreRefused) {
  auto points = measured(six);
  points[2].length_difference_mm += 2000.0;
  const std::string error = error_of(points);
  EXPECT_NE(error.find("expected at most the distance of the points"), std::string::npos) << error;
  EXPECT_NE(error.find("points 3 and"), std::string::npos) << error;
}

TEST(Station, AMisreadLengthIsNamed) {
  std::vector<Vector3> eight = six;
  eight.push_back({760, -120, 820});
  eight.push_back({350, 260, 410});
  for (const double error : {0.5, -5.0}) {
    auto points = measured(eight);
    points[4].length_difference_mm += error;
    const auto location = located(points);
    EXPECT_TRUE(says(location, "the length of point 5 being")) << messages(location);
    EXPECT_TRUE(location.is_serious());
  }
}

// Of many points some show which reading does not fit; the one that does is found as among a few.
TEST(Station, LengthsOfManyPointsInAnotherUnitOrSignAreRefused) {
  std::vector<Vector3> grid;
  for (int i = 0; i < 9; ++i)
    for (int j = 0; j < 9; ++j)
      for (int k = 0; k < 9; ++k) grid.push_back({100.0 * i, 90.0 * j, 70.0 * k + i});
  const std::vector<LocationPoint> right = measured(grid);
  const auto read_as = [&](double factor) {
    auto points = right;
    for (LocationPoint& p : points) p.length_difference_mm *= factor;
    return error_of(points);
  };
  EXPECT_NE(read_as(1000.0).find("read in µm"), std::string::npos) << read_as(1000.0);
  EXPECT_NE(read_as(0.001).find("read in m"), std::string::npos) << read_as(0.001);
  EXPECT_NE(read_as(25.4).find("coordinates in inches"), std::string::npos) << read_as(25.4);
  EXPECT_NE(read_as(-1.0).find("with the other sign"), std::string::npos) << read_as(-1.0);
  EXPECT_EQ(read_as(1.7).find("fit when they are read"), std::string::npos) << read_as(1.7);
}

// Above 5 000 points only neighbours in the file are held against the distance of their points.
TEST(Station, ABreakAmongThousandsOfPointsIsFound) {
  std::vector<Vector3> many;
  for (std::size_t k = 0; k < 6'000; ++k) {
    const double t = static_cast<double>(k);
    many.push_back({500.0 + 300.0 * std::sin(0.7 * t), 250.0 * std::cos(1.1 * t), 500.0 + 300.0 * std::sin(1.9 * t)});
  }
  auto points = measured(many);
  for (std::size_t k = 3'000; k < points.size(); ++k) points[k].length_difference_mm += 0.5;
  const auto location = located(points);
  EXPECT_TRUE(says(location, "station-misreading: ")) << messages(location);
  EXPECT_TRUE(says(location, "all lengths from point 3001 on being 0.5000 mm too long")) << messages(location);
}

// Six points have one redundant length once a misread one is taken out: errors of some µm that no one stated look like
// a length misread by more than 20 µm now and then, which is no reason not to use the station.
TEST(Station, ErrorsOfAnOrdinaryMachineAreNoSeriousMisreading) {
  for (const std::array<double, 6>& errors_um :
       {std::array{5.0, 9.0, -4.0, 4.0, 0.0, 9.0}, std::array{7.0, -2.0, 13.0, 5.0, 4.0, -15.0}}) {
    auto points = measured(six);
    for (std::size_t i = 0; i < six.size(); ++i) points[i].length_difference_mm += 1e-3 * errors_um[i];
    const auto location = located(points);
    EXPECT_TRUE(says(location, "would explain the residuals")) << messages(location);
    EXPECT_FALSE(location.is_serious()) << messages(location);
  }
  auto points = measured(six);
  points[2].length_difference_mm += 0.3;
  EXPECT_TRUE(located(points).is_serious());
}

TEST(Station, ABrokenBeamIsFoundWithTheStationWithoutIt) {
  std::vector<Vector3> nine = six;
  nine.push_back({760, -120, 820});
  nine.push_back({350, 260, 410});
  nine.push_back({820, 120, 950});
  auto points = measured(nine);
  for (std::size_t i = 4; i < points.size(); ++i) points[i].length_difference_mm -= 0.8;
  const auto location = located(points);
  EXPECT_TRUE(says(location, "all lengths from point 5 on being 0.8000 mm too short")) << messages(location);
  EXPECT_TRUE(says(location, "(653.600, \u221227.130, 262.180) mm")) << messages(location);
}

TEST(Station, ErrorsOfTheMachineInflateTheCovarianceAndSeparateTheEstimators) {
  Fixture f{1e-3, {-653.6, 27.13, -262.18}, true, {}, {}};
  for (Vector3 p : six) f.points.push_back(p - station);
  const auto location = located(scaled_machine(f, {1, 0.3, 0}));
  EXPECT_GT(location.refined.inflation, 100.0);
  EXPECT_TRUE(says(location, "what the stated uncertainties explain"));
  EXPECT_TRUE(says(location, "station-estimators-apart: the linear and the refined station are")) << messages(location);
}

TEST(Station, NumbersThatAreNoneAreRefused) {
  auto points = measured(six);
  points[3].at_mm.y = std::nan("");
  EXPECT_NE(error_of(points).find("at point 4"), std::string::npos);
  points = measured(six);
  points[0].length_difference_mm = 1e300;
  EXPECT_NE(error_of(points).find("at point 1"), std::string::npos);
  EXPECT_NE(error_of(measured(six), {.ranging = {Length::um(0), RelativeLength::um_per_m(0)}}).find("above 0"),
            std::string::npos);
  EXPECT_NE(error_of(measured(six), {.ranging = {Length::um(-1), RelativeLength::um_per_m(0)}}).find("0 or more"),
            std::string::npos);
}

}  // namespace
}  // namespace axiometry::tracking
