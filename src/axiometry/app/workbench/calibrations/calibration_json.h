// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/app/files/reader.h"
#include "axiometry/app/workbench/calibrations/calibrations.h"
#include "axiometry/base/json/json.h"
#include "axiometry/store/store.h"

/// Calibrations as the API spells them (apps/server/openapi.json), and its requests as values.
namespace axiometry::app {

json::Value to_json(const store::CalibrationPage& page);
json::Value to_json(const KeptCalibration& kept, const Reader& reader);  ///< Calibration, its result localised
json::Value to_json(const CalibrationComparison& comparison);

/// {"title", "machine", "instrument", "measured_on", "notes"}; all may be left out. Fails, with line and column, on
/// members that are unknown or of another kind, and as given_line(), given_text() and given_number() do; on a date that
/// is none.
Result<NewCalibration> new_calibration_from(const json::Value& value);

/// The same with "base_version", which must be there, "reason" and "options"; null takes machine or instrument away.
Result<CalibrationRevision> calibration_revision_from(const json::Value& value);

}  // namespace axiometry::app
