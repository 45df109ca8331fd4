// SPDX-License-Identifier: Apache-2.0
#include "axiometry/nc/numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axiometry/base/contract.h"
#include "axiometry/base/text/number_text.h"

namespace axiometry::nc {
namespace {

/// A coordinate that was given in decimals is met but for the rounding of doubles: a position below 1e5 has 1.5e-11,
/// and an overrun was added.
constexpr double exact_within = 1e-9;

/// A length given in mm is never exact in inches. Half of the least step of the metric default, 0.1 µm.
constexpr double inch_within_mm = 0.5e-4;

/// Likewise on a slanting line in space, which 4 decimals of a mm always satisfy.
constexpr double line_within_mm = 0.5e-4 + exact_within;

/// Of ways and overruns in space, which keep a safe radius and stay within travels: half of the least step that a
/// control has at the least, 0.001 mm or 0.0001 in.
constexpr double way_within_mm = 0.5e-3 + exact_within;
constexpr double way_within_inch_mm = 0.5e-4 * mm_per_inch + exact_within;

std::string fixed(double x, int decimals) {
  std::string text = fmt::format("{:.{}f}", x, decimals);
  if (text.front() == '-' && text.find_first_of("123456789") == std::string::npos) text.erase(0, 1);
  return text;
}

double read_back(const std::string& text) {
  const auto x = parse_number(text);
  AXIOMETRY_CONTRACT(x.has_value());
  return *x;
}

}  // namespace

bool moves_along(const SpatialLine& line, std::size_t k) {
  SpatialLine of_this{{}, {}};
  of_this.direction[k] = line.direction[k];
  return moving_axes(of_this) == 1;
}

bool Coordinates::targets_right(const Plan& plan, const std::optional<SpatialLine>& line) const {
  const double given_within = in_inch_ ? inch_within_mm : exact_within;
  if (!line) return target_error(plan).in_native() <= given_within;
  const bool alone = moving_axes(*line) == 1;
  for (Position target : plan.targets) {
    const Vector3 at = line->at(target), error = printed(at) - at;
    for (std::size_t k = 0; k < 3; ++k) {
      const bool is_given = alone && moves_along(*line, k);
      if (std::abs(error[k]) > (is_given ? given_within : line_within_mm)) return false;
    }
  }
  return true;
}

bool Coordinates::ways_right(const Plan& plan, const std::optional<SpatialLine>& line) const {
  if (!line) return true;
  const double within = in_inch_ ? way_within_inch_mm : way_within_mm;
  const auto right = [&](Vector3 at) {
    const Vector3 error = printed(at) - at;
    return std::max({std::abs(error.x), std::abs(error.y), std::abs(error.z)}) <= within;
  };
  const Reach ends = reach(plan);
  return std::ranges::all_of(plan.way_in_mm, right) && std::ranges::all_of(plan.way_out_mm, right) &&
         right(line->at(ends.lowest)) && right(line->at(ends.highest));
}

/// Target and overrun may both be rounded by half a unit in each coordinate, together by less than √3 units of their
/// distance, so two units keep the way to a target from vanishing.
bool Coordinates::told_apart(const Plan& plan, const std::optional<SpatialLine>& line) const {
  const double overrun = plan.overrun.in_native() / (in_inch_ ? mm_per_inch : 1.0);
  if (overrun * std::pow(10.0, decimals_) < 2.0 - exact_within) return false;
  const auto way = [&](Position from, Position to) {
    if (line) return dot(printed(line->at(to)) - printed(line->at(from)), line->direction);
    return printed(to.in_native()) - printed(from.in_native());
  };
  for (std::size_t i = 1; i < plan.targets.size(); ++i)
    if (!(way(plan.targets[i - 1], plan.targets[i]) > 0.0)) return false;
  return true;
}

Result<Coordinates> Coordinates::make(const Plan& plan, const ProgramOptions& options) {
  if (options.decimals < 0 || options.decimals > decimals_highest)
    return fail(fmt::format("found {} decimals, expected 0 to {}", options.decimals, decimals_highest));
  const bool in_inch = options.unit == LengthUnit::inch && plan.axis.kind == AxisKind::linear;
  const std::optional<SpatialLine> line = spatial_line(plan.axis);
  Coordinates coordinates(in_inch, options.decimals);
  for (; coordinates.decimals_ < decimals_highest; ++coordinates.decimals_) {
    const bool targets = coordinates.targets_right(plan, line) && coordinates.told_apart(plan, line);
    if (targets && coordinates.ways_right(plan, line)) break;
    if (!targets) coordinates.moved_ = "TARGETS";
  }
  if (!coordinates.told_apart(plan, line))
    return fail(
        fmt::format("found targets, or target and overrun, that are alike with {} decimals, expected positions "
                    "that the program can tell apart",
                    decimals_highest));
  return coordinates;
}

Result<Coordinates> Coordinates::of_points(std::span<const Vector3> points_mm, const ProgramOptions& options) {
  if (options.decimals < 0 || options.decimals > decimals_highest)
    return fail(fmt::format("found {} decimals, expected 0 to {}", options.decimals, decimals_highest));
  Coordinates coordinates(options.unit == LengthUnit::inch, options.decimals);
  const auto right = [&](Vector3 at) {
    const Vector3 error = coordinates.printed(at) - at;
    return std::max({std::abs(error.x), std::abs(error.y), std::abs(error.z)}) <= line_within_mm;
  };
  while (coordinates.decimals_ < decimals_highest && !std::ranges::all_of(points_mm, right)) ++coordinates.decimals_;
  return coordinates;
}

std::string Coordinates::text(double mm_or_deg) const {
  return fixed(mm_or_deg / (in_inch_ ? mm_per_inch : 1.0), decimals_) + (decimals_ == 0 ? "." : "");
}

double Coordinates::printed(double mm_or_deg) const {
  return read_back(text(mm_or_deg)) * (in_inch_ ? mm_per_inch : 1.0);
}

Vector3 Coordinates::printed(Vector3 mm) const { return {printed(mm.x), printed(mm.y), printed(mm.z)}; }

Position Coordinates::target_error(const Plan& plan) const {
  const std::optional<SpatialLine> line = spatial_line(plan.axis);
  double error = 0.0;
  for (Position target : plan.targets) {
    const double x = target.in_native();
    error = std::max(error, line ? distance(printed(line->at(target)), line->at(target)) : std::abs(printed(x) - x));
  }
  return Position::native(error);
}

std::string trimmed_number(double x, int decimals) {
  std::string text = fixed(x, decimals);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text;
}

}  // namespace axiometry::nc
