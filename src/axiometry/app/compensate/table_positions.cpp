// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/compensate/table_positions.h"

#include <cmath>
#include <optional>

namespace axiometry::app {
namespace {

/// The spacing of targets that are evenly spaced from a reference point on.
std::optional<double> spacing_from(double reference, const std::vector<double>& targets) {
  constexpr double slack = 1e-6;
  if (targets.size() < 2) return std::nullopt;
  const double step = (targets.back() - targets.front()) / static_cast<double>(targets.size() - 1);
  for (const double target : targets) {
    const double steps = (target - reference) / step;
    if (std::abs(steps - std::round(steps)) > slack) return std::nullopt;
  }
  return step;
}

}  // namespace

bool is_wished(const compensation::GridRequest& grid) { return grid.start || grid.end || grid.step || grid.points; }

Result<std::vector<double>> table_positions(const nc::AxisTable& control, double reference,
                                            const compensation::GridRequest& wished,
                                            const std::vector<double>& targets) {
  const nc::AxisTableLimits& limits = control.limits;
  if (limits.points == 1) return std::vector{reference};
  if (limits.points == 2 && !is_wished(wished) && targets.size() > 1)
    return std::vector{targets.front(), targets.back()};
  compensation::GridRequest wish = wished;
  compensation::GridLimits allowed{limits.points, limits.equidistant, limits.step_native, {}};
  if (limits.origin != nc::TableOrigin::anywhere) allowed.anchor = reference;
  if (limits.origin == nc::TableOrigin::on_grid && !is_wished(wish) &&
      (targets.size() <= limits.points || limits.points == 0))
    wish.step = spacing_from(reference, targets);
  if (limits.origin == nc::TableOrigin::first && !wish.start) wish.start = reference;
  if (limits.origin == nc::TableOrigin::last && !wish.end) wish.end = reference;
  return compensation::grid_of(targets, wish, allowed);
}

}  // namespace axiometry::app
