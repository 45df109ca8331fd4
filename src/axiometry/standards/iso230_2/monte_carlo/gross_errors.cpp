// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/monte_carlo/gross_errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

#include "axiometry/base/text/rounded_text.h"
#include "axiometry/numeric/distributions/chi_square.h"
#include "axiometry/numeric/distributions/normal_and_student_t.h"
#include "axiometry/numeric/leave_one_out.h"
#include "axiometry/numeric/median.h"
#include "axiometry/standards/iso230_2/scatter/scatter.h"

namespace axiometry::iso230_2 {
namespace {

constexpr double several_from = 3.0;     // standard deviations
constexpr double several_alarms = 1e-3;  // share of tests without gross errors that give an alarm
constexpr double finest_step = 1e-4;     // native unit; readings that differ by less are alike
constexpr double median_of_normal = 0.67448975;
constexpr double trimmed_beyond = 3.0;       // standard deviations, …
constexpr double variance_within = 0.97334;  // … and the variance of normal numbers that are not
constexpr double own_share = 0.7;            // share of a cell's own standard deviation: 1 in 10 cells exceeds it
constexpr int polishes = 2;
constexpr std::size_t least_cells = 3;  // cells of a run by which its shift can be told from scatter
constexpr std::size_t neighbours = 4;   // readings before and after, whose median follows a drift

/// 0 of none.
double middle_of(std::vector<double> values) { return values.empty() ? 0.0 : numeric::median_of(values); }

/// Variance of the median of k standard normal numbers; exact to two digits up to 9, then its limit π/2k.
double median_variance(std::size_t k) {
  constexpr double table[] = {0.0, 1.0, 0.5, 0.449, 0.298, 0.287, 0.215, 0.210, 0.168, 0.166};
  return k < std::size(table) ? table[k] : std::numbers::pi / (2.0 * double(k));
}

struct CellReadings {
  std::size_t target;
  Direction direction;
  std::vector<double> readings;  ///< without what they drift by
  double centre = 0.0;           ///< median of the readings
};

std::vector<double> present(std::span<const double> readings) {
  std::vector<double> values;
  for (double x : readings)
    if (!std::isnan(x)) values.push_back(x);
  return values;
}

/// Where a reading of a run stands, and when it was taken.
struct Moment {
  double share;
  std::size_t cell;
};

std::vector<Moment> moments_of(std::size_t run, const std::vector<CellReadings>& cells, const Series& series,
                               const TestCourse& course) {
  std::vector<Moment> moments;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const double share = course.at(series, cells[c].target, cells[c].direction, run);
    if (!std::isnan(share) && !std::isnan(cells[c].readings[run])) moments.push_back({share, c});
  }
  std::ranges::stable_sort(moments, {}, &Moment::share);
  return moments;
}

/// What neighbours of a run depart by in common is a drift or a shift of the run, no error of one of them: the medians
/// of the cells, and of the neighbours along the time, are taken out in turn.
void take_out_drift(std::vector<CellReadings>& cells, std::size_t run, std::span<const Moment> moments) {
  if (moments.size() < least_cells) return;
  std::vector<double> departures;
  for (const Moment& m : moments) departures.push_back(cells[m.cell].readings[run] - cells[m.cell].centre);
  const std::size_t window = std::min(2 * neighbours + 1, moments.size());
  for (std::size_t k = 0; k < moments.size(); ++k) {
    const std::size_t begin = std::min(k < neighbours ? 0 : k - neighbours, moments.size() - window);
    std::vector<double> others;  // without its own: a reading must not hide itself
    for (std::size_t l = begin; l < begin + window; ++l)
      if (l != k) others.push_back(departures[l]);
    cells[moments[k].cell].readings[run] -= middle_of(std::move(others));
  }
}

void take_out_drift(std::vector<CellReadings>& cells, const Series& series, const TestCourse& course) {
  for (int polish = 0; polish < polishes; ++polish) {
    for (CellReadings& cell : cells) cell.centre = middle_of(present(cell.readings));
    for (std::size_t j = 0; j < series.run_count(); ++j) take_out_drift(cells, j, moments_of(j, cells, series, course));
  }
}

struct Departure {
  std::size_t cell, run;
  double size;
  double relative_sd;  ///< standard deviation of the departure, in units of the scatter
  double others_sd;    ///< standard deviation of the other readings
};

double standard_deviation(std::span<const double> values) {
  double mean = 0.0, squares = 0.0;
  for (double x : values) mean += x / double(values.size());
  for (double x : values) squares += (x - mean) * (x - mean);
  return std::sqrt(squares / double(values.size() - 1));
}

/// Standard deviation of the others without the one farthest from their median, made up for what leaving out the
/// farthest of normal numbers takes; of three others that of all. A second gross error must not hide the first.
double scatter_but_for_one(const numeric::LeaveOneOut& readings, std::size_t reading, std::size_t others) {
  constexpr double made_up[] = {1.657, 1.453, 1.378, 1.313, 1.279, 1.247, 1.225};  // factors for 4 to 10 values
  if (others <= 3) return readings.deviation_without(reading);
  return made_up[std::min(others - 4, std::size(made_up) - 1)] * readings.deviation_but_for_farthest(reading);
}

std::vector<Departure> departures_of(const std::vector<CellReadings>& cells) {
  std::vector<Departure> found;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const std::vector<double> values = present(cells[c].readings);
    if (values.size() < 2) continue;
    const std::size_t others = values.size() - 1;
    const double relative = std::sqrt(1.0 + median_variance(others));
    const numeric::LeaveOneOut readings(values);
    std::size_t number = 0;
    for (std::size_t j = 0; j < cells[c].readings.size(); ++j) {
      const double reading = cells[c].readings[j];
      if (std::isnan(reading)) continue;
      const double sd = others > 2 ? scatter_but_for_one(readings, number, others) : 0.0;
      found.push_back({c, j, reading - readings.median_without(number++), relative, sd});
    }
  }
  return found;
}

