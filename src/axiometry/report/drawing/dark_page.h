// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/report/drawing/figure.h"

namespace axiometry::report {

/// The background that figures for dark pages are made for.
inline constexpr Colour dark_page{0.102, 0.114, 0.129};  // --surface of web/src/styles/tokens.css

/// The same drawing for a dark page: white becomes dark_page, black nearly white, and every colour in between keeps its
/// hue at the lightness that stands out from the dark page as much as it did from white (L of OKLab, turned over).
Figure for_dark_page(Figure figure);

}  // namespace axiometry::report
