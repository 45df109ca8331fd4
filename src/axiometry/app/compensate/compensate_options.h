// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/app/compensate/compensate.h"
#include "axiometry/base/json/json.h"

/// What a table depends on beside the readings, as JSON: CompensationOptions of apps/server/openapi.json. Members have
/// the names of the verb's flags.
namespace axiometry::app {

/// Fails, with line and column, on an unknown member, a value of another kind and a word that is none; else as
/// check_request().
Result<CompensateRequest> compensate_request_from(const json::Value& value);

/// What compensate_request_from() reads: the members that are not as they are when nobody says anything.
json::Value to_json(const CompensateRequest& request);

/// How a table is read that is only looked at: the members of CompensationOptions that a control's rule needs, and
/// "kind", linear (as when it is not there) or rotary. Where no axis is stated the table may be of any, and where no
/// resolution is, it is read by the one that it says. Fails likewise.
Result<nc::AxisTableOptions> table_reading_from(const json::Value& value);

}  // namespace axiometry::app
