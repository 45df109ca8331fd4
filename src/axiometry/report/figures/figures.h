// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "axiometry/report/drawing/figure.h"
#include "axiometry/report/report.h"

namespace axiometry::report {

/// The figures of clause 8 that this subject has readings for, in order: Figure 2 (both directions, with
/// the dimension lines R_i, B_i, M, E, A), Figure 3 for the positive approaches and its mirror for the
/// negative ones (2s_i↑, R_i↑, E↑, A↑). R and B stand at the target where they occur. A parameter that
/// does not exist has no dimension line. 500 by 300 points each, the text width of A4; the caption is the
/// figure's title and is not drawn: pages set it in their own type.
std::vector<Figure> figures(const Subject& subject, const Options& options);

}  // namespace axiometry::report
