// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "axiometry/tracking/station/station.h"

/// What the residuals of an adjustment say about the uncertainty that was stated for its readings.
namespace axiometry::tracking {

/// Outside of the bounds of χ²/ν that hold 99.8 % (Wilson and Hilferty): that the residuals are larger or smaller than
/// stated; serious beyond three times. Nothing within, and nothing for ν = 0.
std::optional<Finding> chi_squared_finding(double chi_squared, std::size_t degrees_of_freedom);

/// Of covariances that were multiplied by χ²/ν: that ν, at most ten, tells this factor badly, and that 95 % needs
/// Student's t. Nothing where the residuals are as stated or smaller, and nothing for ν = 0.
std::optional<Finding> few_residuals_finding(double chi_squared, std::size_t degrees_of_freedom);

/// The distance, root mean square, that may lie between points and their nominal places, spread so far, where these
/// belong together; more is no error of a machine.
inline double nominal_misfit_most_mm(double spread_mm) { return 2.0 + 0.02 * spread_mm; }

/// The |value| that one of n normalised residuals exceeds with 5 %, as seen against the scatter of all of them; values
/// of 0 are those that nothing checks. Infinite with fewer than three.
double outlier_limit(std::span<const double> normalised);

}  // namespace axiometry::tracking
