// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "axiometry/report/drawing/figure.h"
#include "axiometry/report/report.h"

namespace axiometry::report {

/// A curve of very many points over time, place or frequency.
struct RecordedCurve {
  std::string title, description;
  std::string x_title, x_unit;  ///< "Time", "s"
  std::string y_title, y_unit;
  /// x does not fall; one for each line. All finite.
  std::vector<std::vector<Point>> lines;
  std::vector<std::string> names = {};            ///< of the lines, for a legend; empty: none
  std::vector<std::pair<double, double>> shaded;  ///< parts of the axis of x that are marked
  bool from_zero = false;                         ///< the axis of y begins there
};

/// Thinned to what a page can show: extremes stay.
Figure recorded_figure(const RecordedCurve& curve, const Options& options);

}  // namespace axiometry::report
