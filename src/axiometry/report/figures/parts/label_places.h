// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "axiometry/report/drawing/text_layout.h"
#include "axiometry/report/figures/parts/dimension_line.h"
#include "axiometry/report/figures/parts/symbols.h"

namespace axiometry::report::plot {

/// A label that shall stand near a place.
struct LabelWish {
  Runs runs;
  double size = 7.0;
  Colour colour{};
  Point at;            ///< what it names
  Point away;          ///< direction in which it had best stand, of any length; {0, 0}: no preference
  double gap = 3.0;    ///< gap between the place and the label
  double most = 12.0;  ///< how far off it may stand
};

/// Places labels one after the other: within a frame, off each other, and off lines where that is possible. The first
/// ones get the best places, so the important ones come first. A label that finds none is left out.
class LabelPlaces {
 public:
  explicit LabelPlaces(Box frame) : frame_(frame) {}

  /// Nothing shall stand here.
  void block(const Box& box) { blocked_.push_back(box); }
  /// Labels shall rather not cross this line.
  void avoid(Point from, Point to, double cost = 1.0) { lines_.push_back({from, to, cost}); }

  /// Whether a text at this very place is within the frame and touches nothing; then it is taken.
  bool take(Operations& operations, Text text);

  /// The best place, with a leader when it is far away; false when there is none.
  bool place(Operations& operations, const LabelWish& wish);

 private:
  struct Line {
    Point from, to;
    double cost;
  };
  bool is_free(const Box& box) const;
  double cost_of(const Box& box) const;

  Box frame_;
  std::vector<Box> blocked_;
  std::vector<Line> lines_;
};

/// Whether a segment passes through a box.
bool crosses(Point from, Point to, const Box& box);

}  // namespace axiometry::report::plot
