// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "axiometry/base/json.h"
#include "axiometry/base/result.h"
#include "axiometry/volumetric/identify/identification.h"

/// What is asked of an identification, as a request says it.
namespace axiometry::app {

/// {"curves": "b-spline", "legendre" or "nodes", "spans": 8 or [8, 6, 4], "reversal": "none", "constant" or "curves",
/// "smoothness": "none", "auto", 5 or [5, 8] (µm, µrad), "drift": "auto", "none" or "linear", "find_breaks",
/// "find_outliers"}; all may be left out. Fails, with line and column, on members that are unknown or of another kind,
/// on spans that are no whole numbers from 1 to 100, and on a smoothness beyond its bounds.
Result<volumetric::IdentifyOptions> identify_options_from(const json::Value& value);

/// "none", "auto", "5" (µm and µrad) or "5,8": what `--smoothness` means.
Result<volumetric::Smoothness> parse_smoothness(std::string_view text);

}  // namespace axiometry::app
