// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "axiometry/app/recordings/capture_session.h"
#include "axiometry/base/json/json.h"
#include "axiometry/base/result.h"
#include "axiometry/formats/text/json_members.h"

/// What a continuous recording of lengths does not say itself, as a request says it and the archive keeps it.
namespace axiometry::app {

/// By the names of flags without dashes, as capture_options_from() has them: {"rate", "1000"}.
using RecordingTexts = std::vector<std::pair<std::string, std::string>>;

/// Whether lengths have this option: part, reverse, datum and zero are of positions.
bool is_of_lengths(std::string_view option);

/// "recording": an object of such texts; may be left out. Fails, with line and column, on what is none, and as
/// capture_options_from() does.
Result<void> take_recording(formats::JsonMembers& members, CaptureOptions& options);

/// Of tables of lengths. Fails where an option of continuous recordings was stated, which they have no use for.
Result<void> check_no_recording_stated(const CaptureOptions& options);

json::Value recording_value(const RecordingTexts& texts);

}  // namespace axiometry::app
