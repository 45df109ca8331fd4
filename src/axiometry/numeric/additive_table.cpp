// SPDX-License-Identifier: Apache-2.0
#include "axiometry/numeric/additive_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "axiometry/base/contract.h"

namespace axiometry::numeric {
namespace {

constexpr double absent = std::numeric_limits<double>::quiet_NaN();
constexpr int passes_at_most = 60;
constexpr std::size_t filled_at_most = 8;  // values that are missing: their equations cost the cube of their number

/// What a sum takes of it: adding 0 changes no sum that began with 0.
double present(double x) { return std::isnan(x) ? 0.0 : x; }

/// Takes the mean of every row out of the residuals; the largest of these means.
double sweep_rows(AdditiveFit& fit) {
  double largest = 0.0;
  for (std::size_t i = 0; i < fit.levels.size(); ++i) {
    if (fit.row_counts[i] == 0) continue;
    double* row = fit.residuals.data() + i * fit.columns;
    double sum = 0.0;
    for (std::size_t j = 0; j < fit.columns; ++j) sum += present(row[j]);
    const double mean = sum / static_cast<double>(fit.row_counts[i]);
    for (std::size_t j = 0; j < fit.columns; ++j) row[j] -= mean;
    fit.levels[i] += mean;
    largest = std::max(largest, std::abs(mean));
  }
  return largest;
}

/// `means`: one of each column, for the sums.
double sweep_columns(AdditiveFit& fit, std::vector<double>& means) {
  means.assign(fit.columns, 0.0);
  for (std::size_t i = 0; i < fit.levels.size(); ++i) {
    const double* row = fit.residuals.data() + i * fit.columns;
    for (std::size_t j = 0; j < fit.columns; ++j) means[j] += present(row[j]);
  }
  double largest = 0.0;
  for (std::size_t j = 0; j < fit.columns; ++j) {
    if (fit.column_counts[j] == 0) continue;
    means[j] /= static_cast<double>(fit.column_counts[j]);
    fit.shifts[j] += means[j];
    largest = std::max(largest, std::abs(means[j]));
  }
  for (std::size_t i = 0; i < fit.levels.size(); ++i) {
    double* row = fit.residuals.data() + i * fit.columns;
    for (std::size_t j = 0; j < fit.columns; ++j) row[j] -= means[j];
  }
  return largest;
}

void count_values(AdditiveFit& fit) {
  for (std::size_t i = 0; i < fit.levels.size(); ++i)
    for (std::size_t j = 0; j < fit.columns; ++j) {
      if (std::isnan(fit.residuals[i * fit.columns + j])) continue;
      ++fit.row_counts[i];
      ++fit.column_counts[j];
      ++fit.count;
    }
}

struct Gap {
  std::size_t row = 0;
  std::size_t column = 0;
};

std::vector<Gap> gaps_of(const AdditiveFit& fit) {
  std::vector<Gap> gaps;
  for (std::size_t k = 0; k < fit.residuals.size(); ++k)
    if (std::isnan(fit.residuals[k])) gaps.push_back({k / fit.columns, k % fit.columns});
  return gaps;
}

using GapNumbers = std::array<double, filled_at_most>;

/// x with Mx = b, by Cholesky's method, where M holds what a change at one gap changes in the residual of another of
/// the full table: (δ_rows − 1/rows)(δ_columns − 1/columns). False where the values there are do not tell the missing
/// ones.
bool solve_gaps(std::span<const Gap> gaps, std::size_t rows, std::size_t columns, GapNumbers& b) {
  constexpr double least_pivot = 1e-3;  // of the 1 that M has at most: what is less leaves too few digits
  std::array<GapNumbers, filled_at_most> factor;
  for (std::size_t i = 0; i < gaps.size(); ++i)
    for (std::size_t k = 0; k <= i; ++k) {
      double sum = ((gaps[i].row == gaps[k].row ? 1.0 : 0.0) - 1.0 / static_cast<double>(rows)) *
                   ((gaps[i].column == gaps[k].column ? 1.0 : 0.0) - 1.0 / static_cast<double>(columns));
      for (std::size_t c = 0; c < k; ++c) sum -= factor[i][c] * factor[k][c];
      if (i == k && !(sum > least_pivot)) return false;
      factor[i][k] = i == k ? std::sqrt(sum) : sum / factor[k][k];
    }
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    for (std::size_t c = 0; c < i; ++c) b[i] -= factor[i][c] * b[c];
    b[i] /= factor[i][i];
  }
  for (std::size_t i = gaps.size(); i-- > 0;) {
    for (std::size_t c = i + 1; c < gaps.size(); ++c) b[i] -= factor[c][i] * b[c];
    b[i] /= factor[i][i];
  }
  return true;
}

/// After the first sweep of rows: where a few values are missing, what the others let expect of them makes the table
/// full (Yates, Empire Journal of Experimental Agriculture 1 (1933) 129), of which least squares are known at once. The
/// sweeps that follow find little more than rounding.
void start_from_full_table(AdditiveFit& fit) {
  const std::size_t rows = fit.levels.size(), missing = fit.residuals.size() - fit.count;
  if (missing == 0 || missing > filled_at_most) return;
  const std::vector<Gap> gaps = gaps_of(fit);
  const auto m = static_cast<double>(rows), n = static_cast<double>(fit.columns);
  std::vector<double> column_means(fit.columns, 0.0);  // with 0 for what is missing: the means of rows are 0 then
  for (std::size_t k = 0; k < fit.residuals.size(); ++k) column_means[k % fit.columns] += present(fit.residuals[k]) / m;
  double mean = 0.0;
  for (double x : column_means) mean += x / n;
  GapNumbers values{};  // less what stands there
  for (std::size_t k = 0; k < gaps.size(); ++k) values[k] = mean - column_means[gaps[k].column];
  if (!solve_gaps(gaps, rows, fit.columns, values)) return;
  std::vector<double> row_means(rows, 0.0);
  for (std::size_t k = 0; k < gaps.size(); ++k) {
    row_means[gaps[k].row] -= values[k] / n;
    column_means[gaps[k].column] -= values[k] / m;
    mean -= values[k] / (m * n);
  }
  for (std::size_t j = 0; j < fit.columns; ++j) fit.shifts[j] += column_means[j] -= mean;
  for (std::size_t i = 0; i < rows; ++i) {
    fit.levels[i] += row_means[i];
    for (std::size_t j = 0; j < fit.columns; ++j) fit.residuals[i * fit.columns + j] -= row_means[i] + column_means[j];
  }
}

/// Shifts with mean 0 over the columns there are, which the levels take.
void centre(AdditiveFit& fit) {
  double sum = 0.0;
  std::size_t there = 0;
  for (std::size_t j = 0; j < fit.columns; ++j)
    if (fit.column_counts[j] > 0) sum += fit.shifts[j], ++there;
  if (there == 0) return;
  const double mean = sum / static_cast<double>(there);
  for (std::size_t j = 0; j < fit.columns; ++j)
    fit.shifts[j] = fit.column_counts[j] > 0 ? fit.shifts[j] - mean : absent;
  for (std::size_t i = 0; i < fit.levels.size(); ++i)
    fit.levels[i] = fit.row_counts[i] > 0 ? fit.levels[i] + mean : absent;
}

}  // namespace

