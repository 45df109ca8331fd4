// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/singles/single_places.h"

#include <fmt/format.h>

#include <string_view>

namespace axiometry::volumetric {
namespace {

Result<void> need_place(const SingleErrors& errors, std::size_t axis, std::string_view what) {
  if (errors.places[axis]) return {};
  return fail(
      fmt::format("found {} and not where the other axes stood and which point was measured while {} moved, "
                  "expected that place: rotations act by its lever",
                  what, single_axis_letters[axis]));
}

Result<void> check_within_travel(const TravelBox& travel, const SinglePlace& place, std::size_t moved) {
  for (std::size_t b = 0; b < axis_count; ++b) {
    const double lowest = travel.lowest_mm[b], highest = travel.highest_mm[b], at = place.axes_mm[b];
    if (b == moved || (at >= lowest - single_travel_slack_mm && at <= highest + single_travel_slack_mm)) continue;
    return fail(fmt::format("found {} at {} mm while {} moved, expected it within its travel from {} to {} mm",
                            single_axis_letters[b], at, single_axis_letters[moved], lowest, highest));
  }
  return {};
}

}  // namespace

Result<void> check_single_places(const MachineModel& machine, const SingleErrors& errors) {
  for (std::size_t a = 0; a < axis_count; ++a)
    if (errors.places[a]) AXIOMETRY_TRY_VOID(check_within_travel(machine.travel, *errors.places[a], a));
  for (const SingleMotion& m : errors.motions)
    if (!m.error.is_rotation()) AXIOMETRY_TRY_VOID(need_place(errors, m.error.axis, error_name(m.error)));
  for (const SingleSquareness& s : errors.squareness) {
    const auto k = static_cast<std::size_t>(s.which);
    for (const std::size_t axis : {square_lines[k].first.axis, square_lines[k].second.axis})
      AXIOMETRY_TRY_VOID(need_place(errors, axis, squareness_names[k]));
  }
  return {};
}

}  // namespace axiometry::volumetric
