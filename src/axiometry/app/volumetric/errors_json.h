// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/base/json/json.h"
#include "axiometry/volumetric/field/error_model.h"

namespace axiometry::app {

/// The 21 errors at the nodes of their curves, of whatever they were found by: docs/results.md, "errors". Of an error
/// that nothing tells there is no node, of squareness no value.
json::Value errors_value(const volumetric::ErrorModel& model);

}  // namespace axiometry::app
