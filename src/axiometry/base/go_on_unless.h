// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stop_token>

#include "axiometry/base/result.h"

namespace axiometry {

/// Fails, as unavailable, once nobody waits for the answer any more: what keeps nothing asks between its steps.
inline Result<void> go_on_unless(const std::stop_token& stop) {
  if (!stop.stop_requested()) return {};
  return fail(ErrorKind::unavailable, "stopped before it was done; nothing was kept");
}

}  // namespace axiometry
