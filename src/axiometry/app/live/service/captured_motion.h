// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "axiometry/app/live/disk/capture_order.h"
#include "axiometry/app/live/lengths/found_table.h"
#include "axiometry/app/recordings/capture_session.h"
#include "axiometry/base/result.h"

namespace axiometry::app {

/// The table that `axiometry capture --stops` would have written, and what was told as notes. `date`: of the first
/// bytes. Fails as motion_table() does. Needs session.motion().
Result<FoundTable> captured_motion(const CaptureSession& session, const CaptureOrder& order, const std::string& date);

}  // namespace axiometry::app
