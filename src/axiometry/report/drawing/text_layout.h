// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "axiometry/report/drawing/figure.h"

namespace axiometry::report {

/// Where a run of a label stands: relative to the start of the label's base line, before its rotation.
struct PlacedRun {
  const TextRun* run = nullptr;
  double x = 0.0;      ///< left end, points
  double rise = 0.0;   ///< height above the base line, points
  double size = 0.0;   ///< font size, points
  double width = 0.0;  ///< points
};

/// A bar over a letter.
struct PlacedBar {
  double x = 0.0;
  double width = 0.0;
  double rise = 0.0;
  double thickness = 0.0;
};

struct TextLayout {
  std::vector<PlacedRun> runs;
  std::vector<PlacedBar> bars;
  double width = 0.0;
};

/// The one layout that all painters follow. The runs point into `text`.
TextLayout lay_out(const Text& text);

/// Shift of the start of the base line that the anchor asks for: 0, −width/2 or −width.
double anchor_shift(Anchor anchor, double width);

/// Smallest upright rectangle around a label, with ascenders and descenders.
struct Box {
  double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;
};
Box text_box(const Text& text);

/// Whether two boxes share more than an edge.
bool overlap(const Box& a, const Box& b);

}  // namespace axiometry::report
