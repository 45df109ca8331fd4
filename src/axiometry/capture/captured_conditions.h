// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "axiometry/capture/capture_result.h"
#include "axiometry/model/metadata.h"
#include "axiometry/model/plan.h"
#include "axiometry/model/test.h"

/// Under what conditions the readings of a recording were taken: what it shows itself, and the plan only where that
/// agrees or nothing is to be seen.
namespace axiometry::capture {

struct CapturedConditions {
  Metadata metadata;  ///< axis, machine and conditions
  std::vector<SourceRemark> remarks;
};

/// Feed, dwell and warm-up: where the recording departs from the plan by more than it is known to, what was recorded is
/// stated and remarked; a warm-up that was not recorded is left open.
CapturedConditions captured_conditions(const Plan& plan, const CaptureResult& result);

/// What of the scatter of the readings is that of the samples, or of the steps in which they come, where that is half
/// of it or more; and how far the axis overshot its targets.
std::vector<SourceRemark> rest_remarks(const Plan& plan, const CaptureResult& result);

}  // namespace axiometry::capture
