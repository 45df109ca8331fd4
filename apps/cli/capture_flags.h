// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/app/capture_session.h"

namespace CLI {
class App;
}

namespace axiometry::cli {

/// The flags that say how a continuous recording becomes the readings of a plan; capture and evaluate have them.
void add_capture_flags(CLI::App& verb, app::CaptureOptions& options);

/// Throws on a flag that would do nothing, since no plan is named.
void check_capture_flags(const CLI::App& verb);

}  // namespace axiometry::cli
