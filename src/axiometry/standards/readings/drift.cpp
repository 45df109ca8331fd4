// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/readings/drift.h"

#include <cmath>
#include <vector>

namespace axiometry {
namespace {

constexpr double seconds_per_hour = 3600.0;

/// Of the readings of one run, about the means of their target and direction.
struct RunSums {
  double t = 0.0;
  double x = 0.0;
  std::size_t readings = 0;
};

/// Sums about the means of a target and direction, over all of them.
struct Sums {
  double tt = 0.0;
  double tx = 0.0;
  std::vector<RunSums> runs;
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
    sums.runs[j].t += t;
    sums.runs[j].x += x;
    ++sums.runs[j].readings;
  }
}

struct SlopeScatter {
  double u = 0.0;
  std::size_t degrees_of_freedom = 0;
};

/// Of the slope, from the means of the runs about their own line. Readings of one run are not independent: a run that
/// lies elsewhere as a whole moves them all.
std::optional<SlopeScatter> scatter_of_runs(const std::vector<RunSums>& runs) {
  const auto weight = [](const RunSums& run) {  // t and x are sums over the run: a run of n readings counts n times
    return run.readings > 0 ? 1.0 / static_cast<double>(run.readings) : 0.0;
  };
  double tt = 0.0, tx = 0.0;
  std::size_t counted = 0;
  for (const RunSums& run : runs) {
    tt += weight(run) * run.t * run.t;
    tx += weight(run) * run.t * run.x;
    if (run.readings > 0) ++counted;
  }
  if (counted < 3 || !(tt > 0.0)) return std::nullopt;
  const std::size_t nu = counted - 2;
  double residuals = 0.0;  // summed one by one: for runs on a line a difference of sums is rounding alone
  for (const RunSums& run : runs) {
    const double off = run.x - tx / tt * run.t;
    residuals += weight(run) * off * off;
  }
  return SlopeScatter{std::sqrt(residuals / static_cast<double>(nu) / tt), nu};
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
  sums.runs.resize(test.series.run_count());
  for (Direction direction : {Direction::up, Direction::down})
    for (std::size_t i = 0; i < test.series.target_count(); ++i) add_cell(sums, test, drift.course, i, direction);
  if (!(sums.tt > 0.0)) return std::nullopt;
  const double b = sums.tx / sums.tt;
  drift.over_test = Deviation::native(b);
  if (const auto scatter = scatter_of_runs(sums.runs)) {
    drift.u = Deviation::native(scatter->u);
    drift.degrees_of_freedom = scatter->degrees_of_freedom;
  }
  return drift;
}

}  // namespace axiometry
