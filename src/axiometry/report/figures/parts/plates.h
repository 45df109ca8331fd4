// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "axiometry/report/figures/parts/plate.h"

/// The plates of clause 8: what each of them shows, not how it is drawn.
namespace axiometry::report::plot {

/// Figure 2: both directions with R_i, B_i, M, E and A.
Plate bidirectional_plate(const Subject& subject, const Options& options);

/// Figure 3, or its mirror for ↓: one direction with R_i↑, 2s_i↑, E↑ and A↑.
Plate unidirectional_plate(const Subject& subject, const Options& options, Direction direction);

/// " = 9.6 µm" as the tables print it; a parameter under 0.1 µm, or shown as 0 there though it is not, is
/// shown as shown_deviation() does.
std::string shown_value(Parameter parameter, const Subject& subject, const Options& options);

/// A deviation in µm or ″ to Options::deviation_decimals; under 0.1 µm, or where that shows 0 though it is not, in nm
/// or ″ to two significant digits.
std::string shown_deviation(double native, AxisKind kind, const Options& options);

/// "axis X" for captions, a long name cut; "the axis" without one.
std::string axis_phrase(const Subject& subject);

/// The row of the vocabulary for a parameter.
const iso230_2::ParameterInfo& info(Parameter parameter);

/// Adds the dimension line at the margin when the parameter exists.
void add_at_margin(Plate& plate, Parameter parameter, const Subject& subject, const Options& options);

}  // namespace axiometry::report::plot
