// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

namespace axiometry::report::plot {

/// A label that stands in rows above the plot, beside the leader that rises to it from its dimension
/// line. `width` is the text's, points.
struct CalloutRequest {
  double leader_x = 0.0;
  double width = 0.0;
  bool prefers_left = false;  ///< text to the left of its leader, if there is room
};

struct CalloutPlace {
  double text_left = 0.0;
  int row = 0;  ///< 0 is next to the plot
};

/// Rows that keep every label within left..right, off the other labels and off the leaders that pass to
/// rows above. As few rows as possible; exhaustive, so for a handful of labels (contract: at most 4).
std::vector<CalloutPlace> place_callouts(std::span<const CalloutRequest> requests, double left, double right);

/// Distance between a leader and its text.
inline constexpr double leader_gap = 2.5;

}  // namespace axiometry::report::plot
