// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/app/live/runs/capture_run.h"
#include "axiometry/app/recordings/motion_listener.h"
#include "axiometry/base/result.h"

namespace axiometry::app {

/// What was said at the stops: of run.keys, or else beside the recording that is played or gone on with. Fails as
/// read_marks() does, on marks beside a live recording that is to begin, on a file of them with a live source, and
/// where keys tell the stops and a finished recording has none.
Result<void> take_marks(const CaptureRun& run, MotionStatement& stated);

}  // namespace axiometry::app
