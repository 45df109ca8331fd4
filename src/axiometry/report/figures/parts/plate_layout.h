// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "axiometry/report/figures/layout/callouts.h"
#include "axiometry/report/figures/parts/dimension_line.h"
#include "axiometry/report/figures/parts/plate.h"
#include "axiometry/report/figures/parts/scale.h"

namespace axiometry::report::plot {

/// Where everything of a plate stands. From top to bottom: what `header_height` takes (label, legend),
/// rows of callouts, numbers of the targets, the plot, tick labels, title of the position axis.
struct PlateLayout {
  double left = 0.0, right = 0.0, top = 0.0, bottom = 0.0;  ///< edges of the plot
  Scale x;                                                  ///< scale of positions in x_unit
  Scale y;                                                  ///< scale of deviations in native units
  AxisUnit x_unit;
  AxisUnit y_unit;
  Ticks x_ticks;                       ///< ticks in x_unit
  Ticks y_ticks;                       ///< ticks in y_unit
  std::vector<double> target_x;        ///< place of each target on paper
  double target_pitch = 0.0;           ///< mean distance of neighbouring targets on paper
  std::vector<CalloutPlace> callouts;  ///< places of plate.at_targets
  std::vector<double> dimension_x;     ///< places of plate.at_targets
  std::vector<double> margin_x;        ///< places of plate.at_margin

  double deviation_y(Deviation deviation) const { return y(deviation.in_native()); }
  double tick_y(double tick) const { return y(tick * y_unit.native); }
  double callout_base_line(int row) const;
};

PlateLayout lay_out(const Plate& plate, double header_height);

}  // namespace axiometry::report::plot
