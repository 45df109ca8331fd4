// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include "axiometry/model/test.h"
#include "axiometry/report/drawing/figure.h"
#include "axiometry/report/figures/parts/extents.h"
#include "axiometry/report/figures/parts/symbols.h"
#include "axiometry/report/report.h"

namespace axiometry::report::plot {

/// A dimension line beside one target, such as R_i; its label stands above the plot.
struct TargetDimension {
  Extent extent;  ///< extent at one target: low_at == high_at
  Runs label;
  enum class Side { left, right } side = Side::right;  ///< side of the target

  std::size_t target() const { return extent.high_at; }
};

/// A dimension line at the right margin, such as A; its label is written along it.
struct MarginDimension {
  Extent extent;
  Runs label;
};

/// What one figure shows.
struct Plate {
  const Test& test;
  const iso230_2::Evaluation& evaluation;
  const Options& options;
  std::string_view label;                   ///< Assessment::label: stands wherever results do
  std::vector<Direction> directions;        ///< directions whose means, bands and readings are drawn
  bool bidirectional_mean = false;          ///< whether x̄_i is drawn too
  std::vector<TargetDimension> at_targets;  ///< dimensions, at most 4
  std::vector<MarginDimension> at_margin;   ///< innermost first
};

/// Width and height of every plate, points: the text width of A4.
inline constexpr double plate_width = 500.0;
inline constexpr double plate_height = 300.0;

/// The plate's operations; title and description are left to the caller.
Figure draw(const Plate& plate);

}  // namespace axiometry::report::plot
