// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/model/series.h"
#include "axiometry/report/drawing/figure.h"

/// Colours and pens of the figures. Line style carries the meaning, so that a grey print and a
/// colour-blind reader lose nothing; blue and vermilion are a pair every reader tells apart.
namespace axiometry::report::plot::ink {

inline constexpr Colour blue{0.0, 0.447, 0.698};
inline constexpr Colour vermilion{0.835, 0.369, 0.0};
inline constexpr Colour black{0.1, 0.1, 0.1};
inline constexpr Colour grey{0.45, 0.45, 0.45};
inline constexpr Colour extension_grey{0.6, 0.6, 0.6};
inline constexpr Colour grid_grey{0.86, 0.86, 0.86};
inline constexpr Colour minor_grid_grey{0.935, 0.935, 0.935};
inline constexpr Colour white{1.0, 1.0, 1.0};
inline constexpr Colour none{0.0, 0.0, 0.0, 0.0};

constexpr Colour of(Direction direction) { return direction == Direction::up ? blue : vermilion; }

constexpr Colour faint(Colour colour, double alpha) {
  colour.alpha = alpha;
  return colour;
}

inline Stroke solid(Colour colour, double width) { return {.colour = colour, .width = width, .dashes = {}}; }

inline Stroke mean_line(Direction direction) {
  Stroke stroke = solid(of(direction), 1.15);
  if (direction == Direction::down) stroke.dashes = {5.0, 2.2};
  return stroke;
}

inline Stroke boundary_line(Direction direction) {
  return {.colour = of(direction), .width = 0.55, .dashes = {6.0, 1.8, 1.0, 1.8}};
}

inline Stroke bidirectional_mean_line() { return solid(black, 0.6); }

inline constexpr double band_alpha = 0.09;
inline constexpr double reading_alpha = 0.65;

inline constexpr double text_size = 7.5;
inline constexpr double tick_text_size = 7.0;
inline constexpr double index_text_size = 5.5;

}  // namespace axiometry::report::plot::ink
