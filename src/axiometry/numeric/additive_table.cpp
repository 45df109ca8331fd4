// SPDX-License-Identifier: Apache-2.0
#include "axiometry/numeric/additive_table.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "axiometry/base/contract.h"

namespace axiometry::numeric {
namespace {

constexpr double absent = std::numeric_limits<double>::quiet_NaN();
constexpr int passes_at_most = 60;

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

AdditiveFit fit_additive(std::span<const double> table, std::size_t columns) {
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
