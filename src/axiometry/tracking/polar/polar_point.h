// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/base/vector3.h"

/// A polar measurement: a length and the two angles of the beam, in the frame of the instrument (Lee et al., Sensors 16
/// (2016) 482, eq. 1). Derivation: docs/theory/polar.md.
namespace axiometry::tracking {

/// Where the beam points.
struct PolarDirection {
  double azimuth_rad = 0.0;    ///< α, about z, from x towards y
  double elevation_rad = 0.0;  ///< β, above the plane of x and y, −π/2 to π/2
  /// Standard uncertainties as angles across the beam: of an azimuth with u(α) the first is u(α) √(cos²β + u²(β)),
  /// which near the zenith is what the beam moves by, not what the circle reads.
  double sideways_sigma_rad = 0.0;
  double upwards_sigma_rad = 0.0;
};

/// Of angles with their own standard uncertainties u(α), u(β).
PolarDirection direction_of(double azimuth_rad, double elevation_rad, double azimuth_sigma_rad,
                            double elevation_sigma_rad);

struct PolarPoint {
  Vector3 at_mm;           ///< eq. 1
  Matrix3 covariance_mm2;  ///< covariance by its derivatives, the three being independent
};

/// x = d cos β cos α, y = d cos β sin α, z = d sin β; covariance u²(d) e eᵀ + d² u²(sideways) e₁e₁ᵀ + d² u²(upwards)
/// e₂e₂ᵀ with the unit vectors along the beam, sideways and upwards, which are the columns of the derivatives.
PolarPoint polar_point(double length_mm, double length_sigma_mm, const PolarDirection& direction);

/// Unit vectors of a direction.
struct PolarFrame {
  Vector3 along;
  Vector3 sideways;
  Vector3 upwards;
};
PolarFrame polar_frame(const PolarDirection& direction);

}  // namespace axiometry::tracking
