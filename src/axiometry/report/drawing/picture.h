// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/report/document.h"
#include "axiometry/report/drawing/figure.h"
#include "axiometry/report/report.h"

namespace axiometry::report {

/// All figures of a subject as one picture on white, headed by what was tested and whether the result
/// may be called tested after the standard: a picture travels without its report.
Figure picture(const Subject& subject, const Options& options);

/// The figures of a document in the same way.
Figure picture(const Document& document);

}  // namespace axiometry::report
