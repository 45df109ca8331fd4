// SPDX-License-Identifier: Apache-2.0
#include "axiometry/tracking/geometry/line_geometry.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axiometry/base/text/number_text.h"

namespace axiometry::tracking {
namespace {

constexpr double nearest_mm = 1.0;       // within it a direction of the beam has no meaning
constexpr double steepest_cosine = 0.5;  // cosine of 60°

std::unexpected<Error> passes_by(const TrackingLine& line, const LineGeometry& geometry) {
  return fail(
      fmt::format("found line {} running past the station ({} mm beside it, next to it at position {}), expected all "
                  "targets on one "
                  "side of the station",
                  line.id, format_fixed(geometry.miss_mm, 3), format_fixed(geometry.foot.in_native(), 3)));
}

}  // namespace

Result<LineGeometry> line_geometry(const TrackingSetup& setup, const TrackingLine& line) {
  const auto spatial = spatial_line(line.plan.axis);
  if (!spatial)
    return fail(
        fmt::format("found line {} without a line in space, expected origin and direction of a linear axis", line.id));
  LineGeometry geometry;
  geometry.direction = spatial->direction;
  const Vector3 to_station = setup.station.position_mm - setup.tool_offset_mm - spatial->origin_mm;
  const double foot = dot(to_station, spatial->direction);
  geometry.foot = Position::native(foot);
  geometry.miss_mm = norm(to_station - foot * spatial->direction);
  double smallest = 1.0;
  for (const Position& target : line.plan.targets) {
    const Vector3 beam = spatial->at(target) + setup.tool_offset_mm - setup.station.position_mm;
    const double d = norm(beam);
    if (!(d >= nearest_mm))
      return fail(fmt::format("found target {} of line {} {} mm from the station, expected at least {} mm",
                              format_exact(target.in_native()), line.id, format_fixed(d, 4), nearest_mm));
    geometry.distances_mm.push_back(d);
    geometry.cosines.push_back(dot(beam, spatial->direction) / d);
    if (geometry.cosines.back() * geometry.cosines.front() <= 0.0) return passes_by(line, geometry);
    smallest = std::min(smallest, std::abs(geometry.cosines.back()));
  }
  geometry.angle_most_deg = std::acos(std::min(1.0, smallest)) * deg_per_rad;
  if (smallest < steepest_cosine)
    return fail(fmt::format("found the beam at {}° to line {}, expected at most 60°",
                            format_fixed(geometry.angle_most_deg, 1), line.id));
  return geometry;
}

}  // namespace axiometry::tracking
