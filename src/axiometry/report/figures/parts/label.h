// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

#include "axiometry/report/figures/parts/ink.h"
#include "axiometry/report/figures/parts/symbols.h"

/// Private to this folder.
namespace axiometry::report::plot {

/// A level line of text.
inline Text label(Runs runs, Point at, double size, Anchor anchor, Colour colour = ink::black) {
  return {.runs = std::move(runs), .at = at, .size = size, .colour = colour, .anchor = anchor, .degrees = 0.0};
}

}  // namespace axiometry::report::plot
