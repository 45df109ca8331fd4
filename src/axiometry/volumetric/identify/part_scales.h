// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "axiometry/volumetric/identify/strain_system.h"

/// Parts of a calibration, a station with a tool each, whose axes or air had a temperature of their own. Internal to
/// identify(); derivation in docs/theory/volumetric.md, "Parts at temperatures of their own".
namespace axiometry::volumetric::detail {

/// How often parts at one temperature are taken for such with their own: rather often, since a scale that is missed
/// makes what is stated of squareness wrong, and one that is none costs little.
inline constexpr double part_scales_level = 0.2;

/// How often it is told where so few parts show it that nothing can hold it.
inline constexpr double untold_scales_level = 0.05;

/// Normal scales of the parts, half of their variance common to the parts of a station.
struct PartScaleFit {
  std::vector<std::size_t> parts;  ///< virtual stations with readings that count, rising
  Vector3 about_mm;                ///< where a scale moves nothing: the middle of the places that were read
  double chance = 1.0;             ///< chance that scatter alone lets lengths of the parts differ so in scale, by F
  double directions = 0.0;         ///< in how many ways the lengths tell well that parts differ
  double spread_um_per_m = 0.0;    ///< standard deviation of a part: root of the mean square that it may have
  double taken = 0.0;              ///< so many unknowns the lengths tell of them
  Eigen::VectorXd um_per_m;        ///< likeliest of each part
  Eigen::MatrixXd covariance;      ///< of these
  std::vector<std::vector<double>> steps;  ///< of each part: what 1 µm/m taken out takes from the unknowns
  std::vector<double> in_readings_um;      ///< what they change in each reading

  /// Of fewer the spread has no mean square.
  bool can_be_held() const { return directions >= 4.0; }
};

/// `degrees_of_freedom`: those of the fit. Absent where no two parts can be told from
/// each other.
std::optional<PartScaleFit> part_scale_fit(const Problem& problem, const Fit& fit, double degrees_of_freedom,
                                           Vector3 middle_mm);

/// The fit with the scales of the parts taken out: state, residuals, χ².
void take_out(const PartScaleFit& scales, const Problem& problem, Fit& fit);

/// C = A V Aᵀ of so many unknowns from a column on, by rows: what the scales leave open of them.
std::vector<double> covariance_by_scales(const PartScaleFit& scales, std::size_t column, std::size_t count);

}  // namespace axiometry::volumetric::detail
