// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/named_finding.h"
#include "axiometry/model/tracking.h"

/// Station location: where the tracking interferometer stands, from six or more points and the changes of length on the
/// way between them (Lee et al., Sensors 16 (2016) 482, 3.3, eqs 11 to 15). Derivation: docs/theory/station.md.
///
/// Two estimators, always both, because under errors of the machine they can be millimetres apart:
/// - **linear**, eq. 14: with ψ = |s|² − L0² (13) as a fifth unknown the squares of the lengths are linear in s, L0, ψ.
///   Points and lengths are centred and divided by the rms radius r of the points before, which changes nothing but
///   the condition of the matrix with rows [2p, 2ΔL, −1]. It minimises errors of squared lengths, and needs points off
///   every surface of `CriticalSurface`.
/// - **refined**: the s and L0 that minimise Σ ((|p_i − s| − L0 − ΔL_i)/σ_i)² (Levenberg–Marquardt from many starts),
///   rows [−uᵢ, −1], uᵢ the unit vector from the station to the point.
namespace axiometry::tracking {

/// Where a·p + bΔL + c = 0 for all points, so that eq. 14 has no unique solution. The refined problem is regular on all
/// of them but the line and the cone; points on a plane or a hyperboloid leave it a second station.
enum class CriticalSurface {
  none,
  plane,        ///< all points on one plane: the station or its mirror image
  sphere,       ///< a sphere about the station: all lengths are alike
  ellipsoid,    ///< an ellipsoid of revolution, a focus at the station
  paraboloid,   ///< a paraboloid of revolution, its focus at the station
  hyperboloid,  ///< likewise; the other focus may be the station as well
  cone,         ///< a cone about an axis through it: all beams at one angle to it. No estimator can tell the station
  repeated,     ///< fewer than five different points
  line,         ///< all points on one line: the station anywhere on a circle about it. No estimator can tell it
};
std::string_view critical_surface_name(CriticalSurface surface);

struct LinearFit {
  Vector3 station_mm;  ///< 0 where rank < 5, like all that follows from it
  double L0_mm = 0.0;
  double psi_mm2 = 0.0;
  std::size_t rank = 0;            ///< rank of the 5 columns after scaling: singular values above possible noise
  std::size_t numerical_rank = 0;  ///< singular values above n ε of the largest: what rounding leaves
  double rank_tolerance = 0.0;     ///< bound of the smallest singular value, see docs/theory/station.md
  double condition = 0.0;          ///< largest over smallest singular value of the scaled matrix, at most 1/ε = 4.5e15
  std::vector<double> singular_values;
  std::vector<double> residuals_mm;            ///< |p_i − s| − L0 − ΔL_i with this solution
  std::vector<double> equation_residuals_mm2;  ///< residuals of eq. 14 itself; of six points one is redundant
  double redundant_residual_mm2 = 0.0;         ///< root of the sum of their squares
  double misclosure_mm2 = 0.0;    ///< ψ − (|s|² − L0²), 0 for exact data; does not depend on the origin
  double misclosure_u_mm2 = 0.0;  ///< its standard uncertainty, from the σ stated
  Matrix3 covariance_mm2{};       ///< covariance of this s, from the σ stated
};

struct RefinedFit {
  Vector3 station_mm;
  double L0_mm = 0.0;
  Matrix3 covariance_mm2{};         ///< covariance of s: the one that follows, times the inflation
  Matrix3 covariance_stated_mm2{};  ///< (JᵀWJ)⁻¹, from the σ stated alone
  double inflation = 1.0;           ///< χ²/ν where that is above 1 and ν > 0, else 1
  double L0_variance_mm2 = 0.0;     ///< inflated likewise
  std::vector<double> residuals_mm;
  std::vector<double> sigma_mm;  ///< σ_i: of the instrument, and of the machine where given, combined
  double chi_squared = 0.0;
  std::size_t degrees_of_freedom = 0;  ///< ν = n − 4
  /// Probability of a χ² as large as this or larger, with the σ stated; 1 without degrees of freedom.
  double chance = 1.0;
  double condition = 0.0;  ///< condition of the rows [−uᵢ, −1], at most 1/ε
  std::vector<double> singular_values;
  std::size_t iterations = 0;
  bool converged = false;
  std::optional<Vector3> mirror_mm{};  ///< another station that the lengths do not rule out
};

/// Serious: the station should not be used as it is. Ids begin with what was found out: "station-", "lines-", "polar-",
/// "multilateration-"; "tracking-" where several share it. All stand in docs/findings.md.
using Finding = NamedFinding;

struct StationOptions {
  RangingUncertainty ranging = {};
  double machine_sigma_mm = 0.0;     ///< standard uncertainty of the points' positions, per axis
  std::optional<Vector3> near_mm{};  ///< rough place of the station, which chooses between mirror images
};

struct StationLocation {
  std::optional<LinearFit> linear;  ///< absent with fewer than 5 points, all else is in its rank
  RefinedFit refined;
  Vector3 difference_mm;    ///< refined − linear station; 0 where eq. 14 has no unique solution
  Vector3 difference_u_mm;  ///< its standard uncertainty by components, from the σ stated
  CriticalSurface surface = CriticalSurface::none;
  std::optional<double> eccentricity{};  ///< eccentricity of ellipsoid, paraboloid, hyperboloid
  std::vector<Finding> findings;         ///< serious ones first

  bool has_linear() const { return linear && linear->rank == 5; }
  bool is_serious() const;

  /// As the rest of a test takes it.
  Station station() const { return {refined.station_mm, refined.covariance_mm2}; }
};

/// Fails, with the numbers, on fewer than 4 different points (6 are asked for, fewer are a finding), coordinates or
/// lengths that are not finite or beyond 1e9 mm, an uncertainty of 0 or less, two lengths that differ by far more than
/// the distance of their points allows, lengths that fit only in another unit or with the other sign, and a solution
/// more than 100 m away (mixed-up units). A cone, which no estimator can solve, is a serious finding.
Result<StationLocation> locate_station(std::span<const LocationPoint> points, const StationOptions& options);

}  // namespace axiometry::tracking
