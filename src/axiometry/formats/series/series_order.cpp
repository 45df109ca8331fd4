// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/series/series_order.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "axiometry/base/contract.h"
#include "axiometry/base/read_budget.h"

namespace axiometry::formats {

Result<Series> sorted_series(std::vector<Position> targets, std::size_t runs, std::vector<double> deviations) {
  if (std::ranges::is_sorted(targets)) return Series::make_dense(std::move(targets), runs, std::move(deviations));
  const std::size_t m = targets.size();
  AXIOMETRY_CONTRACT(deviations.size() == 2 * m * runs);
  std::vector<std::size_t> order(m);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t k) { return targets[k]; });
  std::vector<Position> sorted_targets(m);
  std::vector<double> sorted(deviations.size());
  for (std::size_t i = 0; i < m; ++i) {
    sorted_targets[i] = targets[order[i]];
    for (std::size_t d = 0; d < 2; ++d)
      std::copy_n(deviations.data() + (d * m + order[i]) * runs, runs, sorted.data() + (d * m + i) * runs);
  }
  return Series::make_dense(std::move(sorted_targets), runs, std::move(sorted));
}

Result<void> check_deviations(const Series& series, AxisKind kind) {
  constexpr double share_of_travel = 0.01;
  const double per_position = deviation_per_position(kind);
  const double tolerance = share_of_travel * series.travel_native() * per_position;
  for (std::size_t i = series.target_count(); i-- > 0;)
    for (Direction direction : {Direction::up, Direction::down})
      for (double x : series.cell(i, direction))
        if (!std::isnan(x) && !(std::abs(x - series.targets()[i].in_native() * per_position) <= tolerance)) return {};
  return fail(
      "found deviations as large as the target positions, expected measured minus target; a column of measured "
      "positions is named so, as in measured_mm or measured_deg");
}

Result<void> check_grid(const Grid& grid) {
  if (2 * grid.targets * grid.runs <= read_budget::grid_cells_per_reading * grid.readings + read_budget::runs)
    return {};
  return fail(
      fmt::format("found run {} among {} readings, expected consecutive run numbers", grid.runs, grid.readings));
}

}  // namespace axiometry::formats
