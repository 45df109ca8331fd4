// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "axiometry/report/figures/parts/ink.h"

/// Pens for several curves in one diagram: colours that every reader tells apart (Okabe and Ito), each with dashes of
/// its own, so that a grey print loses nothing.
namespace axiometry::report::plot {

inline constexpr std::size_t series_pen_count = 7;

/// Pen k modulo their number.
inline Stroke series_pen(std::size_t k, double width = 1.15) {
  static constexpr std::array<Colour, series_pen_count> colours = {{
      ink::blue,
      ink::vermilion,
      {0.0, 0.55, 0.40},
      ink::black,
      {0.72, 0.40, 0.60},
      {0.80, 0.56, 0.0},
      {0.25, 0.62, 0.85},
  }};
  static const std::array<std::vector<double>, series_pen_count> dashes = {
      {{}, {5.0, 2.2}, {1.4, 1.6}, {7.0, 1.8, 1.2, 1.8}, {9.0, 2.5}, {3.0, 1.5}, {6.0, 1.6, 1.2, 1.6, 1.2, 1.6}}};
  return {.colour = colours[k % series_pen_count], .width = width, .dashes = dashes[k % series_pen_count]};
}

}  // namespace axiometry::report::plot
