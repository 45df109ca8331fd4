// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/report/drawing/figure.h"
#include "axiometry/report/tracking.h"

namespace axiometry::report {

/// The mean bidirectional deviation x̄_i of every line over its distance from the station in one diagram, as Fig. 6 of
/// Lee et al. shows two of them; of a line that was measured in one direction, the mean of that. The slope of each
/// stands in the legend and as a hairline. 500 points wide.
Figure lines_overview_figure(const LinesSubject& subject, const Options& options);

}  // namespace axiometry::report
