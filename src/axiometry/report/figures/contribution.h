// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "axiometry/report/drawing/figure.h"
#include "axiometry/report/report.h"

namespace axiometry::report {

/// What each input contributes to A, E, M, R and B (of one direction: A, E and R): a row per input, a bar for its part
/// of the sum of squares, and u beside it. Largest first; at most ten inputs, the others in one last row. Nothing when
/// no method says what contributes.
std::optional<Figure> contribution_figure(const Subject& subject, const Options& options);

}  // namespace axiometry::report
