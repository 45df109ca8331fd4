// SPDX-License-Identifier: Apache-2.0
#include "axiometry/numeric/kernels/matern_filter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "axiometry/numeric/curve_axes.h"
#include "axiometry/numeric/random/random.h"

namespace axiometry::numeric {
namespace {

constexpr MaternFilter::Ratios several_ratios = {0.0, 1e-6, 0.01, 0.5, 1.0, 30.0, 1e4, 1e9};

/// Places as near as a thousandth of the length and as far as a hundred of them.
std::vector<double> irregular_places() {
  return {0.0, 0.01, 0.05, 1.0, 1.3, 4.0, 5.0, 20.0, 25.0, 90.0, 1100.0, 1101.0};
}

double matern_correlation(double distance, double length) {
  const double x = std::sqrt(5.0) * std::abs(distance) / length;
  return (1.0 + x + x * x / 3.0) * std::exp(-x);
}

/// Validation: from three normal numbers for each place come curves of the covariance that Matérn's formula gives.
TEST(MaternFilter, MakesCurvesOfTheCovarianceThatItIsNamedAfter) {
  const std::vector<double> places = irregular_places();
  const std::size_t m = places.size(), lanes = MaternFilter::lanes;
  const MaternFilter filter(places, 10.0);
  std::vector<double> covariance(m * m, 0.0);
  for (std::size_t k = 0; k < 3 * m; ++k) {  // a curve is linear in its numbers
    const std::size_t lane = k % lanes;
    std::vector<double> normals(3 * m * lanes, 0.0), curves(m * lanes);
    normals[k * lanes + lane] = 1.0;
    filter.simulate(normals, curves);
    for (std::size_t i = 0; i < m; ++i)
      for (std::size_t j = 0; j < m; ++j) covariance[i * m + j] += curves[i * lanes + lane] * curves[j * lanes + lane];
  }
  for (std::size_t i = 0; i < m; ++i)
    for (std::size_t j = 0; j < m; ++j)
      EXPECT_NEAR(covariance[i * m + j], matern_correlation(places[i] - places[j], 10.0), 1e-13);
}

/// Validation against the principal axes of the matrix beside the trend, which come from the matrix itself: there λK +
/// 1 is 1 + λ d.
TEST(MaternFilter, WeighsAsTheInverseOfTheMatrixDoes) {
  const std::vector<double> places = irregular_places();
  const std::size_t m = places.size(), lanes = MaternFilter::lanes;
  std::vector<double> x(m);
  fill_normal({5, 0, 0}, x);
  for (std::size_t terms : {1u, 2u}) {
    const std::vector<double> columns = trend_columns(places, terms);
    const CurveAxes axes(places, terms, 10.0);
    const std::vector<double> coordinates = axes.coordinates(x);
    const MaternFilter filter(places, 10.0);
    const auto found = filter.beside_trend(x, {columns, terms}, several_ratios);
    std::vector<double> rows(m * lanes);
    for (std::size_t k = 0; k < rows.size(); ++k) rows[k] = x[k / lanes];
    MaternFilter::Workspace workspace;
    filter.weigh({columns, terms}, several_ratios, rows, workspace);
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      double log_determinant = 0.0, squares = 0.0;
      std::vector<double> weighed(m, 0.0);
      for (std::size_t k = terms; k < m; ++k) {
        const double size = 1.0 + several_ratios[lane] * axes.smooth[k];
        log_determinant += std::log(size);
        squares += coordinates[k] * coordinates[k] / size;
        for (std::size_t i = 0; i < m; ++i) weighed[i] += coordinates[k] / size * axes.columns[k * m + i];
      }
      const double slack = 1e-12 + 1e-14 * several_ratios[lane];  // rounding of the smallest d, times λ
      EXPECT_NEAR(found[lane].log_determinant, log_determinant, slack) << lane;
      EXPECT_NEAR(found[lane].squares, squares, slack) << lane;
      for (std::size_t i = 0; i < m; ++i) EXPECT_NEAR(rows[i * lanes + lane], weighed[i], slack) << lane;
    }
  }
}

TEST(MaternFilter, GivesTheSameBitsOnEveryTarget) {
  const std::vector<double> places = irregular_places();
  const std::size_t m = places.size(), lanes = matern_lanes;
  std::vector<MaternStep> steps(m, {{0.9, 0.1, 0.02, -0.1, 0.8, 0.05, -0.3, 0.1, 0.7},
                                    {0.1, 0.02, 0.01, 0.3, 0.04, 0.5},
                                    {0.3, 0.1, 0.5, 0.2, 0.1, 0.6}});
  const std::vector<double> column(m, 0.25);
  const MaternCurve curve{steps.data(), m, {column.data(), places.data()}};
  std::vector<double> values(m * lanes), normals(3 * m * lanes);
  fill_normal({1, 0, 0}, values);
  fill_normal({1, 1, 0}, normals);
  std::vector<std::vector<double>> all;
  for (VectorTarget target : available_vector_targets()) {
    const MaternKernel& kernel = matern_kernel_of(target);
    MaternSums sums;
    std::vector<double> products(2 * lanes), kept(m * matern_kept * lanes), results(m * lanes), curves(m * lanes);
    kernel.filter(curve, several_ratios.data(), values.data(), sums, products.data(), kept.data());
    kernel.smooth(curve, kept.data(), values.data(), results.data());
    kernel.simulate(curve, normals.data(), curves.data());
    std::vector<double>& bits = all.emplace_back(products);
    for (const auto* more : {&kept, &results, &curves}) bits.insert(bits.end(), more->begin(), more->end());
    bits.insert(bits.end(), sums.values, sums.values + lanes);
  }
  for (const auto& bits : all) EXPECT_EQ(bits, all.front());
}

}  // namespace
}  // namespace axiometry::numeric
