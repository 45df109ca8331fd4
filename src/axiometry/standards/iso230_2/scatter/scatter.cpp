// SPDX-License-Identifier: Apache-2.0
//
// Outliers: the largest studentised residual, one after the other (generalised ESD: Rosner, Technometrics 25 (1983)
// 165), and in each cell alone (Grubbs). Variances: Cochran's C in the form of F, in which its critical values are
// exact for equal n and conservative for unequal n. Shifts and slopes of runs: analysis of variance.
#include "axiometry/standards/iso230_2/scatter/scatter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>

#include "axiometry/base/contract.h"
#include "axiometry/numeric/additive_table.h"
#include "axiometry/numeric/distributions/f_distribution.h"
#include "axiometry/numeric/moments.h"
#include "axiometry/standards/iso230_2/scatter/direction_tables.h"
#include "axiometry/standards/iso230_2/scatter/outliers.h"
#include "axiometry/standards/iso230_2/scatter/tilts_between.h"
#include "axiometry/standards/iso230_2/scatter/variance_ratio.h"

namespace axiometry::iso230_2 {
namespace {

using numeric::AdditiveFit;
using scatter::Candidate;
using scatter::cell_outliers;
using scatter::DirectionFits;
using scatter::each_direction;
using scatter::fits_of;
using scatter::index;
using scatter::means_of;
using scatter::pooled_outliers;
using scatter::ratio_tail;
using scatter::Rounding;
using scatter::row_squares;
using scatter::rows_of;
using scatter::series_of;
using scatter::Sum;
using scatter::Tables;
using scatter::tables_of;

constexpr double gone = std::numeric_limits<double>::quiet_NaN();
constexpr double pooled_share = 3.0 / 4;     // share of the significance level for outliers; single cells have the rest
constexpr double much_wider = 1.5;           // s of a part of the test divided by s of the rest
constexpr double shifts_worth_a_word = 0.5;  // variance between runs divided by that within runs
constexpr double ordered_by_chance = 0.02;   // probability of runs that only rise or only fall

}  // namespace

double step_of(const Series& series) {
  constexpr double most_steps = 1e13;
  for (double unit = 1.0; unit > 0.5e-4; unit /= 10.0) {
    std::int64_t common = 0;
    /// Whether x is a whole multiple of the unit. A decimal is off by half a unit in its last place, and what computed
    /// it by some more.
    const auto takes = [&](double x) {
      if (std::isnan(x)) return true;
      const double steps = x / unit;
      if (!(std::abs(steps) < most_steps)) return false;
      const auto whole = static_cast<std::int64_t>(steps + (steps < 0.0 ? -0.5 : 0.5));  // the nearest
      if (std::abs(x - static_cast<double>(whole) * unit) >
          8.0 * std::numeric_limits<double>::epsilon() * std::abs(x) + 1e-9 * unit)
        return false;
      if (common != 1) common = std::gcd(common, whole);
      return true;
    };
    const bool whole = std::ranges::all_of(each_direction, [&](Direction d) {
      for (std::size_t i = 0; i < series.target_count(); ++i)
        if (!std::ranges::all_of(series.cell(i, d), takes)) return false;
      return true;
    });
    if (whole) return static_cast<double>(common) * unit;
  }
  return 0.0;
}

namespace {

/// s_i² of a cell and its degrees of freedom.
struct CellVariance {
  double variance = 0.0;
  double degrees = 0.0;  ///< 0 where there is none
};

using CellVariances = std::array<std::vector<CellVariance>, 2>;

CellVariances cell_variances(const Tables& tables, std::size_t targets, std::size_t runs) {
  CellVariances all;
  for (std::size_t d = 0; d < 2; ++d) {
    all[d].reserve(targets);
    for (std::size_t i = 0; i < targets; ++i) {
      const numeric::Moments m = numeric::moments(std::span(tables[d]).subspan(i * runs, runs));
      const double s = m.standard_deviation;
      all[d].push_back({s * s, m.count > 1 ? static_cast<double>(m.count - 1) : 0.0});
    }
  }
  return all;
}

void add_to(Sum& sum, const CellVariance& c) { sum.squares += c.variance * c.degrees, sum.degrees += c.degrees; }

/// Looks for the part of a test that stands out most.
class UnevenSearch {
 public:
  UnevenSearch(const CellVariances& cells, const Rounding& rounding) : cells_(cells), rounding_(rounding) {
    for (std::size_t d = 0; d < 2; ++d)
      for (const CellVariance& c : cells[d]) add_to(of_direction_[d], c);
    all_ = of_direction_[0];
    all_.squares += of_direction_[1].squares;
    all_.degrees += of_direction_[1].degrees;
  }

