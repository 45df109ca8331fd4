// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "axiometry/report/figures/layout/projection.h"
#include "axiometry/report/figures/parts/label_places.h"
#include "axiometry/report/tracking.h"

/// The set-up of a tracking interferometer as it is drawn in one projection.
namespace axiometry::report::plot {

/// What of a layout can be drawn: without anything that is not finite.
Layout drawable(const Layout& layout);

/// The smallest window that holds everything of a layout. Without anything in it: 1 mm by 1 mm about 0.
Window window_of(const Layout& layout, const Sight& sight);

/// The sight among a few usual ones in which lines from the station stand apart best.
Sight clearest_sight(const Layout& layout);

struct SceneStyle {
  double ball = 4.0;  ///< radius of the instrument, points
  double pen = 1.3;   ///< width of lines
  double text = 7.5;  ///< size of labels
  bool stands = false;
  double labels_most = 40.0;        ///< how far off a label may stand
  std::string station = "station";  ///< what the only one is called
};

/// Lines, solids, points and their labels. Labels that find no room are left out.
void draw_scene(Operations& operations, LabelPlaces& labels, const Layout& layout, const Projection& view,
                const SceneStyle& style);

/// How a line is drawn: blue for one axis, vermilion for diagonals, dashed grey for what is lost.
Stroke line_stroke(const Layout::Item& line, double width);
bool is_diagonal(const Layout::Item& line);

/// Points beyond this number are not drawn one by one.
inline constexpr std::size_t most_points_drawn = 2000;
inline constexpr std::size_t most_points_numbered = 20;

}  // namespace axiometry::report::plot
