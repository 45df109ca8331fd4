// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/report/drawing/figure.h"

typedef struct _cairo cairo_t;

namespace axiometry::report {

/// Paints at the current origin in points; text by Pango, each run fitted to text_width() so that a
/// machine without the usual face draws the same layout.
void paint(const Figure& figure, cairo_t* cairo);

}  // namespace axiometry::report
