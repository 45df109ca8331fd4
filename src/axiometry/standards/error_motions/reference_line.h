// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

/// The straight line from which an error motion is counted (ISO 230-1, reference lines of straightness). The text of
/// that standard was not at hand: names and formulas follow a maker's manual whose example comes out to its digits.
///
///     y(x) = a + b x,  least squares: b = Σ (x_i − x̄) y_i / Σ (x_i − x̄)²,  a = ȳ − b x̄
///                      end points:    b = (y_m − y_1) / (x_m − x_1),        a = y_1 − b x_1
///                      none:          b = 0, a = 0: readings as they are, for angles
///
/// x is the position in mm, counted from 0 of the axis, so a is what the line has there even where it was not measured.
namespace axiometry::error_motions {

enum class Reference { least_squares, end_points, none };

std::string_view reference_key(Reference reference);   ///< "least-squares", "end-points", "none"
std::string_view reference_name(Reference reference);  ///< "least squares", "end points", "none"
std::optional<Reference> parse_reference(std::string_view key);

struct ReferenceLine {
  double intercept = 0.0;     ///< a, in the unit of the readings, at position 0
  double slope_per_mm = 0.0;  ///< b
  double at(double position_mm) const { return intercept + slope_per_mm * position_mm; }
};

/// w with b = Σ w_i y_i, in 1/mm: what each reading weighs in the slope. Contract: two different positions, ascending.
std::vector<double> slope_weights(std::span<const double> positions_mm, Reference reference);

/// Contract: as many values as positions, two different positions, ascending. Two passes: for positions up to 1e9 mm
/// and readings up to 1e9 the slope is exact to about 1e-12 of the largest reading over the travel.
ReferenceLine fit_line(std::span<const double> positions_mm, std::span<const double> values, Reference reference);

/// y_i − a − b x_i, evaluated about the middle of the positions so that a far zero costs no digits.
std::vector<double> line_residuals(std::span<const double> positions_mm, std::span<const double> values,
                                   Reference reference);

/// θ = atan b, in ″, of a slope in µm/m.
double slope_arcsec(double slope_um_per_m);

}  // namespace axiometry::error_motions