/// The median over the cells of their standard deviations, each made up for its few readings. With few approaches one
/// gross error makes every departure of its cell large, and half of all departures may be so.
double scatter_of_cells(const std::vector<CellReadings>& cells) {
  std::vector<double> scatters;
  for (const CellReadings& cell : cells) {
    const std::vector<double> values = present(cell.readings);
    if (values.size() < 2) continue;
    const auto freedom = double(values.size() - 1);
    scatters.push_back(standard_deviation(values) / std::sqrt(numeric::chi_square_quantile(0.5, freedom) / freedom));
  }
  return middle_of(std::move(scatters));
}

/// A median tells which departures are those of normal scatter, that of the cells or that of all departures, whichever
/// the gross errors have moved less; all of these then tell its size.
double scatter_of(const std::vector<double>& sizes, const std::vector<CellReadings>& cells) {
  const double first = std::min(middle_of(sizes) / median_of_normal, scatter_of_cells(cells));
  double squares = 0.0;
  double count = 0.0;
  for (double size : sizes) {
    if (size > trimmed_beyond * first) continue;
    squares += size * size;
    count += 1.0;
  }
  return count > 0.0 ? std::sqrt(squares / (count * variance_within)) : 0.0;
}

/// Whether more departures are large, none of them beyond all scatter, than a normal distribution has: 1 test in 1000.
bool too_many(const std::vector<Departure>& departures, double scatter) {
  double large = 0.0;
  for (const Departure& d : departures)
    large += std::abs(d.size) > several_from * d.relative_sd * std::max(scatter, own_share * d.others_sd) ? 1.0 : 0.0;
  if (large == 0.0) return false;
  // The count is Poisson's: P(k or more of λ) = P(χ² ≤ 2λ) of 2k degrees of freedom.
  const double expected = 2.0 * numeric::normal_probability(-several_from) * double(departures.size());
  return numeric::chi_square_probability(2.0 * expected, 2.0 * large) < several_alarms;
}

}  // namespace

std::vector<GrossError> gross_errors(const Series& as_read, const TestCourse& course, double step,
                                     double false_alarms) {
  const Series series = scatter_study(as_read, step).tilts ? without_tilts(as_read) : as_read;
  std::vector<CellReadings> cells;
  for (Direction direction : {Direction::up, Direction::down})
    for (std::size_t i = 0; i < series.target_count(); ++i)
      if (series.count(i, direction) > 0) {
        const auto readings = series.cell(i, direction);
        cells.push_back({i, direction, {readings.begin(), readings.end()}, 0.0});
      }
  take_out_drift(cells, series, course);
  const std::vector<Departure> departures = departures_of(cells);
  std::vector<double> sizes;
  for (const Departure& d : departures) sizes.push_back(std::abs(d.size) / d.relative_sd);
  std::vector<GrossError> found;
  if (sizes.empty()) return found;
  const auto count = double(sizes.size());
  const double freedom = count - double(cells.size());  // at least 1, as there are departures
  const double limit = -numeric::student_t_quantile(0.5 * false_alarms / count, std::max(1.0, freedom));
  const double scatter = std::max({scatter_of(sizes, cells), 0.5 * step, 0.5 * finest_step});
  const double lower = too_many(departures, scatter) ? several_from : limit;
  for (const Departure& d : departures) {
    const double sd = d.relative_sd * std::max(scatter, own_share * d.others_sd);
    if (!(std::abs(d.size) > std::min(lower, limit) * sd)) continue;
    found.push_back({cells[d.cell].target, cells[d.cell].direction, d.run, Deviation::native(d.size),
                     sd > 0.0 ? std::abs(d.size) / sd : std::numeric_limits<double>::infinity()});
  }
  std::ranges::stable_sort(found, std::ranges::greater{}, &GrossError::factor);
  return found;
}

std::string reason_of(std::span<const GrossError> found, const Test& test) {
  if (found.empty()) return {};
  const GrossError& worst = found.front();
  const AxisKind kind = test.metadata.axis.kind;
  std::string reason = fmt::format(
      "{} of run {} at {} {} departs by {} {} from the other approaches, {:.1f} times the standard deviation "
      "of such a departure",
      arrow(worst.direction), worst.run + 1, format_significant(test.series.targets()[worst.target].in_native(), 6),
      position_unit(kind), format_significant(worst.departure.in_native(), 3), deviation_unit(kind), worst.factor);
  if (found.size() > 1) reason += fmt::format("; such readings: {}", found.size());
  return reason;
}

}  // namespace axiometry::iso230_2