  void look_at_directions() {
    for (Direction d : each_direction) see({0, targets() - 1, d}, of_direction_[index(d)]);
  }

  /// The targets up to one, and those from one on, of both directions and of each.
  void look_at_stretches() {
    for (std::optional<Direction> d :
         {std::optional<Direction>(), std::optional(Direction::up), std::optional(Direction::down)}) {
      const Sum whole = d ? of_direction_[index(*d)] : all_;
      Sum before;
      for (std::size_t k = 1; k < targets(); ++k) {
        for (Direction each : each_direction)
          if (!d || *d == each) add_to(before, cells_[index(each)][k - 1]);
        see({0, k - 1, d}, before);
        see({k, targets() - 1, d}, whole - before);
      }
    }
  }

  /// Cochran: each cell. Where runs shift, also what is left of it without.
  void look_at_cells(const DirectionFits& fits) {
    const Sum left_of_all{fits[0].squares + fits[1].squares, fits[0].degrees + fits[1].degrees};
    for (Direction d : each_direction) {
      const AdditiveFit& fit = fits[index(d)];
      const double rows = rows_of(fit);
      for (std::size_t i = 0; i < targets(); ++i) {
        Sum own;
        add_to(own, cells_[index(d)][i]);
        see({i, i, d}, own);
        if (rows < 3.0 || own.degrees <= 0.0) continue;
        const Sum left{row_squares(fit, i, rows), own.degrees};
        see({i, i, d}, own, [&] { return ratio_tail(left, left_of_all - left, rounding_, level_of_look()); });
      }
    }
  }

  std::optional<UnevenScatter> found() const {
    if (!best_) return std::nullopt;
    UnevenScatter result = *best_;
    result.p = std::min(1.0, result.p * static_cast<double>(looks_));
    return result.p <= uneven_level ? std::optional(result) : std::nullopt;
  }

 private:
  std::size_t targets() const { return cells_[0].size(); }

  void see(const UnevenScatter& part, const Sum& own) {
    see(part, own, [] { return 1.0; });
  }

  /// What is more probable than this is not found, after however many looks.
  double level_of_look() const { return uneven_level / static_cast<double>(looks_); }

  /// A part beside all that is not in it, so that the parts can be compared; `chance` is another one of it.
  template <typename Chance>
  void see(UnevenScatter part, const Sum& own, const Chance& chance) {
    constexpr double surely = 0.999 * much_wider * much_wider;
    const Sum rest = all_ - own;
    if (own.degrees <= 0.0 || rest.degrees <= 0.0) return;
    ++looks_;
    if (own.squares * rest.degrees < surely * rest.squares * own.degrees) return;
    part.within = Deviation::native(std::sqrt(own.variance()));
    part.elsewhere = Deviation::native(std::sqrt(rest.variance()));
    if (part.within.in_native() < much_wider * part.elsewhere.in_native()) return;
    part.p = std::min(chance(), ratio_tail(own, rest, rounding_, level_of_look()));
    if (!best_ || part.p < best_->p) best_ = part;
  }

