// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "axiometry/app/files/reader.h"
#include "axiometry/base/json/json.h"

/// The parameters of a result as a page shows them; belongs to workbench_json.h.
namespace axiometry::app {

/// Of an object; nullptr where there is none, or no object.
const json::Value* member_of_object(const json::Value& object, std::string_view name);

/// "not applicable" is no verdict of the API.
json::Value verdict_or_null(const json::Value* verdict);

/// A row for each parameter: value, uncertainty of record, limit with its origin, verdict or why there is none.
json::Value shown_to_json(const json::Value& result, const Reader& reader);

}  // namespace axiometry::app
