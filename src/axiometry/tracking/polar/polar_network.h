// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/tracking.h"
#include "axiometry/tracking/polar/polar_point.h"
#include "axiometry/tracking/station/station.h"

/// Points and stations from polar measurements of one or more instruments, joined with lengths of others: a weighted
/// least-squares adjustment in which each reading counts by its own uncertainty. Points are eliminated, so that the
/// work grows with the readings. Derivation: docs/theory/polar.md.
///
/// A station that shows angles shows distances (eq. 1), has a position and an orientation, and finds a point alone; one
/// that shows lengths alone shows changes of length (eq. 2), with an unknown dead path for each segment of its beam.
namespace axiometry::tracking {

struct PolarReading {
  std::size_t point = 0;
  std::size_t station = 0;
  std::size_t segment = 0;  ///< segment of a beam of lengths alone
  double length_mm = 0.0;
  double length_sigma_mm = 0.0;               ///< k = 1, above 0
  std::optional<PolarDirection> direction{};  ///< both uncertainties above 0
};

/// In which coordinates the result is.
enum class PolarDatum {
  station,  ///< those of the first station with angles: its covariance is 0
  nominal,  ///< those of the nominal points, onto which all is moved and turned; covariances under inner constraints
};

struct PolarOptions {
  PolarDatum datum = PolarDatum::station;
  /// Per point; start values, and needed for that datum. May be empty. With the datum of a station they are left out
  /// where no station sees three of them off one line.
  std::span<const Vector3> nominal_mm = {};
  std::size_t iterations_most = 50;
  bool checks = true;         ///< residuals over their own uncertainty, findings
  std::stop_token stop = {};  ///< nobody waits for it any more: fails, as unavailable
  std::span<const std::string> station_names = {};
  std::span<const std::string> point_names = {};
};

struct PolarStation {
  Vector3 position_mm;
  /// By rows: a direction of the station's frame in the coordinates of the result. Unit matrix without angles.
  Matrix3 turn;
  Matrix3 covariance_mm2;  ///< covariance of the position
  bool has_angles = false;
  std::vector<double> dead_paths_mm;  ///< dead path per segment, of lengths alone
};

/// A reading less what the result makes of it: length in mm, and across the beam in mm at the point. Each has a
/// normalised one beside it, over its own standard uncertainty; 0 where nothing checks the reading.
struct PolarResidual {
  double length_mm = 0.0, sideways_mm = 0.0, upwards_mm = 0.0;
  double length_normalised = 0.0, sideways_normalised = 0.0, upwards_normalised = 0.0;
};

struct PolarFit {
  std::vector<Vector3> points_mm;
  std::vector<Matrix3> covariances_mm2;
  std::vector<PolarStation> stations;
  std::vector<PolarResidual> residuals;
  double chi_squared = 0.0;
  std::size_t equations = 0;  ///< an angle counts as one
  std::size_t unknowns = 0;   ///< unknowns without the 6 of position and orientation
  std::size_t iterations = 0;
  /// How many of the unknowns each kind of reading tells: Σ (1 − redundancy number). Together all unknowns.
  double told_by_lengths = 0.0, told_by_angles = 0.0;
  std::vector<Finding> findings;

  std::size_t degrees_of_freedom() const { return equations - unknowns; }
  /// By which the covariances were multiplied: χ²/ν where that is above 1.
  double variance_factor() const {
    const auto nu = static_cast<double>(degrees_of_freedom());
    return nu > 0.0 && chi_squared > nu ? chi_squared / nu : 1.0;
  }
};

inline constexpr std::size_t polar_stations_most = 50;

/// Fails, with the numbers, on more than polar_stations_most stations or 300 unknowns of theirs, a station whose place
/// in the others' coordinates nothing tells (fewer than three common points off one line for angles, too few lengths),
/// a point that neither angles nor nominal places begin, readings that leave a point or a direction undetermined,
/// angles that look away from where their point comes out, and when it does not settle.
Result<PolarFit> adjust_polar(std::size_t points, std::size_t stations, std::span<const PolarReading> readings,
                              const PolarOptions& options);

}  // namespace axiometry::tracking
