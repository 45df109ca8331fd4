// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "axiometry/report/drawing/figure.h"
#include "axiometry/report/report.h"
#include "axiometry/standards/error_motions/axis_motion.h"

namespace axiometry::report {

/// The means of each direction over the positions, and the reference line of the mean (or of the only direction).
Figure motion_figure(const error_motions::AxisMotion& motion, const std::string& title, const Options& options);

/// The same less that line: what the range is the range of.
Figure motion_residual_figure(const error_motions::AxisMotion& motion, const std::string& title,
                              const Options& options);

}  // namespace axiometry::report
