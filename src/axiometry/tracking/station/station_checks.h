// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "axiometry/tracking/station/station_fit.h"

/// What may be wrong with the points of a station location: looked for before it is computed, and after.
namespace axiometry::tracking {

/// No machine tool that shall be tested puts its points worse than this; what is beyond is a misreading.
inline constexpr double absurd_error_mm = 0.05;
/// What machine tools may err by without being called wrong.
inline constexpr double usual_machine_error_mm = 0.02;

/// Standard deviation of the machine's points that would explain the residuals besides the σ stated; 0 where nothing
/// checks them.
double machine_error_mm(const RefinedFit& fit);

/// Of one value or more.
double mean(std::span<const double> values);
double root_mean_square(std::span<const double> values);

std::string shown_chi_squared(double x);  ///< "1.9", "3.55e+06"
std::string shown_mm(double x);           ///< "12.3456 mm", true minus sign
std::string shown_um(double x_mm);        ///< "0.31 µm"
std::string shown_point(Vector3 p);       ///< "(12.346, 0.000, −5.100) mm"

/// Before: counts, finite numbers, uncertainties above 0. Fails as locate_station() does.
Result<void> check_points(std::span<const LocationPoint> points, const StationOptions& options);

/// Points that stand at one place within 0.001 mm count once.
std::size_t different_points(std::span<const LocationPoint> points);

/// Of points that were measured again: whether their lengths agree. Also fewer than six points.
void add_count_findings(std::span<const LocationPoint> points, const StationOptions& options,
                        std::vector<Finding>& findings);

/// |ΔL_i − ΔL_k| ≤ |p_i − p_k|. Fails on a length that is longer by more than 2 % and absurd_error_mm; a smaller excess
/// that the uncertainties do not explain is a finding.
Result<void> check_triangles(std::span<const LocationPoint> points, const StationOptions& options,
                             std::vector<Finding>& findings);

/// "in µm": how the lengths would fit the points, with their unit or sign changed; empty when they do not. `rms_mm` is
/// what they misfit as they are, infinite when they cannot be fitted.
std::string better_reading(std::span<const LocationPoint> points, const StationOptions& options, double rms_mm);

/// One length that is wrong, or all from one on (the beam was broken): what explains a χ² that is too large.
void add_misreading_findings(std::span<const LocationPoint> points, const StationOptions& options,
                             const RefinedSolution& solution, std::vector<Finding>& findings);

/// χ² too large or too small.
void add_scatter_findings(const RefinedSolution& solution, std::vector<Finding>& findings);

}  // namespace axiometry::tracking
