// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "axiometry/model/recording.h"
#include "axiometry/model/series.h"

namespace axiometry::capture {

/// How fast the axis was in the middle of a way, mm/s or °/s.
struct Speed {
  double per_s = 0.0;     ///< over the middle quarter of the way
  double known_to = 0.0;  ///< step in time over the time of that quarter: share of the speed by which it may be wrong
  bool even = false;      ///< it is the feed, since the middle half was as fast, or no axis starts so slowly; else the
                          ///< axis may have been on its way to a faster one
};

/// Follows a motion and tells its speed. Keeps some hundred places, however long the motion is.
class WaySpeed {
 public:
  /// Samples of one cell along which the axis moved.
  void move_along(std::span<const Sample> samples);
  /// The axis has turned: only the way from where it was farthest counts, in the direction that it has now.
  void turned(Direction now);
  /// A new way begins.
  void forget();

  /// Of the way in that direction to `to`; nothing of one too short for its samples to tell it.
  std::optional<Speed> speed(Direction direction, double to) const;

 private:
  std::size_t farthest_behind(Direction direction) const;

  std::vector<Sample> places_;
  std::size_t stride_ = 1;  // of the places that come one in so many is kept
  std::size_t passed_ = 0;
  std::vector<Sample> before_;  // the last two samples
};

}  // namespace axiometry::capture
