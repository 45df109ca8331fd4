// SPDX-License-Identifier: Apache-2.0
#include "axiometry/tracking/polar/polar_network.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "axiometry/tracking/instruments/tracker_kinds.h"
#include "axiometry/tracking/ranges/multilateration.h"

namespace axiometry::tracking {
namespace {

constexpr double arcsec = std::numbers::pi / 648000.0;

/// What an instrument at `station`, turned by `azimuth` about z, reads of a point.
PolarReading polar_read(std::size_t point, std::size_t station, Vector3 at, Vector3 from, double azimuth) {
  const Vector3 way = at - from;
  const double d = norm(way);
  return {point, station,
          0,     d,
          0.01,  direction_of(std::atan2(way.y, way.x) - azimuth, std::asin(way.z / d), 4 * arcsec, 4 * arcsec)};
}

const std::vector<Vector3> places = {{0, 0, 0},      {800, 0, 50},   {0, 600, 100},   {800, 600, 0},   {0, 0, 400},
                                     {800, 50, 450}, {10, 600, 500}, {800, 600, 420}, {400, 300, 200}, {420, 100, 300}};

TEST(PolarPoint, IsEquation1WithItsDerivatives) {
  // By hand: d = 2000 mm, α = 30°, β = 0: the beam in the plane, u(d) 0.02 mm, angles 1e-5 rad: 0.02 mm across.
  const PolarPoint p = polar_point(2000.0, 0.02, direction_of(std::numbers::pi / 6, 0.0, 1e-5, 2e-5));
  EXPECT_NEAR(p.at_mm.x, 1732.0508075688772, 1e-9);
  EXPECT_NEAR(p.at_mm.y, 1000.0, 1e-9);
  EXPECT_NEAR(p.at_mm.z, 0.0, 1e-12);
  EXPECT_NEAR(p.covariance_mm2[0][0], 4e-4, 1e-12);  // along and sideways alike: the same in every direction
  EXPECT_NEAR(p.covariance_mm2[0][1], 0.0, 1e-12);
  EXPECT_NEAR(p.covariance_mm2[2][2], 16e-4, 1e-12);
}

TEST(PolarPoint, OfTheZenithIsAsGoodSidewaysAsTheElevationIs) {
  const PolarPoint p = polar_point(1000.0, 0.001, direction_of(1.0, std::numbers::pi / 2, 0.5, 1e-5));
  EXPECT_NEAR(p.at_mm.z, 1000.0, 1e-9);
  EXPECT_LT(p.covariance_mm2[0][0] + p.covariance_mm2[1][1], 2e-4);
}

TEST(PolarNetwork, OfOneStationIsEquation1) {
  std::vector<PolarReading> readings;
  for (std::size_t i = 0; i < 4; ++i) readings.push_back(polar_read(i, 0, places[i + 1], {-900, -800, 100}, 0.0));
  const auto fit = adjust_polar(4, 1, readings, {});
  ASSERT_TRUE(fit) << fit.error().message;
  for (std::size_t i = 0; i < 4; ++i) {
    const PolarPoint p = polar_point(readings[i].length_mm, readings[i].length_sigma_mm, *readings[i].direction);
    EXPECT_LT(distance(fit->points_mm[i], p.at_mm), 1e-9);
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t b = 0; b < 3; ++b)
        EXPECT_NEAR(fit->covariances_mm2[i][a][b], p.covariance_mm2[a][b], 1e-12) << i << a << b;
  }
  EXPECT_EQ(fit->degrees_of_freedom(), 0u);
  EXPECT_NEAR(fit->told_by_angles, 8.0, 1e-9);
}

TEST(PolarNetwork, FindsStationsThatAreTurnedAndAnInterferometerBesideThem) {
  std::vector<PolarReading> readings;
  const Vector3 second{1700, -500, 300}, third{300, 1500, -200};
  for (std::size_t i = 0; i < places.size(); ++i) {
    readings.push_back(polar_read(i, 0, places[i], {}, 0.0));
    if (i == 0) readings.back() = polar_read(0, 1, places[0], second, 2.5);  // not seen from the first
    if (i > 2) readings.push_back(polar_read(i, 1, places[i], second, 2.5));
    readings.push_back({i, 2, i > 6 ? 1u : 0u, distance(places[i], third) - (i > 6 ? 700.0 : 1234.5), 0.0005, {}});
  }
  const auto fit = adjust_polar(places.size(), 3, readings, {});
  ASSERT_TRUE(fit) << fit.error().message;
  for (std::size_t i = 0; i < places.size(); ++i) EXPECT_LT(distance(fit->points_mm[i], places[i]), 1e-6) << i;
  EXPECT_LT(distance(fit->stations[1].position_mm, second), 1e-6);
  EXPECT_NEAR(fit->stations[1].turn[0][0], std::cos(2.5), 1e-9);
  EXPECT_NEAR(fit->stations[1].turn[1][0], std::sin(2.5), 1e-9);
  EXPECT_NEAR(fit->stations[2].dead_paths_mm[0], 1234.5, 1e-6);
  EXPECT_NEAR(fit->stations[2].dead_paths_mm[1], 700.0, 1e-6);
  EXPECT_NEAR(fit->told_by_lengths + fit->told_by_angles, static_cast<double>(fit->unknowns), 1e-6);
  EXPECT_EQ(norm(fit->stations[0].position_mm), 0.0);
  EXPECT_EQ(fit->stations[0].covariance_mm2, Matrix3{}) << "of the datum not even rounding";
}

/// Two trackers of unequal uncertainty and an interferometer on six points, ν = 14: coordinates within 2 u, in 95.45 %
/// of sets before χ²/ν enlarges u.
TEST(PolarNetwork, StatesCovariancesThatHoldTheTruth) {
  std::mt19937_64 random(21);
  std::normal_distribution<double> normal;
  const Vector3 stations[] = {{}, {1700, -500, 300}, {300, 1500, -200}};
  std::size_t inside = 0, all = 0, stations_inside = 0, stations_all = 0;
  double ratio = 0.0;
  constexpr int sets = 400;
  for (int set = 0; set < sets; ++set) {
    std::vector<PolarReading> readings;
    for (std::size_t i = 0; i < 6; ++i) {
      for (std::size_t j = 0; j < 2; ++j) {
        PolarReading& r = readings.emplace_back(polar_read(i, j, places[i + 4], stations[j], j == 0 ? 0.0 : 2.5));
        r.length_mm += r.length_sigma_mm * normal(random);
        const double azimuth = r.direction->azimuth_rad, elevation = r.direction->elevation_rad;
        const double sideways = (j == 0 ? 4 : 1) * arcsec, upwards = (j == 0 ? 1 : 6) * arcsec;
        r.direction =
            direction_of(azimuth + sideways * normal(random), elevation + upwards * normal(random), sideways, upwards);
      }
      readings.push_back({i, 2, 0, distance(places[i + 4], stations[2]) - 900.0 + 0.0005 * normal(random), 0.0005, {}});
    }
    const auto fit = adjust_polar(6, 3, readings, {});
    ASSERT_TRUE(fit) << fit.error().message;
    const double factor = fit->variance_factor();
    ratio += fit->chi_squared / static_cast<double>(fit->degrees_of_freedom()) / sets;
    const auto is_inside = [factor](Vector3 found, Vector3 truth, const Matrix3& covariance, std::size_t k) {
      return std::abs(found[k] - truth[k]) <= 2.0 * std::sqrt(covariance[k][k] / factor);
    };
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t i = 0; i < 6; ++i, ++all)
        inside += is_inside(fit->points_mm[i], places[i + 4], fit->covariances_mm2[i], k);
      for (std::size_t j = 1; j < 3; ++j, ++stations_all)
        stations_inside += is_inside(fit->stations[j].position_mm, stations[j], fit->stations[j].covariance_mm2, k);
    }
  }
  EXPECT_NEAR(ratio, 1.0, 0.08);
  EXPECT_NEAR(static_cast<double>(inside) / static_cast<double>(all), 0.9545, 0.015);
  EXPECT_NEAR(static_cast<double>(stations_inside) / static_cast<double>(stations_all), 0.9545, 0.025);
}

