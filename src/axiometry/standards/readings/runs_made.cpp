// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/readings/runs_made.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "axiometry/base/contract.h"

namespace axiometry {

namespace {

/// Of each run whether at least one target has a reading.
std::vector<bool> are_made(const Series& series, Direction direction) {
  std::vector<bool> made(series.run_count(), false);
  for (std::size_t i = 0; i < series.target_count(); ++i) {
    const auto cell = series.cell(i, direction);
    for (std::size_t j = 0; j < cell.size(); ++j)
      if (!std::isnan(cell[j])) made[j] = true;
  }
  return made;
}

}  // namespace

std::size_t runs_made(const Series& series, Direction direction) {
  if (series.complete()) return series.run_count();
  return static_cast<std::size_t>(std::ranges::count(are_made(series, direction), true));
}

std::size_t most_runs_made(const Series& series) {
  return std::max(runs_made(series, Direction::up), runs_made(series, Direction::down));
}

Series without_empty_runs(const Series& series) {
  if (series.complete()) return series;
  const std::vector<bool> up = are_made(series, Direction::up), down = are_made(series, Direction::down);
  std::vector<std::size_t> of_up, of_down, of_any;
  for (std::size_t j = 0; j < series.run_count(); ++j) {
    if (up[j]) of_up.push_back(j);
    if (down[j]) of_down.push_back(j);
    if (up[j] || down[j]) of_any.push_back(j);
  }
  const bool one_way = of_up.size() == of_down.size() && of_any.size() == of_up.size() + of_down.size();
  if (!one_way && of_any.size() == series.run_count()) return series;
  std::vector<double> deviations;
  for (const Direction direction : {Direction::up, Direction::down})
    for (std::size_t i = 0; i < series.target_count(); ++i)
      for (const std::size_t j : !one_way ? of_any : direction == Direction::up ? of_up : of_down)
        deviations.push_back(series.cell(i, direction)[j]);
  auto closed = Series::make_dense({series.targets().begin(), series.targets().end()},
                                   one_way ? of_up.size() : of_any.size(), std::move(deviations));
  AXIOMETRY_CONTRACT(closed);  // the same readings under other numbers
  return *std::move(closed);
}

}  // namespace axiometry
