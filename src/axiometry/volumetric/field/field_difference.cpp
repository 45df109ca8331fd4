// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/field/field_difference.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "axiometry/base/contract.h"
#include "axiometry/volumetric/field/field_rows.h"

namespace axiometry::volumetric {
namespace {

std::vector<Vector3> grid_places(const TravelBox& box, std::size_t nodes) {
  const auto share = [&](std::size_t k) { return static_cast<double>(k) / static_cast<double>(nodes - 1); };
  std::vector<Vector3> places;
  places.reserve(nodes * nodes * nodes);
  for (std::size_t k = 0; k < nodes * nodes * nodes; ++k)
    places.push_back(place_in(box, {share(k % nodes), share(k / nodes % nodes), share(k / nodes / nodes)}));
  return places;
}

/// u of δ along a direction at a place.
double u_along(const ErrorModel& model, Vector3 at, Vector3 tool, Vector3 direction) {
  DenseRow row;
  add_field(row, model, at, tool, direction);
  return estimate_of(model, row).u;
}

}  // namespace

std::vector<std::optional<Vector3>> grid_errors(const ErrorModel& model, Vector3 tool_mm, std::size_t nodes) {
  AXIOMETRY_CONTRACT(nodes >= 2);
  const bool is_whole = model.parts().unseen.empty();
  std::vector<std::optional<Vector3>> errors;
  for (const Vector3& q : grid_places(model.observed(), nodes)) {
    if (is_whole) {
      errors.emplace_back(field_um(model, model.parts().values, q, tool_mm));
      continue;
    }
    const ToolPointError value = model.at(q, tool_mm);
    errors.push_back(value.is_whole() ? std::optional<Vector3>(value.error()) : std::nullopt);
  }
  return errors;
}

std::optional<TravelBox> common_travel(const ErrorModel& a, const ErrorModel& b) {
  TravelBox box;
  for (std::size_t k = 0; k < axis_count; ++k) {
    box.lowest_mm[k] = std::max(a.observed().lowest_mm[k], b.observed().lowest_mm[k]);
    box.highest_mm[k] = std::min(a.observed().highest_mm[k], b.observed().highest_mm[k]);
    if (!(box.lowest_mm[k] < box.highest_mm[k])) return std::nullopt;
  }
  return box;
}

ErrorModel seen_over(const ErrorModel& model, TravelBox box) {
  for (std::size_t k = 0; k < axis_count; ++k)
    AXIOMETRY_CONTRACT(box.lowest_mm[k] >= model.observed().lowest_mm[k] &&
                       box.highest_mm[k] <= model.observed().highest_mm[k]);
  ErrorModel::Parts parts = model.parts();
  parts.observed = box;
  return ErrorModel(std::move(parts));
}

FieldDifference field_difference(const ErrorModel& before, const ErrorModel& after, Vector3 tool_mm,
                                 std::size_t nodes) {
  AXIOMETRY_CONTRACT(nodes >= 2 && nodes <= 101);
  FieldDifference difference;
  const ToldField told_before = told_field(before, tool_mm, nodes), told_after = told_field(after, tool_mm, nodes);
  const auto before_um = [&](Vector3 q) { return field_um(before, before.parts().values, q, tool_mm); };
  RemainingSizes sizes = sizes_without(after, tool_mm, {.nodes = nodes}, before_um);
  if (told_before.without_rigid_motion && told_after.without_rigid_motion)
    difference.without_rigid_motion = sizes.without_rigid_motion;
  if (!told_before.as_found || !told_after.as_found) return difference;
  const Vector3 at = sizes.as_found.largest_at_mm;
  const Vector3 largest = field_um(after, after.parts().values, at, tool_mm) - before_um(at);
  const Vector3 along = norm(largest) > 0.0 ? unit(largest) : Vector3{1.0, 0.0, 0.0};
  sizes.as_found.largest.u = std::hypot(u_along(before, at, tool_mm, along), u_along(after, at, tool_mm, along));
  difference.as_found = sizes.as_found;
  return difference;
}

}  // namespace axiometry::volumetric
