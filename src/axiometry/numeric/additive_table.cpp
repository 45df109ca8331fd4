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

/// What is left of columns' means and of rows' means counts as nothing below this share of the table's spread.
constexpr double settled = 1e-12;

/// Solves for what sweeps leave where few values tie parts of the table together. The shifts r that are still missing
/// fulfil L r = b: b the sums of the columns' residuals, (L r)_j = Σ over the values of column j of r_j less the mean
/// of r in that row. By conjugate gradients, with the number of values of each column for its scale, which end after
/// fewer steps than there are columns. L is singular, one constant for each part of the table, and rounding leaves a
/// share of b in these directions, towards which the steps grow once the rest is solved: the best shifts seen are kept.
class MissingShifts {
 public:
  MissingShifts(const Working& working, double spread) : working_(working), enough_(settled * spread) {
    const AdditiveFit& fit = working.fit;
    left_.assign(fit.columns, 0.0);
    for (std::size_t k = 0; k < fit.residuals.size(); ++k) left_[k % fit.columns] += fit.residuals[k];
    found_ = best_ = std::vector<double>(fit.columns, 0.0);
    least_left_ = largest_left();
  }

  std::vector<double> solve() {
    std::vector<double> scaled = left_by_counts(), towards = scaled;
    double size = dot(left_, scaled);
    const std::size_t steps = std::min(found_.size(), steps_at_most);
    for (std::size_t step = 0; step < steps && least_left_ > enough_; ++step) {
      const std::vector<double> image = sums_less_row_means(towards);
      const double curvature = dot(towards, image);
      if (!(curvature > 0.0) || !(size > 0.0)) break;
      const double length = size / curvature;
      for (std::size_t j = 0; j < found_.size(); ++j) {
        found_[j] += length * towards[j];
        left_[j] -= length * image[j];
      }
      if (const double now = largest_left(); now < least_left_) {
        least_left_ = now;
        best_ = found_;
      }
      scaled = left_by_counts();
      const double before = std::exchange(size, dot(left_, scaled));
      for (std::size_t j = 0; j < towards.size(); ++j) towards[j] = scaled[j] + size / before * towards[j];
    }
    return best_;
  }

 private:
  static constexpr std::size_t steps_at_most = 200;  // each walks the table, as a sweep does

  static double dot(const std::vector<double>& a, const std::vector<double>& b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
  }

  std::vector<double> left_by_counts() const {
    std::vector<double> means = left_;
    for (std::size_t j = 0; j < means.size(); ++j)
      means[j] /= static_cast<double>(std::max<std::size_t>(working_.fit.column_counts[j], 1));
    return means;
  }

  double largest_left() const {
    double largest = 0.0;
    for (const double mean : left_by_counts()) largest = std::max(largest, std::abs(mean));
    return largest;
  }

  std::vector<double> sums_less_row_means(const std::vector<double>& of_columns) const {
    const AdditiveFit& fit = working_.fit;
    std::vector<double> sums(fit.columns, 0.0);
    for (std::size_t i = 0; i < fit.levels.size(); ++i) {
      if (fit.row_counts[i] == 0) continue;
      const double* there = working_.there.data() + i * fit.columns;
      double mean = 0.0;
      for (std::size_t j = 0; j < fit.columns; ++j) mean += there[j] * of_columns[j];
      mean /= static_cast<double>(fit.row_counts[i]);
      for (std::size_t j = 0; j < fit.columns; ++j) sums[j] += there[j] * (of_columns[j] - mean);
    }
    return sums;
  }

  const Working& working_;
  double enough_;
  std::vector<double> left_, found_, best_;
  double least_left_ = 0.0;
};

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
    if (std::max(pass == 0 ? 0.0 : moved, last.largest_of_rows) <= settled * spread) return;
  }
  std::vector<double> missing = MissingShifts(working, spread).solve();
  for (std::size_t j = 0; j < fit.columns; ++j) fit.shifts[j] += missing[j];
  sweep(working, std::move(missing));
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