/// An angle of 60″ at 2 m is worth 0.6 mm beside lengths of 0.3 µm: the normal equations of the stations have fewer
/// digits than a double then, and the points move on spheres. All such sets have a solution, by an independent solver
/// too.
TEST(PolarNetwork, SolvesWhatBadAnglesAndGoodLengthsTell) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  const Vector3 stations[] = {{-900, -800, 100}, {1700, -500, 300}, {300, 1500, -200}, {1500, 1300, 900}};
  std::size_t inside = 0, all = 0;
  double ratio = 0.0;
  constexpr int sets = 60;
  for (int set = 0; set < sets; ++set) {
    const double angle = 60 * arcsec, length = 0.0003;
    std::vector<PolarReading> readings;
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t j = 0; j < 4; ++j) {
        PolarReading& r = readings.emplace_back(polar_read(i, j, places[i + 4], stations[j], 0.0));
        r.length_sigma_mm = length;
        r.length_mm += length * normal(random) - (j == 0 ? 0.0 : 400.0);
        if (j > 0) {
          r.direction.reset();
          continue;
        }
        const double azimuth = r.direction->azimuth_rad, elevation = r.direction->elevation_rad;
        r.direction = direction_of(azimuth + angle * normal(random), elevation + angle * normal(random), angle, angle);
      }
    const auto fit = adjust_polar(6, 4, readings, {});
    ASSERT_TRUE(fit) << set << ": " << fit.error().message;
    ratio += fit->chi_squared / static_cast<double>(fit->degrees_of_freedom()) / sets;
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t k = 0; k < 3; ++k, ++all)
        inside += std::abs(fit->points_mm[i][k] - (places[i + 4] - stations[0])[k]) <=
                  2.0 * std::sqrt(fit->covariances_mm2[i][k][k] / fit->variance_factor());
  }
  EXPECT_NEAR(ratio, 1.0, 0.2);
  EXPECT_NEAR(static_cast<double>(inside) / static_cast<double>(all), 0.9545, 0.03);
}

