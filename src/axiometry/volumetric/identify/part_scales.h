// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "axiometry/volumetric/identify/identification.h"
#include "axiometry/volumetric/identify/strain_system.h"

/// Parts of a calibration, a station with a tool each, whose axes or air had a temperature of their own. Internal to
/// identify(); derivation in docs/theory/volumetric.md, "Parts at temperatures of their own".
namespace axiometry::volumetric::detail {

/// How often parts at one temperature are taken for such with their own: rather often, since a scale that is missed
/// makes what is stated of squareness wrong, and one that is none costs little.
inline constexpr double part_scales_level = 0.2;

/// How often it is told where so few parts show it that nothing can hold it.
inline constexpr double untold_scales_level = 0.05;

/// Of more parts they are not looked for: the time grows with the third power of their number.
inline constexpr std::size_t parts_most = 300;

/// Normal scales of the parts; which share of their variance the parts of a station have in common is found too.
struct PartScaleFit {
  PartScales told;                         ///< by F; held where the lengths tell well in four ways that parts differ,
                                           ///< were these all but independent
  std::vector<std::size_t> parts;          ///< virtual stations with readings that count, rising
  double taken = 0.0;                      ///< so many unknowns the lengths tell of them
  Eigen::VectorXd um_per_m;                ///< mean of each part
  Eigen::MatrixXd covariance;              ///< of these
  std::vector<std::vector<double>> steps;  ///< of each part: what 1 µm/m taken out takes from the unknowns
  std::vector<double> in_readings_um;      ///< what they change in each reading
};

/// `degrees_of_freedom`: those of the fit. Absent where no two parts can be told from each other.
std::optional<PartScaleFit> part_scale_fit(const Problem& problem, const Fit& fit, double degrees_of_freedom,
                                           Vector3 middle_mm);

/// The fit with the scales of the parts taken out: state, residuals, χ².
void take_out(const PartScaleFit& scales, const Problem& problem, Fit& fit);

/// C = A V Aᵀ of so many unknowns from a column on, by rows: what the scales leave open of them.
std::vector<double> covariance_by_scales(const PartScaleFit& scales, std::size_t column, std::size_t count);

}  // namespace axiometry::volumetric::detail