double AdditiveFit::share(std::size_t row, std::size_t column) const {
  return (1.0 - 1.0 / static_cast<double>(row_counts[row])) * (1.0 - 1.0 / static_cast<double>(column_counts[column]));
}

AdditiveFit fit_additive(std::span<const double> table, std::size_t columns, GapStart start) {
  AXIOMETRY_CONTRACT(columns > 0 && table.size() % columns == 0);
  const std::size_t rows = table.size() / columns;
  AdditiveFit fit{columns,
                  {table.begin(), table.end()},
                  std::vector<double>(rows, 0.0),
                  std::vector<double>(columns, 0.0),
                  std::vector<std::size_t>(rows, 0),
                  std::vector<std::size_t>(columns, 0)};
  count_values(fit);
  sweep_rows(fit);
  double spread = 0.0;
  for (double x : fit.residuals) spread = std::max(spread, std::abs(present(x)));
  if (start == GapStart::filled) start_from_full_table(fit);
  std::vector<double> means;
  for (int pass = 0; pass < passes_at_most; ++pass) {
    const double moved = sweep_columns(fit, means);
    const double back = sweep_rows(fit);
    if (std::max(pass == 0 ? 0.0 : moved, back) <= 1e-12 * spread) break;
  }
  centre(fit);
  for (double x : fit.residuals) fit.squares += present(x) * present(x);
  const auto used_rows = rows - static_cast<std::size_t>(std::ranges::count(fit.row_counts, std::size_t{0}));
  const auto used_columns = columns - static_cast<std::size_t>(std::ranges::count(fit.column_counts, std::size_t{0}));
  fit.degrees = std::max(0.0, static_cast<double>(fit.count + 1) - static_cast<double>(used_rows + used_columns));
  return fit;
}

}  // namespace axiometry::numeric
