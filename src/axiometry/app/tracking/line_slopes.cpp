// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/tracking/line_slopes.h"

#include <fmt/format.h>

#include "axiometry/base/text/text.h"
#include "axiometry/model/aligned.h"

namespace axiometry::app {

Result<std::vector<double>> slopes_um_per_m(const TrackingPlan& plan, std::span<const LengthReading> readings) {
  std::vector<double> slopes;
  for (const TrackingLine& line : plan.lines) {
    std::vector<double> distances, deviations;
    const auto way = spatial_line(line.plan.axis);
    for (const LengthReading& r : readings) {
      if (r.line != line.id || !way) continue;
      const Vector3 reflector = way->at(line.plan.targets[r.approach.target]) + plan.setup.tool_offset_mm;
      distances.push_back(distance(reflector, setup_along(plan.setup, line).station.position_mm));
      deviations.push_back(r.length_difference_mm - distances.back());
    }
    double mean_d = 0.0, mean_x = 0.0, covariance = 0.0, variance = 0.0;
    const auto n = static_cast<double>(distances.size());
    for (std::size_t k = 0; k < distances.size(); ++k) mean_d += distances[k] / n, mean_x += deviations[k] / n;
    for (std::size_t k = 0; k < distances.size(); ++k) {
      covariance += (distances[k] - mean_d) * (deviations[k] - mean_x);
      variance += (distances[k] - mean_d) * (distances[k] - mean_d);
    }
    if (!(variance > 0.0))
      return fail(fmt::format("found fewer than two distances on the line {}, expected more", text::quoted(line.id)));
    slopes.push_back(covariance / variance * 1e6);
  }
  return slopes;
}

}  // namespace axiometry::app
