// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/app/files/source.h"
#include "axiometry/app/recordings/capture_session.h"

/// The use case "from a finished recording to a test".
namespace axiometry::app {

/// A recording in a file (or "-") as a test, for evaluation.
Result<Test> read_recording(Source& source, const CaptureOptions& options);

}  // namespace axiometry::app
