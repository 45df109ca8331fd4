// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/compensate/table_positions.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

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

/// And the value of each end at as many steps more as there are targets beyond it.
Result<AxisCorrection> held_over_targets(const AxisCorrection& correction, const Series& series) {
  constexpr double beside = 1e-6, turn = 360.0;
  std::vector<double> positions = correction.positions();
  if (positions.size() < 2) return correction;
  const double first = positions.front(), last = positions.back(), step = positions[1] - first;
  const auto steps = [step](double beyond) {
    const double count = std::ceil((beyond - beside) / step);
    return static_cast<std::size_t>(std::clamp(count, 0.0, static_cast<double>(AxisCorrection::nodes_max)));
  };
  const std::size_t before = steps(first - series.targets().front().in_native());
  const std::size_t behind = steps(series.targets().back().in_native() - last);
  if (before + behind == 0) return correction;
  // Round a whole turn the other end is the next position of the axis too.
  const double covered = last - first + step * static_cast<double>(before + behind);
  if (correction.kind() == AxisKind::rotary && covered > turn - beside) return correction;
  std::vector<double> up = correction.values(Direction::up), down = correction.values(Direction::down);
  for (std::size_t k = 1; k <= before; ++k) {
    positions.insert(positions.begin(), first - step * static_cast<double>(k));
    up.insert(up.begin(), up.front());
    down.insert(down.begin(), down.front());
  }
  for (std::size_t k = 1; k <= behind; ++k) {
    positions.push_back(last + step * static_cast<double>(k));
    up.push_back(up.back());
    down.push_back(down.back());
  }
  return AxisCorrection::make(correction.kind(), std::move(positions), std::move(up), std::move(down));
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

Result<std::string> write_over_targets(const nc::AxisTable& control, const AxisCorrection& correction,
                                       const Series& series, const nc::AxisTableOptions& options) {
  if (!control.limits.rolls_over) return nc::write_table(control, correction, options);
  AXIOMETRY_TRY(const AxisCorrection held, held_over_targets(correction, series));
  return nc::write_table(control, held, options);
}

}  // namespace axiometry::app
