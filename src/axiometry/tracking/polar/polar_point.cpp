// SPDX-License-Identifier: Apache-2.0
#include "axiometry/tracking/polar/polar_point.h"

#include <cmath>

namespace axiometry::tracking {

PolarDirection direction_of(double azimuth_rad, double elevation_rad, double azimuth_sigma_rad,
                            double elevation_sigma_rad) {
  return {azimuth_rad, elevation_rad, azimuth_sigma_rad * std::hypot(std::cos(elevation_rad), elevation_sigma_rad),
          elevation_sigma_rad};
}

PolarFrame polar_frame(const PolarDirection& direction) {
  const double ca = std::cos(direction.azimuth_rad), sa = std::sin(direction.azimuth_rad);
  const double cb = std::cos(direction.elevation_rad), sb = std::sin(direction.elevation_rad);
  return {{cb * ca, cb * sa, sb}, {-sa, ca, 0.0}, {-sb * ca, -sb * sa, cb}};
}

PolarPoint polar_point(double length_mm, double length_sigma_mm, const PolarDirection& direction) {
  const PolarFrame frame = polar_frame(direction);
  PolarPoint point{length_mm * frame.along, {}};
  const double sideways = length_mm * direction.sideways_sigma_rad, upwards = length_mm * direction.upwards_sigma_rad;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      point.covariance_mm2[i][k] = length_sigma_mm * length_sigma_mm * frame.along[i] * frame.along[k] +
                                   sideways * sideways * frame.sideways[i] * frame.sideways[k] +
                                   upwards * upwards * frame.upwards[i] * frame.upwards[k];
  return point;
}

}  // namespace axiometry::tracking
