// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "axiometry/app/recordings/capture_session.h"

namespace axiometry::cli {

class Verb;

/// What is said of readings that do not show where the axis stops: options.motion, absent without --stops.
struct StopFlags {
  app::CaptureOptions said;  ///< what was said; only `motion` counts
  bool given = false;        ///< --stops
  std::string beside;        ///< another of them, which needs it
};

/// `keys` is the file of what was said at the stops.
void add_stop_flags(const Verb& verb, StopFlags& flags, std::string& keys);

/// What only the whole command line can tell.
void check_stop_flags(const StopFlags& flags, app::CaptureOptions& options);

}  // namespace axiometry::cli
