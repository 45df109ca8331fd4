// SPDX-License-Identifier: Apache-2.0
#include "axiometry/tracking/ranges/multilateration.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace axiometry::tracking {
namespace {

using testing::HasSubstr;

/// A machine of 1 m × 0.6 m × 0.5 m that errs by some µm, and stations around it.
struct Truth {
  std::vector<Vector3> nominal, points, stations;
  std::vector<double> dead, scales;
  std::vector<RangeReading> readings;
};

struct TruthOptions {
  std::size_t points = 60;
  std::size_t stations = 6;
  double sigma_mm = 0.0;  // of lengths
  double error_mm = 0.02;
  bool coplanar = false;
  double scale_sigma = 0.0;
  unsigned seed = 1;
};

Truth make_truth(const TruthOptions& o) {
  std::mt19937_64 random(o.seed);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::normal_distribution<double> normal;
  Truth truth;
  for (std::size_t i = 0; i < o.points; ++i) {
    truth.nominal.push_back({1000.0 * uniform(random), 600.0 * uniform(random), 500.0 * uniform(random)});
    truth.points.push_back(truth.nominal.back() + o.error_mm * Vector3{normal(random), normal(random), normal(random)});
  }
  for (std::size_t j = 0; j < o.stations; ++j) {
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(j) / static_cast<double>(o.stations);
    const double height = o.coplanar ? -100.0 : -300.0 + 900.0 * uniform(random);
    truth.stations.push_back({500.0 + (700.0 + 300.0 * uniform(random)) * std::cos(angle),
                              300.0 + (600.0 + 200.0 * uniform(random)) * std::sin(angle), height});
    truth.dead.push_back(200.0 + 100.0 * uniform(random));
    truth.scales.push_back(1.0 + o.scale_sigma * normal(random));
  }
  for (std::size_t j = 0; j < o.stations; ++j)
    for (std::size_t i = 0; i < o.points; ++i)
      truth.readings.push_back({.point = i,
                                .station = j,
                                .length_mm = truth.scales[j] * distance(truth.points[i], truth.stations[j]) -
                                             truth.dead[j] + o.sigma_mm * normal(random),
                                .segment = 0});
  return truth;
}

Result<MultilaterationFit> solve(const Truth& truth, const MultilaterationOptions& options = {}) {
  return multilaterate(truth.nominal, truth.stations.size(), truth.readings, options);
}

/// The same error everywhere, as U = a states it.
MultilaterationOptions with_sigma(double sigma_mm) {
  return {.ranging = {Length::mm(2.0 * sigma_mm), RelativeLength::um_per_m(0.0)}};
}

/// Largest difference of the distances between two sets: what no gauge changes.
double shape_difference(std::span<const Vector3> a, std::span<const Vector3> b) {
  double most = 0.0;
  for (std::size_t i = 1; i < a.size(); ++i)
    for (std::size_t k : {std::size_t{0}, i / 2, i - 1})
      most = std::max(most, std::abs(distance(a[i], a[k]) - distance(b[i], b[k])));
  return most;
}

std::string error_of(const Result<MultilaterationFit>& fit) { return fit ? "no error" : fit.error().message; }

TEST(Multilateration, recovers_points_and_stations_from_exact_lengths) {
  for (std::size_t stations : {4, 5, 6, 8}) {
    const Truth truth = make_truth({.stations = stations, .seed = static_cast<unsigned>(stations)});
    const auto fit = solve(truth);
    ASSERT_TRUE(fit) << error_of(fit);
    EXPECT_LT(shape_difference(fit->points_mm, truth.points), 1e-8) << stations;
    for (std::size_t j = 0; j < stations; ++j) EXPECT_NEAR(fit->dead_paths_mm[j].at(0), truth.dead[j], 1e-8);
    EXPECT_EQ(fit->rank.null_directions, 0u);
    EXPECT_LT(fit->chi_squared, 1e-8);
    for (double w : fit->residuals_mm) EXPECT_NEAR(w, 0.0, 1e-9);
  }
}

TEST(Multilateration, recovers_exact_lengths_with_free_scales_up_to_the_size) {
  const Truth truth = make_truth({.stations = 6, .scale_sigma = 1e-4, .seed = 3});
  const auto fit = solve(truth, {.scale = ScaleModel::free});
  ASSERT_TRUE(fit) << error_of(fit);
  EXPECT_EQ(fit->rank.gauge, 7u);
  const double size = distance(fit->points_mm[0], fit->points_mm[1]) / distance(truth.points[0], truth.points[1]);
  EXPECT_NEAR(size, 1.0, 1e-4);
  for (std::size_t j = 0; j < 6; ++j) EXPECT_NEAR(fit->scales[j] * size, truth.scales[j], 1e-10);
  std::vector<Vector3> sized;
  for (const Vector3& p : fit->points_mm) sized.push_back(1.0 / size * p);
  EXPECT_LT(shape_difference(sized, truth.points), 1e-7);
}

TEST(Multilateration, lays_the_result_onto_the_nominal_points_by_least_squares) {
  const Truth truth = make_truth({.sigma_mm = 1e-3, .seed = 4});
  const auto fit = solve(truth, with_sigma(1e-3));
  ASSERT_TRUE(fit) << error_of(fit);
  Vector3 shift{}, turn{};
  for (std::size_t i = 0; i < truth.nominal.size(); ++i) {
    const Vector3 off = fit->points_mm[i] - truth.nominal[i];
    shift += off;
    turn += cross(truth.nominal[i], off);
  }
  EXPECT_LT(norm(shift), 1e-8);
  EXPECT_LT(norm(turn), 1e-5);  // Σ of lever arms of 1 m times 60 points times rounding
}

TEST(Multilateration, follows_a_rigid_motion_of_the_nominal_points) {
  Truth truth = make_truth({.sigma_mm = 1e-3, .seed = 5});
  const auto before = solve(truth, with_sigma(1e-3));
  const double c = std::cos(0.7), s = std::sin(0.7);
  const auto move = [&](Vector3 p) {
    return Vector3{c * p.x - s * p.y + 5000.0, s * p.x + c * p.y - 300.0, p.z + 70.0};
  };
  for (Vector3& p : truth.nominal) p = move(p);
  const auto after = solve(truth, with_sigma(1e-3));
  ASSERT_TRUE(before && after);
  for (std::size_t i = 0; i < truth.points.size(); ++i)
    EXPECT_LT(distance(after->points_mm[i], move(before->points_mm[i])), 1e-8);
  for (std::size_t j = 0; j < truth.stations.size(); ++j) {
    EXPECT_LT(distance(after->stations_mm[j], move(before->stations_mm[j])), 1e-8);
    EXPECT_NEAR(after->station_covariances_mm2[j][2][2] / before->station_covariances_mm2[j][2][2], 1.0, 1e-6);
  }
  EXPECT_NEAR(after->chi_squared / before->chi_squared, 1.0, 1e-8);
}

TEST(Multilateration, takes_a_constant_of_a_stations_lengths_into_its_dead_path_alone) {
  Truth truth = make_truth({.sigma_mm = 1e-3, .seed = 6});
  const auto before = solve(truth, with_sigma(1e-3));
  for (RangeReading& r : truth.readings)
    if (r.station == 2) r.length_mm += 1234.5;
  const auto after = solve(truth, with_sigma(1e-3));
  ASSERT_TRUE(before && after);
  for (std::size_t i = 0; i < truth.points.size(); ++i)
    EXPECT_LT(distance(after->points_mm[i], before->points_mm[i]), 1e-8);
  for (std::size_t j = 0; j < truth.stations.size(); ++j)
    EXPECT_NEAR(after->dead_paths_mm[j][0], before->dead_paths_mm[j][0] - (j == 2 ? 1234.5 : 0.0), 1e-8);
}

TEST(Multilateration, does_not_depend_on_the_number_of_threads_or_the_order_of_points) {
  Truth truth = make_truth({.points = 5000, .stations = 5, .sigma_mm = 1e-3, .seed = 7});
  auto options = with_sigma(1e-3);
  options.threads = 1;
  const auto one = solve(truth, options);
  options.threads = 3;
  const auto three = solve(truth, options);
  ASSERT_TRUE(one && three);
  EXPECT_EQ(one->points_mm, three->points_mm);
  EXPECT_EQ(one->point_covariances_mm2, three->point_covariances_mm2);
  EXPECT_EQ(one->chi_squared, three->chi_squared);
}

/// χ²/ν and coverage over many simulated sets. Points are compared after both were laid onto the nominal ones.
TEST(Multilateration, states_covariances_that_hold_the_truth) {
  double ratio = 0.0;
  std::size_t inside = 0, all = 0, stations_inside = 0, stations_all = 0;
  constexpr int sets = 60;
  for (int set = 0; set < sets; ++set) {
    // Nominal points are exact here, so that the inner constraints of the truth are those of the result.
    const Truth truth =
        make_truth({.points = 40, .stations = 5, .sigma_mm = 1e-3, .error_mm = 0.0, .seed = 100u + set});
    auto options = with_sigma(1e-3);
    options.find_breaks = false;
    const auto fit = solve(truth, options);
    ASSERT_TRUE(fit) << error_of(fit);
    ratio += fit->chi_squared / static_cast<double>(fit->degrees_of_freedom) / sets;
    const double factor = fit->variance_factor();
    for (std::size_t i = 0; i < truth.points.size(); ++i)
      for (std::size_t c = 0; c < 3; ++c) {
        const double z =
            (fit->points_mm[i][c] - truth.points[i][c]) / std::sqrt(fit->point_covariances_mm2[i][c][c] / factor);
        inside += std::abs(z) < 1.959964;
        ++all;
      }
    for (std::size_t j = 0; j < truth.stations.size(); ++j)
      for (std::size_t c = 0; c < 3; ++c) {
        const double z =
            (fit->stations_mm[j][c] - truth.stations[j][c]) / std::sqrt(fit->station_covariances_mm2[j][c][c] / factor);
        stations_inside += std::abs(z) < 1.959964;
        ++stations_all;
      }
  }
  EXPECT_NEAR(ratio, 1.0, 0.1);
  EXPECT_NEAR(static_cast<double>(inside) / static_cast<double>(all), 0.95, 0.015);
  EXPECT_NEAR(static_cast<double>(stations_inside) / static_cast<double>(stations_all), 0.95, 0.03);
}

TEST(Multilateration, normalised_residuals_have_a_unit_variance) {
  const Truth truth = make_truth({.points = 400, .stations = 4, .sigma_mm = 1e-3, .seed = 8});
  const auto fit = solve(truth, with_sigma(1e-3));
  ASSERT_TRUE(fit) << error_of(fit);
  double squares = 0.0;
  for (double x : fit->normalised_residuals) squares += x * x;
  EXPECT_NEAR(squares / static_cast<double>(fit->normalised_residuals.size()), 1.0, 0.12);
}

TEST(Multilateration, names_coplanar_stations_and_what_they_leave_open) {
  for (const auto& [stations, open] : {std::pair{4, 2}, std::pair{5, 1}}) {
    for (double sigma : {0.0, 1e-3}) {
      const Truth truth =
          make_truth({.stations = static_cast<std::size_t>(stations), .sigma_mm = sigma, .coplanar = true});
      const auto fit = solve(truth);
      ASSERT_FALSE(fit) << stations;
      EXPECT_THAT(fit.error().message, HasSubstr(fmt::format("found {} stations on one plane within", stations)));
      EXPECT_THAT(fit.error().message, HasSubstr(fmt::format("{} direction", open)));
    }
  }
  EXPECT_TRUE(solve(make_truth({.stations = 6, .sigma_mm = 1e-4, .coplanar = true})));
  // Scales that are known a little leave coplanar stations no more open than known ones.
  auto options = with_sigma(1e-4);
  options.scale = ScaleModel::free;
  const Truth six = make_truth({.stations = 6, .sigma_mm = 1e-4, .coplanar = true, .scale_sigma = 3e-7});
  EXPECT_FALSE(solve(six, options));
  options.scale_prior = 3e-7;
  const auto fit = solve(six, options);
  ASSERT_TRUE(fit) << error_of(fit);
  EXPECT_FALSE(fit->rank.stations_coplanar);
  EXPECT_LT(shape_difference(fit->points_mm, six.points), 0.05);  // they see little across their plane
  const Truth four = make_truth({.stations = 4, .sigma_mm = 1e-4, .coplanar = true, .scale_sigma = 3e-7});
  EXPECT_THAT(error_of(solve(four, options)), HasSubstr("expected one well off it or 6 stations"));
}

TEST(Multilateration, counts_the_least_points_as_the_numerical_rank_does) {
  constexpr std::size_t fixed[] = {10, 7, 6, 6, 6}, free[] = {13, 9, 8, 7, 7};
  for (std::size_t m = 4; m <= 8; ++m) {
    EXPECT_EQ(points_least(m, ScaleModel::fixed), fixed[m - 4]);
    EXPECT_EQ(points_least(m, ScaleModel::common), fixed[m - 4]);
    EXPECT_EQ(points_least(m, ScaleModel::free), free[m - 4]);
    for (ScaleModel scale : {ScaleModel::fixed, ScaleModel::free}) {
      const std::size_t n = *points_least(m, scale);
      for (unsigned seed : {1u, 2u}) {
        const Truth enough = make_truth({.points = n, .stations = m, .error_mm = 0.0, .seed = seed});
        const auto fit = solve(enough, {.scale = scale});
        ASSERT_TRUE(fit) << m << " " << n << ": " << error_of(fit);
        EXPECT_EQ(fit->rank.null_directions, 0u);
        const Truth fewer = make_truth({.points = n - 1, .stations = m, .error_mm = 0.0, .seed = seed});
        EXPECT_THAT(error_of(solve(fewer, {.scale = scale})), HasSubstr(fmt::format("{} points are the least", n)));
      }
    }
  }
  EXPECT_EQ(points_least(9, ScaleModel::fixed), 5u);
  EXPECT_EQ(points_least(3, ScaleModel::fixed), std::nullopt);
  EXPECT_THAT(error_of(solve(make_truth({.stations = 3}))), HasSubstr("found 3 stations, expected at least 4"));
}

TEST(Multilateration, finds_a_beam_break_that_nobody_stated) {
  for (double jump : {40.0, 0.3, 0.02}) {
    Truth truth = make_truth({.sigma_mm = 2e-4, .error_mm = 0.005, .seed = 9});
    for (std::size_t k = 0; k < truth.readings.size(); ++k)
      if (truth.readings[k].station == 3 && truth.readings[k].point >= 25) truth.readings[k].length_mm += jump;
    const auto fit = solve(truth, with_sigma(2e-4));
    ASSERT_TRUE(fit) << error_of(fit);
    ASSERT_EQ(fit->breaks.size(), 1u) << jump;
    EXPECT_EQ(fit->breaks[0].station, 3u);
    EXPECT_EQ(fit->breaks[0].reading, 3 * 60 + 25u);
    EXPECT_NEAR(fit->breaks[0].jump_mm, jump, 0.002);
    EXPECT_EQ(fit->dead_paths_mm[3].size(), 2u);
    EXPECT_LT(shape_difference(fit->points_mm, truth.points), 0.003);
    EXPECT_NEAR(fit->chi_squared / static_cast<double>(fit->degrees_of_freedom), 1.0, 0.4);
    EXPECT_THAT(fit->findings.front().message, HasSubstr("station 4 jump"));
    EXPECT_EQ(fit->findings.front().id, "multilateration-beam-broken");
  }
}

TEST(Multilateration, uses_the_segments_that_are_stated) {
  Truth truth = make_truth({.seed = 10});
  for (RangeReading& r : truth.readings)
    if (r.station == 1 && r.point >= 30) {
      r.segment = 1;
      r.length_mm -= 77.0;
    }
  const auto fit = solve(truth);
  ASSERT_TRUE(fit) << error_of(fit);
  EXPECT_TRUE(fit->breaks.empty());
  EXPECT_NEAR(fit->dead_paths_mm[1].at(1) - fit->dead_paths_mm[1].at(0), 77.0, 1e-8);
  EXPECT_LT(shape_difference(fit->points_mm, truth.points), 1e-8);
}

TEST(Multilateration, names_a_reading_that_does_not_fit) {
  Truth truth = make_truth({.sigma_mm = 2e-4, .seed = 11});
  truth.readings[77].length_mm += 0.01;
  const auto fit = solve(truth, with_sigma(2e-4));
  ASSERT_TRUE(fit) << error_of(fit);
  ASSERT_FALSE(fit->findings.empty());
  EXPECT_THAT(fit->findings.front().message, HasSubstr("reading 78 (station 2, point 18)"));
  EXPECT_EQ(fit->findings.front().id, "multilateration-outliers");
  EXPECT_TRUE(fit->breaks.empty());
}

const Finding* scales_differ(const MultilaterationFit& fit) {
  const auto found = std::ranges::find(fit.findings, "multilateration-scales-differ", &Finding::id);
  return found == fit.findings.end() ? nullptr : &*found;
}

TEST(Multilateration, tells_lengths_of_one_station_that_are_too_long_in_proportion) {
  for (const double um_per_m : {20.0, -5.0}) {
    Truth truth = make_truth({.sigma_mm = 2e-4, .seed = 21});
    for (RangeReading& r : truth.readings)
      if (r.station == 2) r.length_mm += 1e-6 * um_per_m * distance(truth.points[r.point], truth.stations[2]);
    const auto fit = solve(truth, with_sigma(2e-4));
    ASSERT_TRUE(fit) << error_of(fit);
    ASSERT_NE(scales_differ(*fit), nullptr) << um_per_m;
    EXPECT_THAT(scales_differ(*fit)->message,
                HasSubstr("station 3 are too " + std::string(um_per_m > 0 ? "long" : "short")));
  }
}

TEST(Multilateration, tells_no_scale_that_all_stations_have_in_common) {
  Truth truth = make_truth({.sigma_mm = 2e-4, .seed = 22});
  for (RangeReading& r : truth.readings)
    r.length_mm += 20e-6 * distance(truth.points[r.point], truth.stations[r.station]);
  const auto fit = solve(truth, with_sigma(2e-4));
  ASSERT_TRUE(fit) << error_of(fit);
  EXPECT_EQ(scales_differ(*fit), nullptr) << "it changes the size alone, and the machine may be that large";
  EXPECT_LT(fit->chi_squared, 1.3 * static_cast<double>(fit->degrees_of_freedom));
}

// By chance once in a million; with lengths that scatter more than stated too, since χ²/ν is what is measured by.
TEST(Multilateration, tells_no_scales_of_lengths_that_only_scatter) {
  for (unsigned seed = 100; seed < 160; ++seed)
    for (const double stated : {2e-4, 0.7e-4}) {
      const auto fit = solve(make_truth({.points = 30, .sigma_mm = 2e-4, .seed = seed}), with_sigma(stated));
      ASSERT_TRUE(fit) << error_of(fit);
      EXPECT_EQ(scales_differ(*fit), nullptr) << seed << ", " << stated;
    }
}

TEST(Multilateration, lets_a_common_scale_change_the_size_and_nothing_else) {
  const Truth truth = make_truth({.sigma_mm = 1e-3, .seed = 12});
  auto options = with_sigma(1e-3);
  const auto fixed = solve(truth, options);
  options.scale = ScaleModel::common;
  options.scale_prior = 1e-5;
  const auto prior = solve(truth, options);
  options.scale_prior = 0.0;
  const auto unknown = solve(truth, options);
  ASSERT_TRUE(fixed && prior && unknown);
  EXPECT_LT(distance(prior->points_mm[5], fixed->points_mm[5]), 1e-9);
  Vector3 mean{};
  for (const Vector3& p : prior->points_mm) mean += 1.0 / 60.0 * p;
  const double off = prior->points_mm[5].x - mean.x;
  EXPECT_NEAR(prior->point_covariances_mm2[5][0][0] - fixed->point_covariances_mm2[5][0][0], 1e-10 * off * off, 1e-12);
  EXPECT_NEAR(prior->scale_sigmas[0], 1e-5, 1e-12);
  EXPECT_EQ(prior->degrees_of_freedom, fixed->degrees_of_freedom);
  EXPECT_NEAR(unknown->chi_squared / fixed->chi_squared, 1.0, 1e-6);
  EXPECT_NEAR(unknown->scales[0] * distance(unknown->points_mm[0], unknown->points_mm[1]),
              distance(fixed->points_mm[0], fixed->points_mm[1]), 1e-7);
  double trace_fixed = 0.0, trace_unknown = 0.0;
  for (std::size_t i = 0; i < 60; ++i)
    for (std::size_t c = 0; c < 3; ++c) {
      trace_fixed += fixed->point_covariances_mm2[i][c][c];
      trace_unknown += unknown->point_covariances_mm2[i][c][c];
    }
  EXPECT_LT(trace_unknown, trace_fixed);  // one more constraint: the smallest trace of a larger gauge
}

TEST(Multilateration, solves_points_that_not_all_stations_see) {
  Truth truth = make_truth({.points = 80, .stations = 6, .seed = 13});
  std::erase_if(truth.readings, [](const RangeReading& r) { return (r.point + r.station) % 3 == 0; });
  const auto fit = solve(truth);
  ASSERT_TRUE(fit) << error_of(fit);
  EXPECT_LT(shape_difference(fit->points_mm, truth.points), 1e-7);
  std::erase_if(truth.readings, [](const RangeReading& r) { return r.point == 7 && r.station > 1; });
  EXPECT_THAT(error_of(solve(truth)), HasSubstr("found 1 point seen by fewer than 3 stations (8)"));
}

TEST(Multilateration, refuses_lengths_in_another_unit_and_other_nonsense) {
  Truth truth = make_truth({.seed = 14});
  Truth metres = truth;
  for (RangeReading& r : metres.readings) r.length_mm *= 1e-3;
  EXPECT_THAT(error_of(solve(metres)), HasSubstr("are the lengths in m"));
  Truth micrometres = truth;
  for (RangeReading& r : micrometres.readings) r.length_mm *= 1e3;
  EXPECT_THAT(error_of(solve(micrometres)), HasSubstr("are the lengths in µm"));
  Truth nan = truth;
  nan.readings[3].length_mm = std::nan("");
  EXPECT_THAT(error_of(solve(nan)), HasSubstr("in reading 4"));
  Truth exchanged = truth;
  for (RangeReading& r : exchanged.readings) r.point = (r.point * 7 + 3) % 60;
  EXPECT_FALSE(solve(exchanged));
  Truth empty = truth;
  empty.readings.clear();
  EXPECT_THAT(error_of(solve(empty)), HasSubstr("found no readings"));
  Truth same = truth;
  for (Vector3& p : same.nominal) p = {1, 2, 3};
  EXPECT_FALSE(solve(same));
  Truth stranger = truth;
  stranger.readings[0].point = 1000;
  EXPECT_THAT(error_of(solve(stranger)), HasSubstr("of point 1001"));
}

TEST(Multilateration, refuses_lengths_that_nothing_weighs) {
  const Truth truth = make_truth({.seed = 14});
  EXPECT_THAT(error_of(solve(truth, with_sigma(0.0))), HasSubstr("without any uncertainty"));
  EXPECT_THAT(error_of(solve(truth, with_sigma(std::nan("")))), HasSubstr("negative or not finite"));
}

TEST(Multilateration, refuses_points_and_stations_exchanged_before_their_matrix_grows) {
  // 20 000 "stations" would have a dense matrix of 100 000 rows, 80 GB.
  std::vector<RangeReading> readings;
  for (std::size_t station = 0; station < 20'000; ++station)
    for (std::size_t point = 0; point < 8; ++point)
      readings.push_back({.point = point, .station = station, .length_mm = 100.0, .segment = 0});
  const std::vector<Vector3> nominal(8);
  EXPECT_THAT(error_of(multilaterate(nominal, 20'000, readings, {})), HasSubstr("are points and stations exchanged?"));
  // and a segment for every third reading of one
  Truth truth = make_truth({.points = 3000, .stations = 8});
  for (RangeReading& r : truth.readings) r.segment = r.point / 3;
  EXPECT_THAT(error_of(solve(truth)), HasSubstr("8 stations with 8000 segments"));
}

TEST(Multilateration, tells_that_points_of_a_plane_leave_mirror_images) {
  Truth truth = make_truth({.points = 40, .error_mm = 0.0, .seed = 15});
  for (std::size_t i = 0; i < 40; ++i) truth.points[i].z = truth.nominal[i].z = 120.0;
  for (RangeReading& r : truth.readings)
    r.length_mm = distance(truth.points[r.point], truth.stations[r.station]) - truth.dead[r.station];
  const auto fit = solve(truth);
  ASSERT_TRUE(fit) << error_of(fit);
  EXPECT_TRUE(std::ranges::any_of(fit->findings, [](const Finding& f) {
    return f.id == "multilateration-station-side" && f.message.contains("on which side");
  }));
  EXPECT_LT(shape_difference(fit->points_mm, truth.points), 1e-7);
}

TEST(Multilateration, converges_from_a_machine_that_errs_by_a_millimetre) {
  const Truth truth = make_truth({.points = 100, .error_mm = 0.7, .seed = 16});
  const auto fit = solve(truth);
  ASSERT_TRUE(fit) << error_of(fit);
  EXPECT_LT(shape_difference(fit->points_mm, truth.points), 1e-7);
  EXPECT_TRUE(fit->breaks.empty());
}

}  // namespace
}  // namespace axiometry::tracking
