// SPDX-License-Identifier: Apache-2.0
#include "axiometry/nc/turn.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "axiometry/base/contract.h"

namespace axiometry::nc {
namespace {

std::int64_t units_per_deg(int decimals) {
  std::int64_t units = 1;
  for (int k = 0; k < decimals; ++k) units *= 10;
  return units;
}

int decimals_of(std::int64_t units, int decimals) {
  for (; decimals > 0 && units % 10 == 0; units /= 10) --decimals;
  return decimals;
}

}  // namespace

std::int64_t Turn::units(Position position) const {
  std::string text = coordinates_.text(position.in_native());
  std::erase(text, '.');
  return std::strtoll(text.c_str(), nullptr, 10);
}

/// Below 2⁵³ units, so that the nearest double has their decimals.
std::string Turn::text_of(std::int64_t units) const {
  return coordinates_.text(static_cast<double>(units) / static_cast<double>(units_per_deg(coordinates_.decimals())));
}

std::vector<TurnWord> Turn::to(Position position) {
  AXIOMETRY_CONTRACT(words_ != RolloverWords::none && !coordinates_.in_inch());
  const std::int64_t turn = 360 * units_per_deg(coordinates_.decimals()), to = units(position);
  const auto angle = [&](std::int64_t units) { return text_of(((units % turn) + turn) % turn); };
  const bool directed = words_ == RolloverWords::directed;
  if (!at_) {
    at_ = to;
    return {{directed ? AxisWay::short_way : AxisWay::position, angle(to)}};
  }
  const std::int64_t from = *at_, way = to - from;
  at_ = to;
  if (!directed) {
    decimals_needed_ = std::max(decimals_needed_, decimals_of(way, coordinates_.decimals()));
    return {{AxisWay::increment, text_of(way)}};
  }
  // To the angle where it stands already an axis does not go at all, so a turn is driven in parts below half of one.
  const std::int64_t parts = std::abs(way) < turn ? 1 : 2 * std::abs(way) / turn + 1;
  std::vector<TurnWord> words;
  for (std::int64_t k = 1; k <= parts; ++k)
    words.push_back({way > 0 ? AxisWay::upwards : AxisWay::downwards, angle(from + way * k / parts)});
  return words;
}

std::string rollover_off_remark(const Plan& plan) {
  const auto [lowest, highest] = reach(plan);
  bool one_way = lowest.in_native() >= 0.0 && highest.in_native() < 360.0;
  if (one_way && highest.in_native() - lowest.in_native() >= 180.0) {
    const std::vector<PlannedMove> all = moves(plan);
    one_way = std::ranges::adjacent_find(all, [](const PlannedMove& from, const PlannedMove& move) {
                return std::abs(move.to.in_native() - from.to.in_native()) >= 180.0;
              }) == all.end();
  }
  return one_way ? "ROLLOVER OFF, NOT FOR AN AXIS WHOSE WAY IS TOLD BY THE SIGN OF THE ANGLE"
                 : "ROLLOVER OFF, NOT FOR AN AXIS THAT COUNTS TO 360 DEG ONLY OR GOES THE SHORT WAY";
}

}  // namespace axiometry::nc