TEST(PolarNetwork, RefusesLengthsOfPointsOnOneLine) {
  std::vector<PolarReading> readings;
  const Vector3 from{-900, -800, 100}, other{1700, -500, 300};
  for (std::size_t i = 0; i < 8; ++i) {
    const Vector3 at{100.0 * static_cast<double>(i * i), 0, 0};
    readings.push_back(polar_read(i, 0, at, from, 0.0));
    readings.push_back({i, 1, 0, distance(at, other) - 400.0, 0.0003, {}});
  }
  const auto fit = adjust_polar(8, 2, readings, {});
  ASSERT_FALSE(fit) << "the station may stand anywhere on a circle about the line";
  EXPECT_TRUE(fit.error().message.starts_with("found readings that leave 1 direction of the stations undetermined"))
      << fit.error().message;
}

TEST(PolarNetwork, OfLengthsAloneIsMultilateration) {
  const std::vector<Vector3> stations = {
      {-700, -600, 100}, {1500, -500, 300}, {300, 1500, -200}, {1400, 1200, 900}, {-500, 1000, 800}};
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0.0, 0.001);
  std::vector<PolarReading> readings;
  std::vector<RangeReading> ranges;
  for (std::size_t j = 0; j < stations.size(); ++j)
    for (std::size_t i = 0; i < places.size(); ++i) {
      const double l = distance(places[i], stations[j]) - 500.0 + noise(random);
      readings.push_back({i, j, 0, l, 0.001, {}});
      ranges.push_back({.point = i, .station = j, .length_mm = l, .segment = 0});
    }
  PolarOptions options;
  options.datum = PolarDatum::nominal;
  options.nominal_mm = places;
  const auto fit = adjust_polar(places.size(), stations.size(), readings, options);
  ASSERT_TRUE(fit) << fit.error().message;
  MultilaterationOptions other;
  other.ranging = {Length::um(2.0), RelativeLength::um_per_m(0.0)};
  const auto expected = multilaterate(places, stations.size(), ranges, other);
  ASSERT_TRUE(expected) << expected.error().message;
  EXPECT_NEAR(fit->chi_squared, expected->chi_squared, 1e-6);
  EXPECT_EQ(fit->degrees_of_freedom(), expected->degrees_of_freedom);
  for (std::size_t i = 0; i < places.size(); ++i) {
    EXPECT_LT(distance(fit->points_mm[i], expected->points_mm[i]), 1e-6);
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t b = 0; b < 3; ++b)
        EXPECT_NEAR(fit->covariances_mm2[i][a][b], expected->point_covariances_mm2[i][a][b], 1e-10);
  }
  for (std::size_t j = 0; j < stations.size(); ++j)
    EXPECT_NEAR(fit->stations[j].covariance_mm2[2][2], expected->station_covariances_mm2[j][2][2], 1e-9);
}

