// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "axiometry/base/json/json.h"
#include "axiometry/base/result.h"
#include "axiometry/formats/text/json_members.h"
#include "axiometry/volumetric/plan/calibration_plan.h"

/// Plans of a volumetric calibration as JSON: what `axiometry volumetric plan` writes and `nc` and `volumetric
/// simulate` read. Members: `machine` (as machine.json, with its stations), `limits`, `obstacles` (as in a tracking
/// plan), `feed_mm_per_min`, `dwell_s`, `runs` (`station`, `tool`, `stops`); the schema says all.
namespace axiometry::formats {

/// Value of the member "format"; the number changes when old files no longer read.
inline constexpr std::string_view volumetric_plan_format_name = "axiometry-volumetric-plan/1";

/// Ends with a line break; what is written reads back the same.
std::string write_volumetric_plan(const volumetric::CalibrationPlan& plan);

/// Whether this is JSON with a member "format" of that value.
bool is_volumetric_plan(std::string_view bytes);

/// Fails, with line and column, on what is no JSON, on members that are unknown, missing or of another kind, as
/// machine_from() and tracking_setup_from() do, on stations or tools that the machine does not have, a station and tool
/// given twice, stops outside of the travels, no run, and more than 1 000 000 stops.
Result<volumetric::CalibrationPlan> read_volumetric_plan(std::string_view bytes);

Result<volumetric::CalibrationPlan> volumetric_plan_from(const json::Value& value);
json::Value volumetric_plan_value(const volumetric::CalibrationPlan& plan);

/// What a plan says beside its machine and its runs: `date`, `limits`, `obstacles`, `feed_mm_per_min`, `dwell_s`; each
/// may be left out. `plan` has its machine. Fails as the above.
Result<void> take_circumstances(JsonMembers& members, volumetric::CalibrationPlan& plan);

/// JSON Schema of the above.
json::Value volumetric_plan_schema();

}  // namespace axiometry::formats
