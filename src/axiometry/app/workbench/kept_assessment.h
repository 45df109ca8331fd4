// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/base/json/json.h"
#include "axiometry/model/axis.h"
#include "axiometry/standards/iso230_2/assessment/assessment.h"

namespace axiometry::app {

/// As much of an assessment as its result (docs/results.md) tells and report::show() needs: the parameters and their
/// uncertainties. So that what was kept is shown by the same rules as what was found a moment ago. What is absent or of
/// another kind in the JSON is absent here.
iso230_2::Assessment assessment_shown_by(const json::Value& result);

/// Of its member "axis".
AxisKind axis_kind_of(const json::Value& result);

}  // namespace axiometry::app
