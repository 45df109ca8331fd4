// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "axiometry/tracking/station/station_fit.h"

/// Which surface makes eq. 14 critical, and what that means for the user.
namespace axiometry::tracking {

/// Sets surface and eccentricity. Needs the rank judged, and the refined solution.
///
/// - line: the points' second extent is below the tolerance of the rank;
/// - cone: the rows [−uᵢ, −1] are dependent up to what an uncertainty σ hides: along the axis of a cone it takes
///   T = √(2Lσ) to change a length by σ, which turns a beam by T/L; smaller than 2T/L their smallest singular value
///   over √n cannot be told from 0;
/// - plane: the points' smallest extent is below the tolerance of the rank; sphere: the extent of the lengths is;
/// - otherwise with (a, b, c) of the last direction L = k/b − (a/b)·(p − s): a quadric of revolution with the focus s
///   and the eccentricity |a|/|b|.
void name_surface(const LinearEstimate& linear, const RefinedSolution& refined, const MatrixNoise& noise,
                  std::span<const LocationPoint> points, StationLocation& location);

/// Whether any estimator can tell the station from points on such a surface.
bool can_be_told(CriticalSurface surface);

/// Findings about the surface, the mirror image, and the condition of both estimators.
void add_surface_findings(const LinearEstimate& linear, const RefinedSolution& refined,
                          std::span<const LocationPoint> points, const StationOptions& options,
                          StationLocation& location);

}  // namespace axiometry::tracking
