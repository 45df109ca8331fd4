// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "axiometry/base/counted.h"
#include "axiometry/model/aligned.h"
#include "axiometry/report/tracking.h"

namespace axiometry::report {
namespace {

/// Where a lost line of the seven would lead: from the station into the travels, with every axis of its name towards
/// the farther end, until one of them ends. Nothing for other names, or where there is no such way.
std::optional<Layout::Item> lost_item(const LostLine& lost, const TravelBox& box, Vector3 station) {
  Vector3 direction;
  for (char c : lost.id) {
    if (c < 'x' || c > 'z') return std::nullopt;
    const auto k = static_cast<std::size_t>(c - 'x');
    direction[k] = station[k] * 2.0 <= box.lowest_mm[k] + box.highest_mm[k] ? 1.0 : -1.0;
  }
  if (norm(direction) == 0.0) return std::nullopt;
  double length = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    if (direction[k] == 0.0) continue;
    const double end = direction[k] > 0.0 ? box.highest_mm[k] : box.lowest_mm[k];
    length = std::min(length, (end - station[k]) / direction[k]);
  }
  if (!(length > 0.0)) return std::nullopt;
  return Layout::Item{station, station + length * direction, lost.id, true};
}

void append_way(std::vector<Vector3>& way, const TrackingLine& line, const SpatialLine& place, Vector3 tool) {
  for (Vector3 p : line.plan.way_in_mm) way.push_back(p + tool);
  for (Position end : {line.plan.targets.front(), line.plan.targets.back()}) way.push_back(place.at(end) + tool);
  for (Vector3 p : line.plan.way_out_mm) way.push_back(p + tool);
}

}  // namespace

Layout layout_of(const TrackingPlan& plan, bool with_way) {
  const TrackingSetup& setup = plan.setup;
  const Vector3 tool = setup.tool_offset_mm, station = setup.station.position_mm;
  Layout layout;
  layout.box = TravelBox{setup.travel.lowest_mm + tool, setup.travel.highest_mm + tool};
  const bool aligned = is_aligned(setup);
  if (!aligned) {
    layout.stations_mm = {station};
    layout.safe_radius_mm = setup.limits.safe_radius_mm;
  }
  layout.obstacles = setup.obstacles;
  for (const TrackingLine& line : plan.lines) {
    const auto place = spatial_line(line.plan.axis);
    if (!place || line.plan.targets.empty()) continue;
    Vector3 begin = place->at(line.plan.targets.front()) + tool, end = place->at(line.plan.targets.back()) + tool;
    if (!aligned && distance(begin, station) > distance(end, station)) std::swap(begin, end);
    layout.lines.push_back({begin, end, line.id, false});
    if (with_way) append_way(layout.way_mm, line, *place, tool);
  }
  for (const LostLine& lost : plan.lost)
    if (auto item = aligned ? std::nullopt : lost_item(lost, *layout.box, station))
      layout.lines.push_back(*std::move(item));
  layout.title = "Set-up";
  layout.description =
      fmt::format("{}, {}{}.", aligned ? "The travels of the reflector" : "The station, the travels of the reflector",
                  counted(plan.lines.size(), "planned line"),
                  plan.lost.empty() ? "" : " and " + counted(plan.lost.size(), "lost one"));
  return layout;
}

}  // namespace axiometry::report
