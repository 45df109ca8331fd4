// SPDX-License-Identifier: Apache-2.0
#include "axiometry/compensation/grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "axiometry/base/counted.h"
#include "axiometry/base/text/rounded_text.h"
#include "axiometry/model/axis_correction.h"
#include "axiometry/numeric/median.h"

namespace axiometry::compensation {
namespace {

constexpr double slack = 1e-6;  // mm or °, and of a number of steps

/// The round steps: …, 1, 2, 2.5, 5, 10, …; the largest that is at most `step`.
double round_step_at_most(double step) {
  const double decade = std::pow(10.0, std::floor(std::log10(step * (1.0 + slack))));
  double best = decade;
  for (const double factor : {2.0, 2.5, 5.0, 10.0})
    if (factor * decade <= step * (1.0 + slack)) best = factor * decade;
  return best;
}
double round_step_below(double step) { return round_step_at_most(step * (1.0 - 10.0 * slack)); }
double round_step_above(double step) {
  const double decade = std::pow(10.0, std::floor(std::log10(step * (1.0 + slack))));
  for (const double factor : {1.0, 2.0, 2.5, 5.0, 10.0})
    if (factor * decade > step * (1.0 + slack)) return factor * decade;
  return 20.0 * decade;
}

double median_spacing(std::span<const double> targets) {
  std::vector<double> spacings;
  for (std::size_t i = 1; i < targets.size(); ++i) spacings.push_back(targets[i] - targets[i - 1]);
  return numeric::median(spacings);
}

bool is_even(std::span<const double> targets) {
  const double step = (targets.back() - targets.front()) / static_cast<double>(targets.size() - 1);
  for (std::size_t i = 0; i < targets.size(); ++i)
    if (std::abs(targets[i] - targets.front() - step * static_cast<double>(i)) > slack) return false;
  return true;
}

std::vector<double> steps_from(double start, double step, std::size_t count) {
  std::vector<double> positions;
  for (std::size_t k = 0; k < count; ++k) {
    const double position = start + step * static_cast<double>(k);
    positions.push_back(std::round(position * 1e9) / 1e9);
  }
  return positions;
}

/// How many steps lead from start to end; nothing where no whole number does.
std::optional<std::size_t> steps_between(double start, double end, double step) {
  const double steps = (end - start) / step;
  if (std::abs(steps - std::round(steps)) > slack * std::max(1.0, steps)) return std::nullopt;
  return static_cast<std::size_t>(std::llround(steps));
}

Result<std::vector<double>> of_step(double start, double end, double step, const GridLimits& limits) {
  const double steps = (end - start) / step;
  const std::size_t most = limits.points > 0 ? limits.points : AxisCorrection::nodes_max;
  if (steps + 1.0 > static_cast<double>(most) + slack)
    return fail(fmt::format("found {:.0f} positions, expected at most {}", steps + 1.0, most));
  const auto count = steps_between(start, end, step);
  if (!count)
    return fail(fmt::format("found steps of {} that do not lead from {} to {}, expected a whole number of them",
                            format_rounded(step), format_rounded(start), format_rounded(end)));
  return steps_from(start, step, *count + 1);
}

/// What lies on the lattice of this step within the targets.
std::pair<double, double> lattice_ends(double first, double last, double step, double anchor) {
  return {anchor + step * std::ceil((first - anchor) / step - slack),
          anchor + step * std::floor((last - anchor) / step + slack)};
}

/// The largest round step, at most the median spacing, whose positions leave no more of the targets' range beyond their
/// ends than a tenth of that spacing; where none of so many positions does, the one that leaves least.
template <typename EndsOf>
double chosen_step(std::span<const double> targets, std::size_t most, const EndsOf& ends_of) {
  const double spacing = median_spacing(targets), allowed = 0.1 * spacing;
  double step = round_step_at_most(spacing), best = step, least = std::numeric_limits<double>::infinity();
  for (int tries = 0; tries < 40; ++tries) {
    const auto [start, end] = ends_of(step);
    const double count = (end - start) / step + 1.0;
    const bool is_whole = end > start && steps_between(start, end, step).has_value();
    const bool fits = count <= static_cast<double>(most) + slack;
    if (is_whole && fits) {
      const double left = std::max({0.0, start - targets.front(), targets.back() - end});
      if (left < least) least = left, best = step;
      if (left <= allowed) break;
    }
    if (end > start && !fits) {  // too many already: only wider ones are left
      if (least < std::numeric_limits<double>::infinity()) break;
      step = round_step_above(step);
      continue;
    }
    step = round_step_below(step);
  }
  return best;
}

}  // namespace

Result<std::vector<double>> grid_of(std::span<const double> targets, const GridRequest& request,
                                    const GridLimits& limits) {
  if (targets.size() < 2)
    return fail(fmt::format("found {}, expected at least two", counted(targets.size(), "target")));
  const std::size_t most = limits.points > 0 ? limits.points : AxisCorrection::nodes_max;
  const bool is_wished = request.start || request.end || request.step || request.points;
  const bool fits_fixed_step = !(limits.step > 0.0) && !limits.anchor;
  if (!is_wished && fits_fixed_step && targets.size() <= most && (!limits.equidistant || is_even(targets)))
    return std::vector<double>(targets.begin(), targets.end());
  if (request.step && !(*request.step > 0.0))
    return fail(fmt::format("found a step of {}, expected one above 0", format_rounded(*request.step)));
  if (request.points && *request.points < 2)
    return fail(fmt::format("found {}, expected at least two", counted(*request.points, "point")));

  if (request.start && request.end && !(*request.end > *request.start))
    return fail(fmt::format("found an end at {}, expected one above the start at {}", format_rounded(*request.end),
                            format_rounded(*request.start)));
  if (request.points) {
    const double start = request.start.value_or(targets.front());
    const double end = request.end    ? *request.end
                       : request.step ? start + *request.step * static_cast<double>(*request.points - 1)
                                      : targets.back();
    if (!(end > start))
      return fail(fmt::format("found an end at {}, expected one above the start at {}", format_rounded(end),
                              format_rounded(start)));
    const double step = (end - start) / static_cast<double>(*request.points - 1);
    if (request.step && std::abs(step - *request.step) > slack)
      return fail(fmt::format("found a step of {} and {} points from {} to {}, which would be steps of {}",
                              format_rounded(*request.step), *request.points, format_rounded(start),
                              format_rounded(end), format_rounded(step)));
    return of_step(start, end, step, limits);
  }

  const double anchor = limits.anchor.value_or(request.start.value_or(0.0));
  const auto ends_of = [&](double step) {
    const auto [first, last] = lattice_ends(targets.front(), targets.back(), step, anchor);
    return std::pair(request.start.value_or(first), request.end.value_or(last));
  };
  double step = 0.0;
  if (request.step)
    step = *request.step;
  else if (limits.step > 0.0)
    step = limits.step;
  else
    step = chosen_step(targets, most, ends_of);
  const auto [start, end] = ends_of(step);
  if (!(end > start))
    return fail(fmt::format("found no two positions at steps of {} between the targets at {} and {}",
                            format_rounded(step), format_rounded(targets.front()), format_rounded(targets.back())));
  return of_step(start, end, step, limits);
}

}  // namespace axiometry::compensation
