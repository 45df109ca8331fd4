// SPDX-License-Identifier: Apache-2.0
#include "axiometry/numeric/additive_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string_view>
#include <vector>

namespace axiometry::numeric {
namespace {

constexpr double gone = std::numeric_limits<double>::quiet_NaN();

TEST(AdditiveTable, FindsLevelsAndShiftsOfAFullTable) {
  const std::vector<double> table = {1.0, 2.0, 6.0, 11.0, 12.0, 16.0};
  const AdditiveFit fit = fit_additive(table, 3);
  EXPECT_NEAR(fit.squares, 0.0, 1e-20);
  EXPECT_EQ(fit.degrees, 2.0);
  EXPECT_NEAR(fit.levels[1] - fit.levels[0], 10.0, 1e-12);
  EXPECT_NEAR(fit.shifts[2] - fit.shifts[0], 5.0, 1e-12);
  EXPECT_NEAR(fit.shifts[0] + fit.shifts[1] + fit.shifts[2], 0.0, 1e-12);
}

TEST(AdditiveTable, LeavesOutWhatIsMissing) {
  const std::vector<double> table = {1.0, gone, 6.0, 11.0, 12.0, 16.0, gone, 7.0, 11.0};
  const AdditiveFit fit = fit_additive(table, 3);
  EXPECT_NEAR(fit.squares, 0.0, 1e-18) << "the values are additive where they are";
  EXPECT_EQ(fit.degrees, 2.0);
  EXPECT_EQ(fit.count, 7u);
  EXPECT_TRUE(std::isnan(fit.residuals[1]));
}

// By hand: of 2 × 2 values the residuals are a quarter of the interaction.
TEST(AdditiveTable, LeavesTheInteraction) {
  const AdditiveFit fit = fit_additive(std::vector<double>{0.0, 0.0, 0.0, 4.0}, 2);
  EXPECT_NEAR(fit.residuals[3], 1.0, 1e-12);
  EXPECT_NEAR(fit.squares, 4.0, 1e-12);
  EXPECT_NEAR(fit.share(0, 0), 0.25, 1e-15);
}

// The conditions of least squares, whatever found them: what is left of each row and of each column sums to nothing,
// and is what the levels and shifts do not explain.
void expect_least_squares(const std::vector<double>& table, const AdditiveFit& fit, double rest = 1e-9) {
  double squares = 0.0;
  std::vector<double> of_row(fit.levels.size()), of_column(fit.columns);
  for (std::size_t k = 0; k < table.size(); ++k) {
    const std::size_t i = k / fit.columns, j = k % fit.columns;
    ASSERT_EQ(std::isnan(fit.residuals[k]), std::isnan(table[k])) << k;
    if (std::isnan(table[k])) continue;
    EXPECT_NEAR(fit.residuals[k], table[k] - fit.levels[i] - fit.shifts[j], 1e-9);
    of_row[i] += fit.residuals[k];
    of_column[j] += fit.residuals[k];
    squares += fit.residuals[k] * fit.residuals[k];
  }
  for (double sum : of_row) EXPECT_NEAR(sum, 0.0, rest);
  for (double sum : of_column) EXPECT_NEAR(sum, 0.0, rest);
  EXPECT_NEAR(fit.squares, squares, 1e-9);
}

TEST(AdditiveTable, IsOneOfLeastSquaresWithAnyGaps) {
  std::mt19937 engine(7);
  std::normal_distribution<double> scatter(0.0, 2.0);
  for (const std::size_t gaps : {0u, 1u, 2u, 5u, 8u, 9u, 20u})
    for (int repeated = 0; repeated < 20; ++repeated) {
      std::vector<double> table;
      for (std::size_t k = 0; k < 55; ++k)
        table.push_back(100.0 + 7.0 * double(k / 5) - 3.0 * double(k % 5) + scatter(engine));
      for (std::size_t g = 0; g < gaps; ++g) table[engine() % table.size()] = gone;
      expect_least_squares(table, fit_additive(table, 5));
    }
}

// Five columns are swept by code of their own; a sixth one without values takes them to that of any number.
TEST(AdditiveTable, IsTheSameToTheLastBitBesideAnEmptyColumn) {
  std::mt19937 engine(3);
  std::normal_distribution<double> scatter(0.0, 2.0);
  for (const std::size_t gaps : {0u, 1u, 4u, 9u}) {
    std::vector<double> table, wider;
    for (std::size_t k = 0; k < 55; ++k) table.push_back(10.0 * double(k % 5) + scatter(engine));
    for (std::size_t g = 0; g < gaps; ++g) table[engine() % table.size()] = gone;
    for (std::size_t k = 0; k < 55; ++k) {
      wider.push_back(table[k]);
      if (k % 5 == 4) wider.push_back(gone);
    }
    const AdditiveFit fit = fit_additive(table, 5), of_wider = fit_additive(wider, 6);
    EXPECT_EQ(of_wider.levels, fit.levels);
    EXPECT_EQ(std::vector(of_wider.shifts.begin(), of_wider.shifts.end() - 1), fit.shifts);
    EXPECT_EQ(of_wider.squares, fit.squares);
    EXPECT_EQ(of_wider.degrees, fit.degrees);
  }
}

// Gaps that take a whole row or column, or leave parts without a link.
TEST(AdditiveTable, IsOneOfLeastSquaresWhereNothingTiesItsParts) {
  const std::vector<double> no_row = {1.0, 2.0, 6.0, gone, gone, gone, 4.0, 4.0, 5.0};
  const std::vector<double> no_column = {1.0, gone, 6.0, 2.0, gone, 9.0, 4.0, gone, 5.0};
  const std::vector<double> apart = {1.0, 2.0, gone, 3.0, 5.0, gone, gone, gone, 8.0};
  for (const std::vector<double>& table : {no_row, no_column, apart})
    expect_least_squares(table, fit_additive(table, 3));
}

/// Columns that are driven in groups: of each group its own rows, and from one to the next `ties` rows that both have.
std::vector<double> table_of_groups(std::mt19937& engine, std::size_t columns, std::size_t groups, std::size_t rows,
                                    std::size_t ties, double step) {
  std::normal_distribution<double> scatter(0.0, 0.5);
  std::vector<double> table;
  for (std::size_t i = 0; i < groups * rows; ++i)
    for (std::size_t j = 0; j < columns; ++j) {
      const std::size_t of_row = i / rows, of_column = j * groups / columns;
      const bool is_tie = i % rows < ties && of_row == of_column + 1;
      const double value = 0.3 * double(i) + 40.0 * double(of_column) + scatter(engine);
      table.push_back(of_row == of_column || is_tie ? std::round(value / step) * step : gone);
    }
  return table;
}

// Days of a test that share a target with the day before: what the next is shifted by is told by one row of hundreds.
TEST(AdditiveTable, IsOneOfLeastSquaresWhereFewRowsTieItsParts) {
  std::mt19937 engine(11);
  for (const double step : {1e-9, 0.1, 1.0})
    for (const std::size_t columns : {2u, 3u, 5u, 9u, 40u})
      for (const std::size_t groups : {std::size_t{2}, std::size_t{3}, columns})
        for (const std::size_t rows : {12u, 150u}) {
          if (groups > columns || columns * groups * rows > 60'000) continue;
          const std::vector<double> table = table_of_groups(engine, columns, groups, rows, 1, step);
          const AdditiveFit fit = fit_additive(table, columns);
          expect_least_squares(table, fit, 1e-11 * double(groups * rows) * double(groups));  // values up to thousands
          EXPECT_NEAR(fit.shifts.back() - fit.shifts.front(), 40.0 * double(groups - 1), 4.0 * double(groups))
              << columns << ' ' << groups;
        }
}

// Whole numbers, four columns; least squares by numpy.linalg.lstsq: 5.567460.
TEST(AdditiveTable, EndsWhereRoundingIsAllThatIsLeft) {
  std::vector<double> table;
  for (const std::string_view row :
       {"00..", "10..", "10..", "01..", "11..", "11..", "0098", "..88", "..89", "..89", "..88", "..99",
        "..98", "..98", "..98", "..98", "..99", "..98", "..99", "..88", "..98", "..98", "..88", "..98"})
    for (const char c : row) table.push_back(c == '.' ? gone : double(c - '0'));
  const AdditiveFit fit = fit_additive(table, 4);
  EXPECT_NEAR(fit.squares, 5.567460, 1e-6);
  expect_least_squares(table, fit);
}

TEST(AdditiveTable, StandsRowsAndColumnsWithoutValues) {
  const AdditiveFit fit = fit_additive(std::vector<double>{1.0, gone, gone, gone}, 2);
  EXPECT_EQ(fit.degrees, 0.0);
  EXPECT_TRUE(std::isnan(fit.levels[1]));
  EXPECT_TRUE(std::isnan(fit.shifts[1]));
}

}  // namespace
}  // namespace axiometry::numeric
