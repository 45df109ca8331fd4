// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "axiometry/report/drawing/figure.h"
#include "axiometry/report/report.h"
#include "axiometry/volumetric/field/line_prediction.h"

namespace axiometry::report {

/// Deviations along a line as predicted, µm over the position, with the band ±U (k = 2), and what was measured as dots.
Figure predicted_line_figure(const volumetric::PredictedLine& predicted,
                             const std::optional<volumetric::LineComparison>& comparison, const Options& options);

}  // namespace axiometry::report
