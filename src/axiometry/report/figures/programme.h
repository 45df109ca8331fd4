// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/model/plan.h"
#include "axiometry/report/drawing/figure.h"
#include "axiometry/report/report.h"

namespace axiometry::report {

/// The way of the axis over the time, as Figure 1 shows the standard test cycle: positions to the right, time
/// downwards; readings as dots after the dwell, ways without a reading in grey, overruns shaded. Needs a sound plan;
/// Further plans have figures of their own.
Figure programme_figure(const Plan& plan, const Options& options);

}  // namespace axiometry::report
