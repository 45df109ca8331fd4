// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "axiometry/report/tracking.h"

/// Set-ups to draw.
namespace axiometry::report::testing {

/// From a station near a corner, which all seven lines leave into one octant.
inline Layout seven_lines_layout() {
  Layout layout;
  layout.box = TravelBox{{0, 0, 0}, {1000, 600, 500}};
  const Vector3 station{150, 120, 60};
  layout.stations_mm = {station};
  layout.safe_radius_mm = 120.0;
  constexpr std::string_view ids[] = {"x", "y", "z", "xy", "xz", "yz", "xyz"};
  constexpr double ends[] = {850, 480, 440, 678.8, 622.2, 622.2, 762.1};
  for (std::size_t k = 0; k < 7; ++k) {
    Vector3 direction;
    for (char c : ids[k]) direction[static_cast<std::size_t>(c - 'x')] = 1.0;
    direction = unit(direction);
    layout.lines.push_back({station + 200.0 * direction, station + ends[k] * direction, std::string(ids[k])});
  }
  layout.title = "Set-up";
  layout.description = "The station, the travels and the lines.";
  return layout;
}

/// With lost lines, obstacles and the six points of the station location.
inline Layout crowded_layout() {
  Layout layout = seven_lines_layout();
  layout.lines[1].lost = true;
  layout.lines[5].lost = true;
  layout.obstacles = {{"vice", BoxObstacle{{450, 150, 0}, {650, 300, 120}}},
                      {"probe", SphereObstacle{{900, 500, 80}, 40}},
                      {"rotary table", CylinderObstacle{{780, 200, 0}, 90, 60}}};
  layout.points_mm = {{100, 500, 100}, {900, 100, 450}, {500, 300, 300},
                      {850, 520, 200}, {200, 300, 480}, {520, 330, 310}};
  layout.way_mm = layout.points_mm;
  return layout;
}

}  // namespace axiometry::report::testing
