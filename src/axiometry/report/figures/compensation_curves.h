// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/report/compensation.h"
#include "axiometry/report/drawing/figure.h"

namespace axiometry::report {

/// Mean deviations before and as predicted, and of the re-test as dots, over each other.
Figure before_and_predicted_figure(const CompensationSubject& subject, const Options& options);

/// What the control adds to the commanded position, with its positions, and with a table that was there before.
Figure correction_figure(const CompensationSubject& subject, const Options& options);

}  // namespace axiometry::report
