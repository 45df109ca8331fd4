// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "axiometry/base/json/json.h"
#include "axiometry/base/result.h"
#include "axiometry/model/tracking.h"

/// Tracking plans as JSON: what `axiometry tracking plan` writes and `nc`, `tracking evaluate` and `tracking simulate`
/// read. Members at the top: `setup` (travel, tool, station, limits, …), `lines` (each an `id` and a `plan` as
/// formats/plan/plan_json.h has it), `lost`; the schema says all.
namespace axiometry::formats {

/// Value of the member "format"; the number changes when old files no longer read.
inline constexpr std::string_view tracking_plan_format_name = "axiometry-tracking-plan/1";

/// The plan as an object. Needs finite numbers and sound plans.
json::Value tracking_plan_value(const TrackingPlan& plan);

/// The same as text. Ends with a line break; read_tracking_plan(write_tracking_plan(p)) == p.
std::string write_tracking_plan(const TrackingPlan& plan);

/// Whether this is JSON with a member "format" of that value.
bool is_tracking_plan(std::string_view bytes);

/// Fails, with line and column, on what is no JSON, on members that are unknown, missing or of another kind, on a
/// travel that is reversed, limits or sizes that are none, a covariance that is not symmetric or has a negative
/// variance, a line given twice or without a line in space, one named as a diagonal with the direction of another, and
/// as read_plan() does.
Result<TrackingPlan> read_tracking_plan(std::string_view bytes);

/// The same of JSON that was parsed.
Result<TrackingPlan> tracking_plan_from(const json::Value& value);

/// The set-up alone, which `tracking plan` takes as a file too.
json::Value tracking_setup_value(const TrackingSetup& setup);
Result<TrackingSetup> tracking_setup_from(const json::Value& value);

/// {"constant_um", "per_length_um_per_m"}: the usual ones where they are left out. Fails on numbers below 0 and on two
/// of 0.
Result<RangingUncertainty> ranging_from(const json::Value& value);

/// JSON Schema of the above.
json::Value tracking_plan_schema();

}  // namespace axiometry::formats
