// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/report/document.h"
#include "axiometry/report/report.h"

namespace axiometry::report {

/// The whole report after clause 8, in the order in which it is read: result, figures, findings,
/// identification of the test, positions, uncertainty, further information, provenance.
Document compose(const Subject& subject, const Options& options);

}  // namespace axiometry::report
