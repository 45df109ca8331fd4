// SPDX-License-Identifier: Apache-2.0
#include "axiometry/numeric/kernels/affine_rows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "axiometry/numeric/random/random.h"

namespace axiometry::numeric {
namespace {

constexpr std::size_t source_rows = 5;

AffineRows some_rows() {
  const std::vector<AffineRows::Row> rows = {
      {1.5, {}}, {-2.25, {{0, 0.3}}}, {0.1, {{1, -0.7}, {3, 1e-3}, {4, 1.0 / 3.0}}}, {7.0, {{4, 2.0}, {4, -1.1}}}};
  return AffineRows(rows);
}

template <typename Number>
void expect_every_target_follows_the_formula() {
  const AffineRows map = some_rows();
  ASSERT_EQ(map.row_count(), 4u);
  ASSERT_EQ(map.source_count(), source_rows);
  for (std::size_t trials : {0u, 1u, 2u, 3u, 15u, 16u, 31u, 64u, 65u, 100u}) {
    const std::size_t stride = trials + 3;
    std::vector<Number> x(source_rows * stride);
    fill_normal({1, 2, trials}, std::span(x));
    for (VectorTarget target : available_vector_targets()) {
      SCOPED_TRACE(std::string(vector_target_name(target)));
      std::vector<Number> y(map.row_count() * stride, Number(-99));
      map.apply(Rows<const Number>{x, stride}, Rows<Number>{y, stride}, trials, target);
      const auto source = [&](std::size_t k, std::size_t t) { return x[k * stride + t]; };
      for (std::size_t t = 0; t < trials; ++t) {
        EXPECT_EQ(y[t], Number(1.5));
        EXPECT_EQ(y[stride + t], Number(-2.25) + Number(0.3) * source(0, t));
        const Number two = Number(0.1) + Number(-0.7) * source(1, t);
        const Number three = two + Number(1e-3) * source(3, t);
        EXPECT_EQ(y[2 * stride + t], three + Number(1.0 / 3.0) * source(4, t));
        const Number first = Number(7) + Number(2) * source(4, t);
        EXPECT_EQ(y[3 * stride + t], first + Number(-1.1) * source(4, t));
      }
      for (std::size_t r = 0; r < map.row_count(); ++r)
        for (std::size_t t = trials; t < stride; ++t) EXPECT_EQ(y[r * stride + t], Number(-99)) << "beyond the trials";
    }
  }
}

/// Rows that take the places of sources, each its own.
template <typename Number>
void expect_the_same_in_place() {
  const std::vector<AffineRows::Row> rows = {{1.5, {{0, 0.3}, {2, -0.7}, {4, 1e-3}}}, {-2.25, {{3, 2.0}, {1, 0.1}}}};
  const AffineRows map(rows);
  for (std::size_t trials : {1u, 16u, 31u, 128u, 150u}) {
    const std::size_t stride = trials + 3;
    std::vector<Number> x(source_rows * stride);
    fill_normal({1, 5, trials}, std::span(x));
    for (VectorTarget target : available_vector_targets()) {
      std::vector<Number> expected = x, found = x;
      map.apply(Rows<const Number>{x, stride}, Rows<Number>{expected, stride}, trials, target);
      map.apply(Rows<const Number>{found, stride}, Rows<Number>{found, stride}, trials, target);
      EXPECT_EQ(found, expected) << vector_target_name(target) << ", " << trials << " trials";
    }
  }
}

TEST(AffineRows, TakeThePlacesOfTheirSources) {
  expect_the_same_in_place<double>();
  expect_the_same_in_place<float>();
}

TEST(AffineRows, FollowTheFormulaOnEveryTarget) { expect_every_target_follows_the_formula<double>(); }
TEST(AffineRows, FollowItInSinglePrecision) { expect_every_target_follows_the_formula<float>(); }

TEST(AffineRows, MayBeNone) {
  const AffineRows none{std::span<const AffineRows::Row>{}};
  EXPECT_EQ(none.row_count(), 0u);
  none.apply(Rows<const double>{}, Rows<double>{}, 10);
}

TEST(AffineRows, TakeProductsAwayOneAfterTheOtherOnEveryTarget) {
  const std::vector<double> factors = {0.3, -1.0 / 3.0, 1e-7};
  for (std::size_t trials : {0u, 1u, 7u, 16u, 40u, 80u, 100u}) {
    const std::size_t stride = trials + 3;
    std::vector<double> x(factors.size() * stride), y(trials);
    fill_normal({1, 3, trials}, x);
    fill_normal({1, 4, trials}, y);
    for (VectorTarget target : available_vector_targets()) {
      std::vector<double> row = y;
      subtract_products(factors, Rows<const double>{x, stride}, row, target);
      for (std::size_t t = 0; t < trials; ++t) {
        double left = y[t];
        for (std::size_t k = 0; k < factors.size(); ++k) {
          const double product = factors[k] * x[k * stride + t];
          left -= product;
        }
        EXPECT_EQ(row[t], left) << vector_target_name(target);
      }
    }
  }
}

/// Tables of more and fewer rows than are taken at once; a row without readings stays one, the others as alone.
TEST(AffineRows, TakeProductsAwayFromManyRowsAsFromEach) {
  constexpr std::size_t terms = 7;
  for (std::size_t rows : {0u, 1u, 3u, 5u, 7u, 11u}) {
    std::vector<double> factors(rows * terms);
    fill_normal({1, 6, rows}, factors);
    for (std::size_t trials : {1u, 7u, 16u, 33u, 80u, 100u}) {
      const std::size_t stride = trials + 3;
      std::vector<double> x(terms * stride), y(rows * stride);
      fill_normal({1, 7, trials}, x);
      fill_normal({1, 8, trials}, y);
      if (rows > 3) std::fill_n(y.begin() + static_cast<std::ptrdiff_t>(2 * stride), trials, std::nan(""));
      const Rows<const double> sources{x, stride};
      for (VectorTarget target : available_vector_targets()) {
        std::vector<double> expected = y, found = y;
        for (std::size_t r = 0; r < rows; ++r)
          subtract_products(std::span(factors).subspan(r * terms, terms), sources,
                            Rows<double>{expected, stride}.row(r, trials), VectorTarget::plain);
        subtract_products(factors, sources, Rows<double>{found, stride}, trials, target);
        for (std::size_t k = 0; k < found.size(); ++k) {
          if (std::isnan(expected[k]))
            EXPECT_TRUE(std::isnan(found[k]));
          else
            EXPECT_EQ(found[k], expected[k]) << vector_target_name(target) << ", " << rows << " rows, " << trials;
        }
      }
    }
  }
}

}  // namespace
}  // namespace axiometry::numeric
