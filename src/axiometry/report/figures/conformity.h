// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "axiometry/report/drawing/figure.h"
#include "axiometry/report/report.h"

namespace axiometry::report {

/// Every judged parameter on a scale of its own tolerance, which therefore stands at 100 % for all: the value with its
/// interval ±U (k = 2) over the zones in which the rule accepts, leaves undecided and rejects. What lies beyond the
/// scale is an arrow at its end, a double one when the value itself does. Nothing when there is no judged parameter.
/// 500 points wide, as the other figures.
std::optional<Figure> conformity_figure(const Subject& subject, const Options& options);

}  // namespace axiometry::report
