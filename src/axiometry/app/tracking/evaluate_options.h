// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "axiometry/app/files/given_file.h"
#include "axiometry/app/recordings/recording_members.h"
#include "axiometry/app/tracking/tracking_evaluate.h"
#include "axiometry/base/json/json.h"
#include "axiometry/base/result.h"

/// How lengths along lines are evaluated, as a request says it and the archive keeps it.
namespace axiometry::app {

/// {"tolerances": ["A=10um", "xy:E=20um"], "tolerance_table": the name of one in the file of them, "rule", "set":
/// ["machine.name=Mill 5"], "reversed", "find_breaks", "break_threshold_mm", "methods", "trials", "seed", "coverage",
/// "type_a", "recording": {"rate": "1000"}}; all may be left out. Fails, with line and column, on members that are
/// unknown or of another kind, on more than 200 tolerances or items, and as add_tolerance(), parse_rule(),
/// set_field_text(), take_uncertainty() and take_recording() do.
Result<TrackingEvaluateOptions> evaluate_options_from(const json::Value& value);

/// The file of tolerances that the member tolerance_table is about, where one is given. Fails as read_tolerance_table()
/// does, with the file's name, and on a name of a table without a file.
Result<void> take_tolerances(const std::optional<GivenFile>& file, ToleranceOptions& tolerance);

/// The same back, but for what is as usual and for the file of tolerances: evaluate_options_from() of it is `options`.
/// `recording` is what options.recording was made of.
json::Value to_json(const TrackingEvaluateOptions& options, const RecordingTexts& recording);

}  // namespace axiometry::app
