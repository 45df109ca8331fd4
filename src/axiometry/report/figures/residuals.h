// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "axiometry/report/drawing/figure.h"
#include "axiometry/report/report.h"

namespace axiometry::report {

/// A histogram of residuals over their own standard uncertainty, beside the bell curve that they should follow. What
/// lies beyond ±6 stands in the outermost bars. Values of 0 are readings that nothing checks, and left out; nothing
/// with fewer than ten others.
std::optional<Figure> residual_figure(std::span<const double> normalised, const Options& options);

}  // namespace axiometry::report
