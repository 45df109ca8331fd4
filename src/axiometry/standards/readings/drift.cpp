// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/readings/drift.h"

#include <cmath>

namespace axiometry {
namespace {

constexpr double seconds_per_hour = 3600.0;

/// Sums about the means of a target and direction, over all of them.
struct Sums {
  double tt = 0.0;
  double tx = 0.0;
  double xx = 0.0;
  std::size_t readings = 0;
  std::size_t cells = 0;
};

void add_cell(Sums& sums, const Test& test, const TestCourse& course, std::size_t target, Direction direction) {
  const auto cell = test.series.cell(target, direction);
  double mean_t = 0.0;
  double mean_x = 0.0;
  std::size_t count = 0;
  for (std::size_t j = 0; j < cell.size(); ++j) {
    if (std::isnan(cell[j])) continue;
    mean_t += course.at(test.series, target, direction, j);
    mean_x += cell[j];
    ++count;
  }
  if (count < 2) return;
  mean_t /= static_cast<double>(count);
  mean_x /= static_cast<double>(count);
  for (std::size_t j = 0; j < cell.size(); ++j) {
    if (std::isnan(cell[j])) continue;
    const double t = course.at(test.series, target, direction, j) - mean_t;
    const double x = cell[j] - mean_x;
    sums.tt += t * t;
    sums.tx += t * x;
    sums.xx += x * x;
  }
  sums.readings += count;
  ++sums.cells;
}

}  // namespace

std::optional<double> Drift::per_hour(Deviation over_whole_test) const {
  if (!course.duration) return std::nullopt;
  return over_whole_test.in_native() / course.duration->in_s() * seconds_per_hour;
}

double Drift::per_reading(Deviation over_whole_test) const {
  return over_whole_test.in_native() / static_cast<double>(course.steps);
}

std::optional<Drift> drift_of(const Test& test) {
  Drift drift{{}, std::nullopt, 0, course_of(test)};
  if (!drift.course.order_known) return std::nullopt;
  Sums sums;
  for (Direction direction : {Direction::up, Direction::down})
    for (std::size_t i = 0; i < test.series.target_count(); ++i) add_cell(sums, test, drift.course, i, direction);
  if (!(sums.tt > 0.0)) return std::nullopt;
  const double b = sums.tx / sums.tt;
  drift.over_test = Deviation::native(b);
  if (sums.readings < sums.cells + 2) return drift;
  drift.degrees_of_freedom = sums.readings - sums.cells - 1;
  const double residuals = std::fmax(0.0, sums.xx - b * sums.tx);
  drift.u = Deviation::native(std::sqrt(residuals / static_cast<double>(drift.degrees_of_freedom) / sums.tt));
  return drift;
}

}  // namespace axiometry
