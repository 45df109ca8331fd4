// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <optional>

#include "axiometry/app/recordings/capture_session.h"

namespace axiometry::app {

/// Whether a session needs no more. Of lengths the last stop may have come only as it seems while another is missing,
/// because two stops can look alike: then a minute more is heard, in which the next rest tells.
class PlanEnd {
 public:
  bool has_come(const CaptureSession& session) {
    if (!session.complete()) last_came_.reset();
    if (!session.complete() || session.stops() == nullptr) return session.complete();
    const capture::StopMatcher& matcher = session.stops()->matcher();
    const auto lengths = std::ranges::count_if(matcher.matches(), [&](const capture::StopMatch& match) {
      return matcher.gives_length(matcher.standstills()[match.standstill]);
    });
    if (static_cast<std::size_t>(lengths) == session.expected()) return true;
    if (!last_came_) last_came_ = Clock::now();
    return Clock::now() - *last_came_ > std::chrono::minutes(1);
  }

 private:
  using Clock = std::chrono::steady_clock;
  std::optional<Clock::time_point> last_came_;  // while some are missing
};

}  // namespace axiometry::app
