// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/base/json.h"
#include "axiometry/base/result.h"
#include "axiometry/volumetric/identify/identification.h"

/// What is asked of an identification, as a request says it.
namespace axiometry::app {

/// {"curves": "b-spline", "legendre" or "nodes", "spans": 8 or [8, 6, 4], "reversal": "none", "constant" or "curves",
/// "drift": "auto", "none" or "linear", "find_breaks", "find_outliers"}; all may be left out. Fails, with line and
/// column, on members that are unknown or of another kind, and on spans that are no whole numbers from 1 to 100.
Result<volumetric::IdentifyOptions> identify_options_from(const json::Value& value);

}  // namespace axiometry::app
