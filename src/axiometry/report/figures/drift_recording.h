// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "axiometry/report/drawing/figure.h"
#include "axiometry/report/report.h"

namespace axiometry::report {

/// The recording at standstill (A.2.5) over time, with the stretch of the test's length in which it ranges most, and
/// what it is made of: amplitude of a sinusoid over its period. Nothing where the test has no usable recording.
std::optional<Figure> drift_recording_figure(const Subject& subject, const Options& options);

}  // namespace axiometry::report
