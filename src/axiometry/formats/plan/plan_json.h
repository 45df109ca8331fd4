// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "axiometry/base/json/json.h"
#include "axiometry/base/result.h"
#include "axiometry/model/plan.h"

/// Plans as JSON: what `axiometry plan` writes and `nc`, `capture` and `simulate` read. Members at the top: `targets`
/// (mm or °, in order), `cycle`, `runs`, `overrun`, `feed`, `dwell_s`, …; the schema says all.
namespace axiometry::formats {

/// Value of the member "format"; the number changes when old files no longer read.
inline constexpr std::string_view plan_format_name = "axiometry-plan/1";

/// 2⁵³: every whole number below is a double. A seed beyond would not survive as a JSON number, and stands as a text.
inline constexpr double exact_whole_numbers = 9007199254740992.0;

/// The plan as an object. Needs a sound plan.
json::Value plan_value(const Plan& plan);

/// The same as text. Ends with a line break; read_plan(write_plan(p)) == p.
std::string write_plan(const Plan& plan);

/// Fails, with line and column, on what is no JSON, on members that are unknown, missing or of another kind, and as
/// check_sound() does. Targets may stand in any order, since people edit them; they are sorted. Members of the
/// names "findings", "duration_s" and "request", which write_plan()'s caller may add, are passed over.
Result<Plan> read_plan(std::string_view bytes);

/// The same of a plan that stands inside another file.
Result<Plan> plan_from_value(const json::Value& value);

/// Fails on a day that does not exist. A date is for people: other words that name none are read as they stand.
Result<void> check_plan_date(std::string_view date);
std::string plan_date_refusal(std::string_view date);  ///< what it says

/// JSON Schema of the above.
json::Value plan_schema();

}  // namespace axiometry::formats
