// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "axiometry/report/drawing/figure.h"

namespace axiometry::report {

/// A complete `<svg>` element with real text, title and description, to stand in a page or a file. Its
/// width and height are attributes in points; a style sheet may override them.
std::string to_svg(const Figure& figure);

/// One picture of several figures, one below the other, each with its title as a caption, in a margin.
Figure stacked(std::span<const Figure> figures);

}  // namespace axiometry::report
