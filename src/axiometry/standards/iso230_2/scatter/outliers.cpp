// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/scatter/outliers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "axiometry/numeric/distributions/normal_and_student_t.h"

namespace axiometry::iso230_2::scatter {
namespace {

using numeric::AdditiveFit;
using numeric::fit_additive;

constexpr std::size_t least_readings = 3;    // readings of a cell by which one can be told from the others
constexpr std::size_t outliers_at_most = 5;  // most in one direction; more are a matter of the scatter
constexpr double worth_a_look = 3.0;         // robust standard deviations, before anything is computed

/// Both tails of Student's t for a residual among others: `square` of it, freed of how much of the scatter its level
/// and shift have taken, beside the sum of all such squares. `degrees` are those of the sum.
double two_tails(double square, double rest, double degrees) {
  if (degrees < 2.0 || square <= 0.0) return 1.0;
  if (rest <= 0.0) return 0.0;
  return 2.0 * numeric::student_t_probability(-std::sqrt(square * (degrees - 1.0) / rest), degrees - 1.0);
}

/// Whether `looks` times both tails are surely more than the level. Those of Student's t are never less than those of
/// the normal law: of t√(χ²/ν) that is Jensen's inequality, since erfc(t√(v/2)) is convex in v.
bool surely_above(double level, double looks, double square, double rest, double degrees) {
  if (degrees < 2.0 || square <= 0.0) return looks > level;
  if (rest <= 0.0) return false;
  // Within three standard deviations erfc() need not be asked: it is 0.0026998 there, and more before.
  const double t_squared_rest = square * (degrees - 1.0);
  if (t_squared_rest <= 9.0 * rest && looks * 0.002699 > level) return true;
  return looks * std::erfc(std::sqrt(0.5 * t_squared_rest / rest)) > 1.000001 * level;
}

/// |e| less what rounding may have done to the reading, by how much of its own scatter a residual keeps.
double beyond_rounding(double residual, double share, const Rounding& rounding) {
  const double size = std::max(0.0, std::abs(residual) - rounding.step * share);
  return size * size / share;
}

/// Whether a look with a robust measure finds any residual worth the effort: that the largest is so far beyond the one
/// in the middle (the lower half has as many and one more).
bool worth_looking(const AdditiveFit& fit) {
  double largest = 0.0;
  for (double e : fit.residuals)
    if (std::abs(e) > largest) largest = std::abs(e);
  std::size_t small = 0;
  for (double e : fit.residuals) small += largest > worth_a_look * (1.4826 * std::abs(e)) ? 1 : 0;  // false for NaN
  return small > fit.count / 2;
}

/// The residual that stands out most, and what tells how probable it is.
struct Outlying {
  Place at;
  double square = 0.0;  ///< arguments of two_tails(): this and the next two
  double rest = 0.0;
  double degrees = 0.0;
  double looks = 0.0;

  double p() const { return std::min(1.0, two_tails(square, rest, degrees) * looks); }
  bool is_significant(double level) const { return !surely_above(level, looks, square, rest, degrees) && p() <= level; }
};

std::optional<Outlying> most_outlying(const AdditiveFit& fit, const Rounding& rounding) {
  std::optional<Place> worst;
  double largest = 0.0;
  std::size_t shortest = fit.count;  // column that is looked at
  for (std::size_t n : fit.column_counts)
    if (n >= least_readings) shortest = std::min(shortest, n);
  const double column_share = 1.0 - 1.0 / static_cast<double>(shortest);
  for (std::size_t i = 0; i < fit.levels.size(); ++i) {
    if (fit.row_counts[i] < least_readings) continue;
    const double least_share = (1.0 - 1.0 / static_cast<double>(fit.row_counts[i])) * column_share;
    for (std::size_t j = 0; j < fit.columns; ++j) {
      const double e = fit.row(i)[j];
      if (worst && e * e < 0.999999 * least_share * largest) continue;  // surely smaller, and no division
      if (std::isnan(e) || fit.column_counts[j] < least_readings) continue;
      const double size = e * e / fit.share(i, j);
      if (worst && size <= largest) continue;
      largest = size;
      worst = {i, j};
    }
  }
  if (!worst) return std::nullopt;
  const double e = fit.row(worst->row)[worst->column];
  const double share = fit.share(worst->row, worst->column);
  const double rest = std::max(fit.squares - e * e / share, (fit.degrees - 1.0) * rounding.variance());
  return Outlying{*worst, beyond_rounding(e, share, rounding), rest, fit.degrees, static_cast<double>(fit.count)};
}

}  // namespace

std::vector<Candidate> pooled_outliers(const AdditiveFit& whole, std::span<const double> of, const Rounding& rounding,
                                       double level) {
  if (!worth_looking(whole)) return {};
  std::vector<Outlying> seen;
  std::size_t significant = 0;
  AdditiveFit fit = whole;
  std::vector<double> table(of.begin(), of.end());
  const std::size_t at_most = std::clamp<std::size_t>(fit.count / 8, 1, outliers_at_most);
  while (seen.size() < at_most) {
    const auto next = most_outlying(fit, rounding);
    if (!next) break;
    seen.push_back(*next);
    if (next->is_significant(level)) significant = seen.size();
    if (seen.size() == at_most) break;
    table[next->at.row * fit.columns + next->at.column] = std::numeric_limits<double>::quiet_NaN();
    fit = fit_additive(table, fit.columns);
  }
  std::vector<Candidate> all;
  for (std::size_t k = 0; k < significant; ++k) all.push_back({seen[k].at, seen[k].p()});
  // Several of one cell are no outliers: that cell scatters.
  std::erase_if(all, [&](const Candidate& c) {
    return std::ranges::count_if(all, [&](const Candidate& o) { return o.at.row == c.at.row; }) > 1;
  });
  return all;
}

double row_squares(const AdditiveFit& fit, std::size_t i, double rows) {
  double sum = 0.0;
  for (double e : fit.row(i))
    if (!std::isnan(e)) sum += e * e;
  return sum * rows / (rows - 1.0);
}

double rows_of(const AdditiveFit& fit) {
  return static_cast<double>(std::ranges::count_if(fit.row_counts, [](std::size_t n) { return n > 0; }));
}

std::vector<Candidate> cell_outliers(const AdditiveFit& fit, const Rounding& rounding, double cells, double level) {
  std::vector<Candidate> all;
  const double rows = rows_of(fit);
  if (rows < 3.0) return all;
  for (std::size_t i = 0; i < fit.levels.size(); ++i) {
    if (fit.row_counts[i] < least_readings) continue;
    const auto n = static_cast<double>(fit.row_counts[i]);
    const double squares = row_squares(fit, i, rows);
    std::size_t worst = 0;
    double largest = -1.0;
    for (std::size_t j = 0; j < fit.columns; ++j)
      if (const double e = fit.row(i)[j]; std::abs(e) > largest) largest = std::abs(e), worst = j;
    const double share = (1.0 - 1.0 / n) * (1.0 - 1.0 / rows);
    const double rest = std::max(squares - largest * largest / share, (n - 2.0) * rounding.variance());
    const double square = beyond_rounding(largest, share, rounding);
    if (surely_above(level, cells * n, square, rest, n - 1.0)) continue;
    const double p = cells * n * two_tails(square, rest, n - 1.0);
    if (p <= level) all.push_back({{i, worst}, p});
  }
  return all;
}

}  // namespace axiometry::iso230_2::scatter
