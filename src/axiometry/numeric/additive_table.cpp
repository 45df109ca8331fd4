// SPDX-License-Identifier: Apache-2.0
#include "axiometry/numeric/additive_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "axiometry/base/contract.h"

namespace axiometry::numeric {
namespace {

constexpr double absent = std::numeric_limits<double>::quiet_NaN();
constexpr int passes_at_most = 60;

/// The residuals while they are found: 0 where the table has no value, and `there` as much of a mean as a place takes
/// of it, 1 or 0. So no sum and no difference asks whether there is a value.
struct Working {
  AdditiveFit& fit;
  std::vector<double> there;
};

Working begun(AdditiveFit& fit) {
  Working working{fit, std::vector<double>(fit.residuals.size(), 1.0)};
  for (std::size_t i = 0, k = 0; i < fit.levels.size(); ++i) {
    fit.row_counts[i] = fit.columns;
    for (std::size_t j = 0; j < fit.columns; ++j, ++k) {
      if (!std::isnan(fit.residuals[k])) continue;
      fit.residuals[k] = working.there[k] = 0.0;
      --fit.row_counts[i];
      --fit.column_counts[j];
    }
    fit.count += fit.row_counts[i];
  }
  return working;
}

template <typename Means>
struct Swept {
  Means of_columns;
  double largest_of_rows = 0.0;
};

/// Takes `means` of the columns out of the residuals, and then the mean of every row; what means the columns are left
/// with, and the largest of the rows. A table is walked once for both.
template <typename Means>
Swept<Means> sweep(Working& working, const Means means) {
  const std::size_t columns = means.size();
  AdditiveFit& fit = working.fit;
  Swept<Means> swept{means};
  Means sums = means;
  std::ranges::fill(sums, 0.0);
  for (std::size_t i = 0; i < fit.levels.size(); ++i) {
    if (fit.row_counts[i] == 0) continue;
    double* row = fit.residuals.data() + i * columns;
    const double* there = working.there.data() + i * columns;
    double sum = 0.0;
    for (std::size_t j = 0; j < columns; ++j) {
      row[j] -= there[j] * means[j];
      sum += row[j];
    }
    const double mean = sum / static_cast<double>(fit.row_counts[i]);
    for (std::size_t j = 0; j < columns; ++j) {
      row[j] -= there[j] * mean;
      sums[j] += row[j];
    }
    fit.levels[i] += mean;
    swept.largest_of_rows = std::max(swept.largest_of_rows, std::abs(mean));
  }
  for (std::size_t j = 0; j < columns; ++j)
    swept.of_columns[j] = fit.column_counts[j] > 0 ? sums[j] / static_cast<double>(fit.column_counts[j]) : 0.0;
  return swept;
}

/// Solves for what sweeps leave where few values tie parts of the table together. The shifts r that are still missing
/// fulfil L r = b: b the sums of the columns' residuals, (L r)_j = Σ over the values of column j of r_j less the mean
/// of r in that row. By conjugate gradients, which end after as many steps as there are columns but for rounding.
void solve_shifts(Working& working) {
  AdditiveFit& fit = working.fit;
  const std::size_t columns = fit.columns;
  const auto sums_less_row_means = [&](std::span<const double> of_columns) {
    std::vector<double> sums(columns, 0.0);
    for (std::size_t i = 0; i < fit.levels.size(); ++i) {
      if (fit.row_counts[i] == 0) continue;
      const double* there = working.there.data() + i * columns;
      double mean = 0.0;
      for (std::size_t j = 0; j < columns; ++j) mean += there[j] * of_columns[j];
      mean /= static_cast<double>(fit.row_counts[i]);
      for (std::size_t j = 0; j < columns; ++j) sums[j] += there[j] * (of_columns[j] - mean);
    }
    return sums;
  };
  const auto dot = [](const std::vector<double>& a, const std::vector<double>& b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
  };
  std::vector<double> missing(columns, 0.0), left(columns, 0.0);
  for (std::size_t k = 0; k < fit.residuals.size(); ++k) left[k % columns] += fit.residuals[k];
  std::vector<double> towards = left;
  double square = dot(left, left);
  const double enough = 1e-30 * square;
  for (std::size_t step = 0; step < 2 * columns && square > enough; ++step) {
    const std::vector<double> image = sums_less_row_means(towards);
    const double curvature = dot(towards, image);
    if (!(curvature > 0.0)) break;
    const double length = square / curvature;
    for (std::size_t j = 0; j < columns; ++j) {
      missing[j] += length * towards[j];
      left[j] -= length * image[j];
    }
    const double before = std::exchange(square, dot(left, left));
    for (std::size_t j = 0; j < columns; ++j) towards[j] = left[j] + square / before * towards[j];
  }
  for (std::size_t j = 0; j < columns; ++j) fit.shifts[j] += missing[j];
  sweep(working, std::move(missing));
}

/// `none`: a zero for each column.
template <typename Means>
void find_levels_and_shifts(Working& working, Means none) {
  AdditiveFit& fit = working.fit;
  Swept<Means> last = sweep(working, std::move(none));
  double spread = 0.0;
  for (double x : fit.residuals) spread = std::max(spread, std::abs(x));
  for (int pass = 0; pass < passes_at_most; ++pass) {
    double moved = 0.0;
    for (std::size_t j = 0; j < fit.columns; ++j) {
      fit.shifts[j] += last.of_columns[j];
      moved = std::max(moved, std::abs(last.of_columns[j]));
    }
    last = sweep(working, std::move(last.of_columns));
    if (std::max(pass == 0 ? 0.0 : moved, last.largest_of_rows) <= 1e-12 * spread) return;
  }
  solve_shifts(working);
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
                  std::vector<std::size_t>(rows, columns),
                  std::vector<std::size_t>(columns, rows)};
  Working working = begun(fit);
  constexpr std::size_t usual = 5;  // runs of a test: their means stay in registers
  if (columns == usual)
    find_levels_and_shifts(working, std::array<double, usual>{});
  else
    find_levels_and_shifts(working, std::vector<double>(columns, 0.0));
  centre(fit);
  for (double x : fit.residuals) fit.squares += x * x;
  for (std::size_t k = 0; k < fit.residuals.size(); ++k)
    if (working.there[k] == 0.0) fit.residuals[k] = absent;
  const auto used_rows = rows - static_cast<std::size_t>(std::ranges::count(fit.row_counts, std::size_t{0}));
  const auto used_columns = columns - static_cast<std::size_t>(std::ranges::count(fit.column_counts, std::size_t{0}));
  if (fit.count > 0)
    fit.degrees = std::max(0.0, static_cast<double>(fit.count + 1) - static_cast<double>(used_rows + used_columns));
  return fit;
}

}  // namespace axiometry::numeric
