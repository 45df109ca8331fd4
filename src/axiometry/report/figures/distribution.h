// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "axiometry/report/drawing/figure.h"
#include "axiometry/report/report.h"

namespace axiometry::report {

/// A histogram for every parameter from the Monte Carlo method, side by side: the symmetric coverage interval filled,
/// the mean and the measured value as lines, the limit where one was judged, and above it value ± U after Annex A
/// and the GUM where they were run. Every histogram has its own scale and the same height. Nothing without that
/// method. A parameter that does not vary is a single upright stroke.
std::optional<Figure> distribution_figure(const Subject& subject, const Options& options);

}  // namespace axiometry::report
