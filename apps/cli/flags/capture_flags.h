// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/app/recordings/capture_session.h"

namespace axiometry::cli {

class Verb;

/// The flags that say how a continuous recording becomes the readings of a plan; capture and evaluate have them.
void add_capture_flags(const Verb& verb, app::CaptureOptions& options);

/// Those of them that say something of a recording of lengths.
void add_length_recording_flags(const Verb& verb, app::CaptureOptions& options);

/// Throws on a flag that would do nothing, since no plan is named.
void check_capture_flags(const Verb& verb);

}  // namespace axiometry::cli
