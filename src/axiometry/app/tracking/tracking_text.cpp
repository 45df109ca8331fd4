// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/tracking/tracking_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "axiometry/app/files/amount_text.h"
#include "axiometry/app/files/unexpected_text.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/tracking/instruments/tracker_kinds.h"

namespace axiometry::app {
namespace {

/// mm; with another unit where it carries one.
std::optional<double> length_mm(std::string_view text) {
  if (const auto x = parse_number(text::trim(text))) return x;
  const auto length = parse_position(text, AxisKind::linear);
  return length ? std::optional(length->in_native()) : std::nullopt;
}

std::optional<double> angle_deg(std::string_view text) {
  text = text::trim(text);
  for (std::string_view unit : {"deg", "°"})
    if (text.ends_with(unit)) text.remove_suffix(unit.size());
  return parse_number(text::trim(text));
}

/// "X=…": 0; nothing for other beginnings.
std::optional<std::size_t> axis_before_equals(std::string_view text) {
  text = text::trim(text);
  const std::size_t axis = text.empty() ? 6 : std::string_view("XYZxyz").find(text.front());
  if (text.size() < 3 || text[1] != '=' || axis >= 6) return std::nullopt;
  return axis % 3;
}

template <typename Read>
std::optional<LowHigh> low_high(std::string_view text, Read read) {
  const auto parts = text::split(text, ':');
  if (parts.size() != 2) return std::nullopt;
  const auto low = read(parts[0]), high = read(parts[1]);
  return low && high && *low < *high ? std::optional(LowHigh{*low, *high}) : std::nullopt;
}

std::optional<Vector3> place_mm(std::string_view text) {
  const auto parts = text::split(text, ',');
  if (parts.size() != 3) return std::nullopt;
  Vector3 place;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto x = length_mm(parts[k]);
    if (!x) return std::nullopt;
    place[k] = *x;
  }
  return place;
}

std::optional<BoxObstacle> box_of(const std::vector<std::string_view>& parts) {
  if (parts.size() != 3) return std::nullopt;
  const auto a = place_mm(parts[1]), b = place_mm(parts[2]);
  if (!a || !b) return std::nullopt;
  BoxObstacle box;
  for (std::size_t k = 0; k < 3; ++k) {
    std::tie(box.lowest_mm[k], box.highest_mm[k]) = std::minmax((*a)[k], (*b)[k]);
    if (box.lowest_mm[k] == box.highest_mm[k]) return std::nullopt;
  }
  return box;
}

using Shape = decltype(Obstacle::shape);

std::optional<Shape> shape_of(const std::vector<std::string_view>& parts) {
  const auto size = [&](std::size_t k) { return length_mm(parts[k]).value_or(0.0); };
  if (parts[0] == "box") {
    const auto box = box_of(parts);
    return box ? std::optional<Shape>(*box) : std::nullopt;
  }
  const bool sphere = parts[0] == "sphere" && parts.size() == 3;
  const bool cylinder = parts[0] == "cylinder" && parts.size() == 4;
  if (!sphere && !cylinder) return std::nullopt;
  const auto place = place_mm(parts[1]);
  if (!place || !(size(2) > 0.0) || (cylinder && !(size(3) > 0.0))) return std::nullopt;
  if (sphere) return SphereObstacle{*place, size(2)};
  return CylinderObstacle{*place, size(2), size(3)};
}

}  // namespace

Result<TravelBox> parse_travel_box(std::string_view text) {
  constexpr std::string_view expected = "all three travels such as X=0:500,Y=0:400,Z=-300:0, lower ends first";
  TravelBox box;
  std::array<bool, 3> seen = {};
  for (std::string_view part : text::split(text, ',')) {
    const auto axis = axis_before_equals(part);
    const auto travel = axis ? low_high(text::trim(part).substr(2), length_mm) : std::nullopt;
    if (!travel || std::exchange(seen[*axis], true)) return unexpected_text(part, expected);
    box.lowest_mm[*axis] = travel->low;
    box.highest_mm[*axis] = travel->high;
  }
  if (!std::ranges::all_of(seen, std::identity{})) return unexpected_text(text, expected);
  return box;
}

Result<std::array<std::optional<Position>, 3>> parse_periods(std::string_view text) {
  std::array<std::optional<Position>, 3> periods;
  const auto above_zero = [](std::optional<double> x) { return x && *x > 0.0; };
  if (const auto one = length_mm(text); above_zero(one)) {
    periods.fill(Position::native(*one));
    return periods;
  }
  for (std::string_view part : text::split(text, ',')) {
    const auto axis = axis_before_equals(part);
    const auto period = axis ? length_mm(text::trim(part).substr(2)) : std::nullopt;
    if (!above_zero(period) || periods[*axis])
      return unexpected_text(part, "one period for all axes, or each such as X=10,Y=10,Z=5, above 0");
    periods[*axis] = Position::native(*period);
  }
  return periods;
}

Result<LowHigh> parse_range(std::string_view text) {
  const auto range = low_high(text, length_mm);
  if (!range || range->low < 0.0) return unexpected_text(text, "the least and the greatest range such as 0.2m:15m");
  return *range;
}

Result<LowHigh> parse_elevation(std::string_view text) {
  const auto range = low_high(text, angle_deg);
  if (!range || range->low < -90.0 || range->high > 90.0)
    return unexpected_text(text, "the lowest and the highest elevation within -90 and 90 such as -20:80");
  return *range;
}

Result<Obstacle> parse_obstacle(std::string_view text) {
  Obstacle obstacle;
  std::string_view shape = text;
  if (const std::size_t equals = text.find('='); equals != std::string_view::npos) {
    obstacle.name = text::trim(text.substr(0, equals));
    shape = text.substr(equals + 1);
  }
  const auto found = shape_of(text::split(shape, ':'));
  if (!found)
    return unexpected_text(text,
                           "NAME=box:X,Y,Z:X,Y,Z, NAME=sphere:X,Y,Z:RADIUS or NAME=cylinder:X,Y,Z:RADIUS:HEIGHT in mm, "
                           "with extent");
  obstacle.shape = *found;
  return obstacle;
}

Result<RangingUncertainty> parse_ranging(std::string_view text) {
  AXIOMETRY_TRY(const auto kind, tracking::find_tracker(text, tracking::LengthMode::changes));
  if (kind && !kind->length)
    return fail(fmt::format("found {}, of which Table 1 has no accuracy of lengths", text::quoted(text)));
  if (kind) return kind->length->expanded_uncertainty();
  RangingUncertainty ranging;
  const auto parts = text::split(text, '+');
  const auto constant = parse_deviation(parts[0], AxisKind::linear);
  const auto slope = parts.size() == 2 ? parse_slope(parts[1], AxisKind::linear) : RelativeLength{};
  if (parts.size() > 2 || !constant || !slope || constant->in_native() < 0.0 || slope->in_um_per_m() < 0.0)
    return unexpected_text(
        text, "the expanded uncertainty of lengths such as 0.2um+0.3um/m, or an instrument such as leica-at901");
  ranging.constant = Length::um(constant->in_native());
  ranging.per_length = *slope;
  return ranging;
}

Result<Length> parse_length_sigma(std::string_view text) {
  AXIOMETRY_TRY(const Deviation x, parse_deviation(text, AxisKind::linear));
  if (!(x.in_native() >= 0.0)) return fail(fmt::format("found {}, expected 0 or more", text::quoted(text)));
  return Length::um(x.in_native());
}

}  // namespace axiometry::app
