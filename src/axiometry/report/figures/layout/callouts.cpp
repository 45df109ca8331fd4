// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/figures/layout/callouts.h"

#include <algorithm>
#include <cstddef>

#include "axiometry/base/contract.h"

namespace axiometry::report::plot {
namespace {

constexpr double text_gap = 7.0;     // between two labels of a row
constexpr double leader_room = 2.0;  // between a label and a foreign leader

double text_right(const CalloutRequest& request, const CalloutPlace& place) { return place.text_left + request.width; }

bool passes_through(const CalloutRequest& leader, const CalloutRequest& request, const CalloutPlace& place) {
  return leader.leader_x > place.text_left - leader_room && leader.leader_x < text_right(request, place) + leader_room;
}

bool clash(const CalloutRequest& a, const CalloutPlace& at_a, const CalloutRequest& b, const CalloutPlace& at_b) {
  if (at_a.row == at_b.row) {
    return at_a.text_left < text_right(b, at_b) + text_gap && at_b.text_left < text_right(a, at_a) + text_gap;
  }
  return at_a.row > at_b.row ? passes_through(a, b, at_b) : passes_through(b, a, at_a);
}

bool valid(std::span<const CalloutRequest> requests, std::span<const CalloutPlace> places, double left, double right) {
  for (std::size_t a = 0; a < requests.size(); ++a) {
    if (places[a].text_left < left || text_right(requests[a], places[a]) > right) return false;
    for (std::size_t b = 0; b < a; ++b) {
      if (clash(requests[a], places[a], requests[b], places[b])) return false;
    }
  }
  return true;
}

}  // namespace

std::vector<CalloutPlace> place_callouts(std::span<const CalloutRequest> requests, double left, double right) {
  AXIOMETRY_CONTRACT(requests.size() <= 4);
  const std::size_t rows = std::max<std::size_t>(requests.size(), 1);
  std::size_t combinations = 1;
  for (std::size_t k = 0; k < requests.size(); ++k) combinations *= 2 * rows;

  std::vector<CalloutPlace> best;
  int best_cost = 0;
  for (std::size_t combination = 0; combination < combinations; ++combination) {
    std::vector<CalloutPlace> places;
    std::size_t rest = combination;
    int cost = 0;
    int highest = 0;
    for (const CalloutRequest& request : requests) {
      const bool on_left = rest % 2 == 1;
      const int row = static_cast<int>(rest / 2 % rows);
      rest /= 2 * rows;
      const double text_left = on_left ? request.leader_x - leader_gap - request.width : request.leader_x + leader_gap;
      places.push_back({text_left, row});
      highest = std::max(highest, row);
      cost += 4 * row + (on_left != request.prefers_left ? 1 : 0);
    }
    cost += 100 * highest;
    if (valid(requests, places, left, right) && (best.empty() || cost < best_cost)) {
      best = std::move(places);
      best_cost = cost;
    }
  }
  if (!best.empty() || requests.empty()) return best;
  // Labels wider than the room: a row each, pushed inside as far as they go.
  for (std::size_t k = 0; k < requests.size(); ++k) {
    const double text_left = std::min(requests[k].leader_x + leader_gap, right - requests[k].width);
    best.push_back({std::max(text_left, left), static_cast<int>(k)});
  }
  return best;
}

}  // namespace axiometry::report::plot
