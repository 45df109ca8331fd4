// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/volumetric/singles/single_errors.h"

/// Squareness out of the two straightness lines by which it was measured.
///
/// The model counts squareness between the best straight lines for its curves, which lead straight from reading to
/// reading, over the range that all errors of an axis have in common. A measurement has its slopes by another sum of
/// the readings (least squares over the positions, or end points) and perhaps over more of the travel. With the
/// readings of the lines the model's slopes are found from them, and nothing is lost by that difference:
///
///     squareness = sign (b_1 + b_2) + what the optical square adds
///
/// with the signs of square_lines (single_places.h), b the slope of each line by curve_slope_weights().
namespace axiometry::volumetric {

/// Mean readings of a straightness in axes of the machine.
struct SquareLine {
  ErrorMotion error;
  std::vector<double> positions_mm;    ///< ascending, two or more
  std::vector<double> values_um;       ///< value at each of them
  std::vector<double> weights_per_mm;  ///< what each counts in the slope of which the uncertainties below tell
  double direction = 0.0;              ///< +1, −1 of one that was read in that direction alone
};

struct SquareMeasurement {
  Squareness which = Squareness::C0Y;
  std::array<SquareLine, 2> lines;  ///< lines in either order
  double square_urad = 0.0;         ///< what the optical square adds to C0Y, B0Z or A0Z
  double u_scatter_urad = 0.0;      ///< standard uncertainties of the squareness by the slopes as measured
  double u_instrument_urad = 0.0;
  double u_square_urad = 0.0;
};

/// By what each value counts in the slope, per mm, of the straight line that is best for the curve through them:
/// 12/L³ ∫ (q − middle) y dq. Contract: two positions or more, ascending.
std::vector<double> curve_slope_weights(const std::vector<double>& at_mm);

/// Over the range that all errors of each axis have in common; over that of its line where no error of the axis is
/// given. Its scatter is that of the slopes as measured times the ratio of the roots of the sums of squared weights
/// (readings that scatter alike), what the instrument adds times the ratio of the sums of their magnitudes, each for
/// the line where it is larger and at least 1. Fails on a line that is not of this squareness, and on one that does not
/// reach over that range.
Result<SingleSquareness> squareness_over_common_range(const SquareMeasurement& measured, const SingleErrors& errors);

}  // namespace axiometry::volumetric
