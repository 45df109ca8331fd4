// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstddef>

namespace axiometry::app {

/// A source that is away: since when, and what was tried.
struct Outage {
  using Clock = std::chrono::steady_clock;
  static constexpr Clock::duration first_pause = std::chrono::milliseconds(500);

  Clock::time_point since;
  Clock::duration pause = first_pause;  ///< before the next attempt
  std::size_t attempts = 0;
  std::size_t samples = 0;  ///< that had come before
};

}  // namespace axiometry::app
