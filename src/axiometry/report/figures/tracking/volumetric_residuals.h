// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/report/drawing/figure.h"
#include "axiometry/report/report.h"
#include "axiometry/volumetric/identify/identification.h"

namespace axiometry::report {

/// Residuals of a volumetric calibration, µm: in the order of measurement, over the positions of X, Y and Z, and of
/// each station with each tool (from the least to the largest, and their root mean square). Readings that were set
/// aside lie at the edge where they are beyond it. Of many readings a diagram shows stretch by stretch where
/// the central 95 % of them lie, their median and the farthest.
Figure volumetric_residual_figure(const volumetric::VolumetricLengths& lengths, const volumetric::Identification& found,
                                  const Options& options);

}  // namespace axiometry::report
