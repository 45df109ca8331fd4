// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/app/recordings/motion_listener.h"
#include "axiometry/base/result.h"

/// What a person said at the stops of a recording, beside it: a line "12.5,take" for each, in order of time.
namespace axiometry::app {

std::optional<capture::StopKey> stop_key(std::string_view word);  ///< "take", "skip", "undo"

std::string marks_name(const std::string& raw);
bool has_marks(const std::string& raw);

/// Behind those that are there, in place of a line that was cut off, and on the disk.
Result<void> append_mark(const std::string& raw, const StopMark& mark);

/// Fails, with the line, on what is no mark, and on times that run backwards.
Result<std::vector<StopMark>> read_marks(const std::string& file);

/// Those beside a recording; none where nothing was said. A last line that was cut off, as by a power failure, is none.
/// Fails as read_marks() does.
Result<std::vector<StopMark>> marks_beside(const std::string& raw);

}  // namespace axiometry::app
