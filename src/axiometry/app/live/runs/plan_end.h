// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <optional>
#include <string>

#include "axiometry/app/files/whole_file.h"
#include "axiometry/app/recordings/capture_session.h"

namespace axiometry::app {

/// Whether a session needs no more. Of lengths the last stop may have come only as it seems while another is missing,
/// because two stops can look alike: then a minute more is heard, in which the next rest tells. What a person takes at
/// each stop can be taken back as long as `for_undo` lasts, the last too, and what is played ends behind all that was
/// said.
class PlanEnd {
 public:
  explicit PlanEnd(Duration for_undo) : for_undo_(for_undo.in_s()) {}

  bool has_come(const CaptureSession& session) {
    if (!session.complete()) last_came_.reset();
    if (!session.complete()) return false;
    if (const MotionListener* motion = session.motion(); motion && motion->stated().sign == capture::StopSign::keys)
      return !motion->values().has_more_said() && for_undo_ <= since_last();
    if (session.stops() == nullptr) return true;
    const capture::StopMatcher& matcher = session.stops()->matcher();
    const auto lengths = std::ranges::count_if(matcher.matches(), [&](const capture::StopMatch& match) {
      return matcher.gives_length(matcher.standstills()[match.standstill]);
    });
    if (static_cast<std::size_t>(lengths) == session.expected()) return true;
    return since_last() > std::chrono::minutes(1);
  }

 private:
  using Clock = std::chrono::steady_clock;

  /// The first time that it is asked none has passed.
  Clock::duration since_last() {
    const Clock::time_point now = Clock::now();
    if (!last_came_) last_came_ = now;
    return now - *last_came_;
  }

  std::chrono::duration<double> for_undo_;
  std::optional<Clock::time_point> last_came_;  // while it is not over
};

/// Whether a file is read behind the last approach of the plan too, so that what else stands there is told. Of what a
/// person said at each stop nothing can.
inline bool reads_behind_plan(const CaptureSession& session, const std::string& from) {
  const MotionListener* motion = session.motion();
  return can_be_read_twice(from) && !(motion != nullptr && motion->stated().sign == capture::StopSign::keys);
}

}  // namespace axiometry::app