TEST(PolarNetwork, RefusesAStationThatSharesTwoPointsAndAPointOfOneLength) {
  std::vector<PolarReading> readings;
  for (std::size_t i = 0; i < 5; ++i) readings.push_back(polar_read(i, 0, places[i], {-900, -800, 100}, 0.0));
  for (std::size_t i = 3; i < 5; ++i) readings.push_back(polar_read(i, 1, places[i], {1700, -500, 300}, 1.0));
  const auto two = adjust_polar(5, 2, readings, {});
  ASSERT_FALSE(two);
  EXPECT_NE(two.error().message.find("fewer than three points"), std::string::npos) << two.error().message;
  readings.resize(5);
  readings.push_back({5, 0, 0, 1000.0, 0.01, {}});
  const auto open = adjust_polar(6, 1, readings, {});
  ASSERT_FALSE(open);
  EXPECT_NE(open.error().message.find("without angles"), std::string::npos) << open.error().message;
}

TEST(PolarNetwork, TellsAReadingThatDoesNotFit) {
  std::vector<PolarReading> readings;
  for (std::size_t i = 0; i < places.size(); ++i) {
    readings.push_back(polar_read(i, 0, places[i], {-900, -800, 100}, 0.0));
    readings.push_back(polar_read(i, 1, places[i], {1700, -500, 300}, 1.0));
  }
  readings[6].direction->azimuth_rad += 100 * arcsec;
  const auto fit = adjust_polar(places.size(), 2, readings, {});
  ASSERT_TRUE(fit);
  EXPECT_TRUE(std::ranges::any_of(fit->findings, [](const Finding& f) {
    return f.serious && f.id == "polar-outliers" &&
           f.message.starts_with("the azimuth of reading 7 (station 1, point 4) does not fit the others");
  }));
  readings[6].direction->azimuth_rad -= 100 * arcsec;
  EXPECT_TRUE(adjust_polar(places.size(), 2, readings, {})->findings.size() <= 1);  // that they fit better than stated
}

/// The other way along the same line: what a beam reads that looks away from the point.
void turn_round(PolarDirection& direction) {
  direction.azimuth_rad += std::numbers::pi;
  direction.elevation_rad = -direction.elevation_rad;
}

TEST(PolarNetwork, RefusesAReadingThatLooksAwayFromItsPoint) {
  std::vector<PolarReading> readings;
  for (std::size_t i = 0; i < places.size(); ++i) {
    readings.push_back(polar_read(i, 0, places[i], {-900, -800, 100}, 0.0));
    readings.push_back(polar_read(i, 1, places[i], {1700, -500, 300}, 1.0));
  }
  turn_round(*readings[5].direction);
  const auto fit = adjust_polar(places.size(), 2, readings, {});
  ASSERT_FALSE(fit) << fit->chi_squared;
  EXPECT_TRUE(fit.error().message.starts_with("found reading 6 (station 2, point 3) that looks away"))
      << fit.error().message;
}

TEST(PolarNetwork, RefusesANominalPlaceBehindTheInstrument) {
  std::vector<PolarReading> readings;
  for (std::size_t i = 0; i < places.size(); ++i)
    readings.push_back(polar_read(i, 0, places[i], {-900, -800, 100}, 0.0));
  turn_round(*readings[4].direction);
  PolarOptions options;
  options.datum = PolarDatum::nominal;
  options.nominal_mm = places;
  const auto fit = adjust_polar(places.size(), 1, readings, options);
  ASSERT_FALSE(fit);
  EXPECT_NE(fit.error().message.find("looks away from where the point comes out"), std::string::npos);
  EXPECT_NE(fit.error().message.find("or its nominal place"), std::string::npos) << fit.error().message;
}

TEST(PolarNetwork, RefusesNominalPlacesThatAreOthers) {
  const auto refusal = [](std::vector<Vector3> nominal, double sign) {
    std::vector<PolarReading> readings;
    for (std::size_t i = 0; i < places.size(); ++i) {
      Vector3 seen = places[i];
      const Vector3 from{-900, -800, 100};
      seen.y = from.y + sign * (seen.y - from.y);  // −1: azimuths count the other way
      readings.push_back(polar_read(i, 0, seen, from, 0.0));
    }
    PolarOptions options;
    options.datum = PolarDatum::nominal;
    options.nominal_mm = nominal;
    const auto fit = adjust_polar(places.size(), 1, readings, options);
    return fit ? std::string() : fit.error().message;
  };
  std::vector<Vector3> near = places;
  near[3] += Vector3{0.4, -0.3, 0.2};
  EXPECT_EQ(refusal(near, 1.0), "") << "a machine that errs by half a millimetre";
  std::vector<Vector3> exchanged = places;
  std::swap(exchanged[1], exchanged[6]);
  EXPECT_NE(refusal(exchanged, 1.0).find("are points exchanged"), std::string::npos) << refusal(exchanged, 1.0);
  EXPECT_NE(refusal(places, -1.0).find("count the other way"), std::string::npos) << refusal(places, -1.0);
}

