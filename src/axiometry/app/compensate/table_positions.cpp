// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/compensate/table_positions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "axiometry/base/text/rounded_text.h"

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

/// And the value of each end at as many steps more as there are targets beyond it. Where these reach round a turn the
/// last step leads to the first position again, as the control has it.
Result<AxisCorrection> held_over_targets(const AxisCorrection& correction, const Series& series) {
  constexpr double beside = 1e-6, turn = 360.0;
  const std::vector<double>& positions = correction.positions();
  if (positions.size() < 2) return correction;
  const double first = positions.front(), last = positions.back(), step = positions[1] - first;
  const bool is_turn = correction.kind() == AxisKind::rotary && last - first > turn - beside;
  const auto steps = [step](double beyond) {
    return std::clamp(std::ceil((beyond - beside) / step), 0.0, static_cast<double>(AxisCorrection::nodes_max));
  };
  const double before = steps(first - series.targets().front().in_native());
  double behind = steps(series.targets().back().in_native() - last);
  if (before + behind == 0.0 || is_turn) return correction;
  const bool closes = correction.kind() == AxisKind::rotary && last - first + step * (before + behind) > turn - beside;
  if (closes) {
    const double in_turn = std::round(turn / step);
    behind = in_turn - before - static_cast<double>(positions.size() - 1);
    if (std::abs(in_turn * step - turn) > beside || behind < 1.0)
      return fail(fmt::format(
          "found positions from {} to {} °, every {} °, and targets round a turn: beyond its ends this control does "
          "not hold the last value but goes on to that of the other end; expected steps that divide a turn, or "
          "positions over all targets",
          format_rounded(first), format_rounded(last), format_rounded(step)));
  }
  std::vector<double> places, up, down;
  const auto add = [&](double place, std::size_t node) {
    places.push_back(place);
    up.push_back(correction.values(Direction::up)[node]);
    down.push_back(correction.values(Direction::down)[node]);
  };
  for (double k = before; k > 0.0; --k) add(first - step * k, 0);
  for (std::size_t node = 0; node < positions.size(); ++node) add(positions[node], node);
  for (double k = 1.0; k < behind; ++k) add(last + step * k, positions.size() - 1);
  if (behind > 0.0) add(last + step * behind, closes ? 0 : positions.size() - 1);
  return AxisCorrection::make(correction.kind(), std::move(places), std::move(up), std::move(down));
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
