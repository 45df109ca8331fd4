// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "axiometry/base/text/number_text.h"
#include "axiometry/model/axis.h"
#include "axiometry/report/figures/parts/symbols.h"
#include "axiometry/report/report.h"

namespace axiometry::report::plot {

/// Straight line from values to points on paper.
struct Scale {
  double value_low = 0.0, value_high = 1.0;  ///< value_low < value_high
  double paper_low = 0.0, paper_high = 1.0;  ///< places where they stand, points

  double operator()(double value) const {
    return paper_low + (value - value_low) / (value_high - value_low) * (paper_high - paper_low);
  }
};

/// The unit in which an axis is labelled.
struct AxisUnit {
  double native = 1.0;  ///< size in mm or °, µm or ″
  Runs name;            ///< "µm", or "10⁶ m" when no unit is large enough
};

/// The unit that keeps labels short: the preferred one, but a coarser (finer) one when the numbers are
/// huge (tiny); `largest` is the largest magnitude that is shown, in native units.
AxisUnit deviation_axis_unit(AxisKind kind, DisplayUnit preferred, double largest);
AxisUnit position_axis_unit(AxisKind kind, double largest);

/// Divisions of an axis at round numbers, in the axis' unit.
struct Ticks {
  std::vector<double> major;
  std::vector<double> minor;  ///< ticks without the major ones
  int decimals = 0;           ///< decimals of the labels of the major ones
};

enum class Division {
  decimal,  ///< steps 1, 2, 5 times a power of ten
  angular,  ///< whole degrees: also 15, 30, 45, 90, 180, 360
};

/// At most about `wanted` major ticks within low..high (contract: finite, low < high, wanted ≥ 1).
Ticks divide(double low, double high, double wanted, Division division);

/// "12 500" with thin spaces from five digits on, the decimal mark of the style, a true minus sign.
std::string tick_label(double value, int decimals, NumberStyle style);

/// Width of the widest label of the major ticks in the size of tick labels, points.
double widest_label(const Ticks& ticks, NumberStyle style);

}  // namespace axiometry::report::plot