TEST(PolarNetwork, NeedsNoNominalPlacesForTheFrameOfAStation) {
  std::vector<PolarReading> readings;
  for (std::size_t i = 0; i < 2; ++i) readings.push_back(polar_read(i, 0, places[i], {-900, -800, 100}, 0.0));
  PolarOptions options;
  options.nominal_mm = std::span(places).first(2);
  const auto fit = adjust_polar(2, 1, readings, options);
  ASSERT_TRUE(fit) << fit.error().message;
  EXPECT_LT(distance(fit->points_mm[1], places[1] - Vector3{-900, -800, 100}), 1e-9);
  options.datum = PolarDatum::nominal;
  const auto nominal = adjust_polar(2, 1, readings, options);
  ASSERT_FALSE(nominal);
  EXPECT_NE(nominal.error().message.find("that station 1 sees and that have nominal places"), std::string::npos)
      << nominal.error().message;
  options.datum = PolarDatum::station;
  readings[1].direction.reset();
  const auto open = adjust_polar(2, 1, readings, options);
  ASSERT_FALSE(open);
  EXPECT_NE(open.error().message.find("point 2 without angles, and no station that sees three nominal places"),
            std::string::npos)
      << open.error().message;
}

TEST(PolarNetwork, SaysWhenItDivergesInWhichIteration) {
  std::vector<PolarReading> readings;
  for (std::size_t i = 0; i < places.size(); ++i)
    for (std::size_t j = 0; j < 2; ++j) {
      PolarReading reading =
          polar_read(i, j, places[i], j == 0 ? Vector3{-900, -800, 100} : Vector3{1700, -500, 300}, 0.0);
      reading.length_sigma_mm = 1e-151;  // squares of what does not fit are beyond all numbers
      reading.direction->sideways_sigma_rad = reading.direction->upwards_sigma_rad = 1e-154;
      readings.push_back(reading);
    }
  readings[9].length_mm += 1e5;
  const auto fit = adjust_polar(places.size(), 2, readings, {});
  ASSERT_FALSE(fit);
  EXPECT_TRUE(fit.error().message.starts_with("the solution diverges in iteration 1, ")) << fit.error().message;
}

TEST(PolarNetwork, NamesTheReadingThatKeepsItFromSettling) {
  std::vector<PolarReading> readings;
  for (std::size_t i = 0; i < places.size(); ++i) {
    readings.push_back(polar_read(i, 0, places[i], {-900, -800, 100}, 0.0));
    readings.push_back(polar_read(i, 1, places[i], {1700, -500, 300}, 1.0));
  }
  readings[9].direction->elevation_rad -= 0.2;
  PolarOptions options;
  options.iterations_most = 1;  // nothing settles at once that is not exact
  const auto fit = adjust_polar(places.size(), 2, readings, options);
  ASSERT_FALSE(fit);
  EXPECT_NE(fit.error().message.find("is farthest from the others"), std::string::npos) << fit.error().message;
  EXPECT_NE(fit.error().message.find("point 5"), std::string::npos) << fit.error().message;
}

TEST(TrackerKinds, TakeBoundsAsRectangularAndWhatIsExpandedAsItIs) {
  const auto tracer = find_tracker("Etalon-LaserTRACER", LengthMode::changes);
  ASSERT_TRUE(tracer && *tracer);
  EXPECT_DOUBLE_EQ((*tracer)->length->expanded_uncertainty().standard_mm(1000.0), 0.25e-3);
  const auto leica = find_tracker("leica-at901", LengthMode::absolute);
  EXPECT_NEAR((*leica)->length->expanded_uncertainty().standard_mm(1000.0), 0.010 / std::sqrt(3.0), 1e-15);
  EXPECT_NEAR((*leica)->kind->across->expanded_uncertainty().standard_mm(2000.0), 0.027 / std::sqrt(3.0), 1e-15);
  EXPECT_EQ((*find_tracker("leica-at901", LengthMode::changes))->length->constant_um, 0.4);
  EXPECT_EQ((*find_tracker("leica-at901:adm", LengthMode::changes))->length->constant_um, 10.0);
  EXPECT_FALSE(find_tracker("leica-at402:ifm", LengthMode::changes));
  EXPECT_FALSE(*find_tracker("leica", LengthMode::changes));
  EXPECT_FALSE((*find_tracker("leica-at930", LengthMode::changes))->length);
}

}  // namespace
}  // namespace axiometry::tracking
