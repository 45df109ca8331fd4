// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/base/json/json_place.h"
#include "axiometry/model/test.h"

/// What was done to the readings, as machines read it; belongs to result_json.h. docs/results.md describes the keys.
namespace axiometry::app {

/// Adds "corrections" and "readings" (those evaluated, and beside them as they were measured) where the readings were
/// corrected, and "expansion_correction" where for expansion.
void add_corrections(json::Object& object, const Test& test);

/// "drift": per hour or per reading with its standard uncertainty; null where it cannot be estimated.
void put_drift(json::Place place, const Test& test);

}  // namespace axiometry::app
