// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/tracking.h"

/// Station location: where the tracking interferometer stands, from six or more points and the changes of length on the
/// way between them (Lee et al., Sensors 16 (2016) 482, 3.3, eqs 11 to 15). Derivation: docs/theory/station.md.
///
/// Two estimators, always both, because under errors of the machine they can be millimetres apart:
/// - **linear**, eq. 14: with ψ = |s|² − L0² (13) as a fifth unknown the squares of the lengths are linear in s, L0, ψ.
///   Points are centred and scaled before, which changes nothing but the condition of the matrix. It minimises errors
///   of squared lengths, and needs points off every surface of `CriticalSurface`.
/// - **refined**: the s and L0 that minimise Σ ((|p_i − s| − L0 − ΔL_i)/σ_i)² (Gauss–Newton), rows [−uᵢ, −1].
namespace axiometry::tracking {

/// Where a·p + bΔL + c = 0 for all points, so that eq. 14 has no unique solution. The refined problem is regular on all
/// of them but the cone; points on a plane leave it a mirror image of the station.
enum class CriticalSurface {
  none,
  plane,     ///< all points on one plane: the station or its mirror image
  sphere,    ///< about the station: all lengths are alike
  quadric,   ///< of revolution with a focus at the station: ellipsoid, paraboloid, hyperboloid
  cone,      ///< about an axis through the station: all beams at one angle to it. No estimator can tell the station
  repeated,  ///< too few different points
};
std::string_view critical_surface_name(CriticalSurface surface);

struct LinearFit {
  Vector3 station_mm;
  double L0_mm = 0.0;
  double psi_mm2 = 0.0;
  std::size_t rank = 0;  ///< of the 5 columns after scaling; below 5 the smallest solution is given, and counts as none
  double condition = 0.0;  ///< largest over smallest singular value of the scaled matrix; infinite below full rank
  std::vector<double> singular_values;
  std::vector<double> residuals_mm;  ///< |p_i − s| − L0 − ΔL_i with this solution
  double misclosure_mm2 = 0.0;  ///< ψ − (|s|² − L0²), 0 for exact data; relative to the centre of the points
};

struct RefinedFit {
  Vector3 station_mm;
  double L0_mm = 0.0;
  Matrix3 covariance_mm2{};  ///< of s, from the σ stated; times χ²/ν where that is above 1 and ν > 0
  double L0_variance_mm2 = 0.0;
  std::vector<double> residuals_mm;
  std::vector<double> sigma_mm;  ///< σ_i: of the instrument, and of the machine where given, combined
  double chi_squared = 0.0;
  std::size_t degrees_of_freedom = 0;  ///< ν = n − 4
  double condition = 0.0;              ///< of the rows [−uᵢ, −1], columns scaled alike
  std::size_t iterations = 0;
  bool converged = false;
  std::optional<Vector3> mirror_mm{};  ///< the other station that fits as well, when the points lie on a plane
};

/// What the user should know, with the numbers.
struct Finding {
  bool serious = false;  ///< the station should not be used as it is
  std::string message;   ///< a sentence without full stop
};

struct StationOptions {
  RangingUncertainty ranging = {};
  double machine_sigma_mm = 0.0;     ///< standard uncertainty of the points' positions, per axis
  std::optional<Vector3> near_mm{};  ///< about where the station stands: chooses between mirror images
};

struct StationLocation {
  std::optional<LinearFit> linear;  ///< absent with fewer than 5 points, all else is in its rank
  RefinedFit refined;
  Vector3 difference_mm;  ///< refined − linear station; 0 where eq. 14 has no unique solution
  CriticalSurface surface = CriticalSurface::none;
  std::vector<Finding> findings;

  /// As the rest of a test takes it.
  Station station() const { return {refined.station_mm, refined.covariance_mm2}; }
};

/// Fails, with the numbers, on fewer than 4 different points (6 are asked for, fewer are a finding), coordinates or
/// lengths that are not finite, two lengths that differ by more than the distance of their points allows (and what the
/// instrument may err), points on a cone about the station, a solution that lies absurdly far away (mixed-up units),
/// and when no start converges.
Result<StationLocation> locate_station(std::span<const LocationPoint> points, const StationOptions& options);

}  // namespace axiometry::tracking
