// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "axiometry/app/recordings/capture_session.h"

/// What a capture of a straightness or a rotation leaves behind.
namespace axiometry::app {

/// Where the readings came from, as far as the session does not know it.
struct MotionOrigin {
  std::string from;         ///< file, "tcp://…"
  std::string raw;          ///< file of all bytes that came; may be empty
  std::string date;         ///< day of the first of them; may be empty
  std::string simulated{};  ///< what is to be said of readings that nobody measured
};

/// The table that `straightness`, `angles` and `squareness` evaluate: what is known of the readings above it, a row for
/// each in the order in which it was taken, with its time and how still it was. Fails without a reading, and where the
/// positions belong to another plan. Needs session.motion().
Result<std::string> motion_table(const CaptureSession& session, const MotionOrigin& origin);

/// "target 3↑ run 2 at 100 mm: 1.25 µm" and the like, for people who watch.
std::string value_text(const capture::PlannedValue& value, const MotionListener& motion);

}  // namespace axiometry::app
