// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "axiometry/app/live/runs/capture_run.h"
#include "axiometry/base/result.h"

namespace axiometry::app {

/// The test file is written over after every reading: it must take the place of nothing that was read or recorded. A
/// recording grows: it must not be the plan. Fails too where it cannot be written, and on the standard input as both.
Result<void> check_recording_spared(const CaptureRun& run, const std::string& plan);

}  // namespace axiometry::app