  const CellVariances& cells_;
  Rounding rounding_;
  std::array<Sum, 2> of_direction_;
  Sum all_;
  std::size_t looks_ = 0;
  std::optional<UnevenScatter> best_;
};

/// Whether the shifts go one way: by the regression on the number of the run, or because every run goes on.
void describe_order(RunShifts& result, const std::vector<double>& shifts) {
  std::vector<std::pair<double, double>> points;
  for (std::size_t j = 0; j < shifts.size(); ++j) {
    if (std::isnan(shifts[j])) continue;
    points.emplace_back(static_cast<double>(j), shifts[j]);
    if (std::abs(shifts[j]) > std::abs(result.shift.in_native()))
      result.run = j, result.shift = Deviation::native(shifts[j]);
  }
  const auto n = static_cast<double>(points.size());
  double mean_j = 0.0, mean_x = 0.0;
  for (const auto& [j, x] : points) mean_j += j / n, mean_x += x / n;
  double jj = 0.0, jx = 0.0, xx = 0.0;
  for (const auto& [j, x] : points)
    jj += (j - mean_j) * (j - mean_j), jx += (j - mean_j) * (x - mean_x), xx += (x - mean_x) * (x - mean_x);
  if (!(jj > 0.0) || points.size() < 3) return;
  result.drift = Deviation::native(jx / jj * (points.back().first - points.front().first));
  const double explained = jx * jx / jj;
  const double p = numeric::f_tail(explained * (n - 2.0) / std::max(xx - explained, 1e-300), {1.0, n - 2.0});
  const auto second = [](const auto& point) { return point.second; };
  const bool goes_on = std::ranges::is_sorted(points, std::ranges::less_equal{}, second) ||
                       std::ranges::is_sorted(points, std::ranges::greater_equal{}, second);
  result.ordered = p <= 0.01 || (goes_on && 2.0 / std::tgamma(n + 1.0) <= ordered_by_chance);
}

std::optional<RunShifts> shifts_between(const DirectionFits& fits, const Rounding& rounding) {
  Sum between, within;
  double readings = 0.0;
  for (const AdditiveFit& fit : fits) {
    double runs = 0.0;
    for (std::size_t j = 0; j < fit.columns; ++j) {
      const auto m = static_cast<double>(fit.column_counts[j]);
      if (m == 0.0) continue;
      between.squares += m * fit.shifts[j] * fit.shifts[j];
      runs += 1.0;
    }
    if (runs < 2.0) continue;
    between.degrees += runs - 1.0;
    readings += static_cast<double>(fit.count) * (runs - 1.0) / runs;
    within.squares += fit.squares;
    within.degrees += fit.degrees;
  }
  if (between.degrees < 2.0 || within.degrees < 4.0) return std::nullopt;
  const double noise = std::max(within.variance(), rounding.variance());
  const double m = readings / between.degrees;
  const double variance = std::max(0.0, between.variance() - noise) / m;
  RunShifts result;
  result.p = ratio_tail(between, within, rounding, shift_level);
  if (result.p > shift_level || variance < shifts_worth_a_word * noise || !(variance > 0.0)) return std::nullopt;
  result.between = Deviation::native(std::sqrt(variance));
  result.within = Deviation::native(std::sqrt(within.variance()));
  describe_order(result, means_of(fits[0].shifts, fits[1].shifts));
  return result;
}

OutlyingReading reading_of(const Series& series, Direction d, const Candidate& c, const AdditiveFit& fit) {
  const double x = series.cell(c.at.row, d)[c.at.column];
  return {c.at.row,
          d,
          c.at.column,
          Deviation::native(x),
          Deviation::native(fit.row(c.at.row)[c.at.column] / fit.share(c.at.row, c.at.column)),
          std::min(1.0, c.p)};
}

bool same_place(const OutlyingReading& a, const OutlyingReading& b) {
  return a.direction == b.direction && a.target == b.target && a.run == b.run;
}

/// NaN in place of the outliers.
Tables cleaned(Tables tables, const std::vector<OutlyingReading>& outliers, std::size_t runs) {
  for (const OutlyingReading& o : outliers) tables[index(o.direction)][o.target * runs + o.run] = gone;
  return tables;
}

}  // namespace

ScatterStudy scatter_study(const Series& series, double step) {
  const std::size_t runs = series.run_count();
  ScatterStudy study;
  if (runs < 2) return study;
  const Rounding rounding{step};
  const Tables readings = tables_of(series);
  const std::vector<double> levers = tilt_levers(series);
  const DirectionFits of_readings = fits_of(readings, runs);
  const double cells = rows_of(of_readings[0]) + rows_of(of_readings[1]);
  // Runs with slopes of their own are one thing, not targets at the ends that scatter more; an outlier is no slope.
  const bool tilted = scatter::tilts_between(of_readings, levers, rounding).has_value();
  const auto fits_of_tables = [&](const Tables& some) {
    DirectionFits own = fits_of(some, runs);
    for (numeric::AdditiveFit& fit : own)
      if (tilted) fit.degrees = std::max(0.0, fit.degrees - static_cast<double>(runs - 1));
    return own;
  };
  Tables without_slopes;
  DirectionFits beside_slopes;
  const Tables& tables = tilted ? without_slopes : readings;
  const DirectionFits& fits = tilted ? beside_slopes : of_readings;
  const auto by_cells = [&](const DirectionFits& own, double level) {
    std::vector<OutlyingReading> all;
    for (Direction d : each_direction)
      for (const Candidate& c : cell_outliers(own[index(d)], rounding, cells, level))
        all.push_back(reading_of(series, d, c, own[index(d)]));
    return all;
  };
  constexpr int looks_at_tilted = 4;
  for (int look = 0; look < (tilted ? looks_at_tilted : 1); ++look) {
    if (tilted) {
      without_slopes = scatter::untilted(readings, cleaned(readings, study.outliers, runs), levers, runs);
      beside_slopes = fits_of_tables(without_slopes);
    }
    std::vector<OutlyingReading> found;
    for (Direction d : each_direction)
      for (const Candidate& c :
           pooled_outliers(fits[index(d)], tables[index(d)], rounding, 0.5 * pooled_share * outlier_level))
        found.push_back(reading_of(series, d, {c.at, 2.0 * c.p}, fits[index(d)]));
    const bool same = std::ranges::equal(found, study.outliers, same_place);
    study.outliers = std::move(found);
    if (same) break;
  }

  DirectionFits others;  // the last one that was asked for
  const auto fits_without_outliers = [&]() -> const DirectionFits& {
    return study.outliers.empty() ? fits : others = fits_of_tables(cleaned(tables, study.outliers, runs));
  };
  const CellVariances variances = cell_variances(cleaned(tables, study.outliers, runs), series.target_count(), runs);
  UnevenSearch search(variances, rounding);
  search.look_at_directions();
  search.look_at_stretches();
  // One gross error shifts what its run lets expect everywhere: cells are looked at without it.
  const DirectionFits& fits_without = fits_without_outliers();
  search.look_at_cells(fits_without);
  study.uneven = search.found();

  if (study.uneven) {
    // One measure for all readings would be none: what it found must stand out of its own cell too.
    const std::vector<OutlyingReading> of_cells = by_cells(fits, outlier_level);
    std::erase_if(study.outliers, [&](const OutlyingReading& o) {
      return std::ranges::none_of(of_cells, [&](const OutlyingReading& own) { return same_place(o, own); });
    });
    for (const OutlyingReading& o : by_cells(fits_without, outlier_level)) study.outliers.push_back(o);
  } else {
    for (const OutlyingReading& o : by_cells(fits_without, (1.0 - pooled_share) * outlier_level))
      if (std::ranges::none_of(study.outliers, [&](const OutlyingReading& known) {
            return known.direction == o.direction && known.target == o.target;
          }))
        study.outliers.push_back(o);
  }
  std::ranges::sort(study.outliers, {}, [](const OutlyingReading& o) {
    return std::array{index(o.direction), o.target, o.run};
  });
  DirectionFits of_cleaned;
  const DirectionFits& as_read =
      study.outliers.empty() ? of_readings : of_cleaned = fits_of(cleaned(readings, study.outliers, runs), runs);
  study.shifts = shifts_between(as_read, rounding);
  study.tilts = scatter::tilts_between(as_read, levers, rounding);
  return study;
}

Series without_shifts(const Series& series) {
  Tables tables = tables_of(series);
  const std::size_t runs = series.run_count();
  const DirectionFits fits = fits_of(tables, runs);
  for (std::size_t d = 0; d < 2; ++d)
    for (std::size_t k = 0; k < tables[d].size(); ++k)
      if (!std::isnan(tables[d][k])) tables[d][k] -= fits[d].shifts[k % runs];
  return series_of(series, tables);
}

}  // namespace axiometry::iso230_2
