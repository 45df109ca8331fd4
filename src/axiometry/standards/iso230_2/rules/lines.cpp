// SPDX-License-Identifier: Apache-2.0
//
// Lines in space and tracking interferometers: what ISO 230-2 does not speak of.
#include <fmt/format.h>

#include "axiometry/standards/iso230_2/rules/message.h"
#include "axiometry/standards/iso230_2/rules/rules.h"
#include "axiometry/standards/iso230_6.h"
#include "axiometry/standards/readings/station_offset.h"

namespace axiometry::iso230_2::rules {

std::optional<Finding> diagonal_line(const Case& c) {
  const auto line = spatial_line(c.metadata.axis);
  if (!line || !is_diagonal(c.metadata.axis)) return std::nullopt;
  return note("diagonal-line", "230-6",
              fmt::format("found a line along which {} axes move: a diagonal displacement test after {}, evaluated as "
                          "one of a single axis; the text of that standard was not at hand. Errors of the axes may "
                          "cancel along a diagonal, so that a small E proves little alone",
                          moving_axes(*line), iso230_6::edition));
}

std::optional<Finding> line_in_space(const Case& c) {
  const Axis& axis = c.metadata.axis;
  const bool given = !axis.line_origin_mm.empty() || !axis.line_direction.empty();
  if (!given || spatial_line(axis)) return std::nullopt;
  return answered_by(
      {"axis.line_origin_mm", "axis.line_direction"},
      missing("line-in-space", "8.1",
              "found axis.line_origin_mm or axis.line_direction that make no line in space, expected three numbers "
              "each of a linear axis, the direction not zero"));
}

std::optional<Finding> station_stated(const Case& c) {
  const std::string problem = station_offset_problem(c.metadata);
  if (problem.empty()) return std::nullopt;
  return answered_by(
      {"tracking.station_position", "tracking.station_uncertainty_mm"},
      missing("station-stated", "8.2.1",
              fmt::format("the station of the tracking interferometer is left out of the uncertainty: {}", problem)));
}

}  // namespace axiometry::iso230_2::rules
