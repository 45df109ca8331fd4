// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/app/files/source.h"
#include "axiometry/app/recordings/capture_session.h"

/// The use case "from a finished recording to a test".
namespace axiometry::app {

/// All of a recording in a file (or "-"), or one that a live capture kept; its SHA-256.
Result<std::string> hear(Source& source, CaptureSession& session);

/// Damaged lines are passed over in what a live capture kept.
CaptureOptions options_of_source(const Source& source, CaptureOptions options);

/// A recording in a file (or "-") as a test, for evaluation.
Result<Test> read_recording(Source& source, const CaptureOptions& options);

}  // namespace axiometry::app
