// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/app/live/runs/capture_run.h"

namespace axiometry::cli {

/// A straightness or a rotation after a plan, options.motion: each reading with its target, and which one is due. The
/// exit code.
int capture_motion(const app::CaptureRun& run, const app::CaptureOptions& options, bool quiet);

}  // namespace axiometry::cli
