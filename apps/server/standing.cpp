// SPDX-License-Identifier: Apache-2.0
#include "standing.h"

#include <algorithm>
#include <map>
#include <utility>

namespace axiometry::server {
namespace {

using Doing = Standing::Doing;
using Clock = Standing::Clock;

constexpr auto still = std::chrono::seconds(2);

bool moves_bytes(const Standing& one) { return one.doing == Doing::receiving || one.doing == Doing::sending; }

bool stands_still(const Standing& one, Clock::time_point now) { return now - one.since >= still; }

/// Who goes first has the lower one; nothing for those who stay.
std::optional<int> rank_of(const Standing& one, Clock::time_point now) {
  if (one.doing == Doing::silent) return 0;
  if (one.doing == Doing::idle) return 1;
  if (moves_bytes(one) && stands_still(one, now)) return 2;
  return {};
}

/// The peer of whom `amount` makes most.
template <typename Amount>
std::string_view largest(std::span<const Standing> all, const Amount& amount) {
  std::map<std::string_view, std::size_t> sums;
  for (const Standing& one : all) sums[one.peer] += amount(one);
  const auto most = std::ranges::max_element(sums, {}, &std::pair<const std::string_view, std::size_t>::second);
  return most == sums.end() ? std::string_view() : most->first;
}

std::optional<std::size_t> first_to_go(std::span<const Standing> all, std::string_view peer, Clock::time_point now) {
  std::optional<std::size_t> found;
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (all[k].peer != peer || !rank_of(all[k], now)) continue;
    const auto order = [&](std::size_t i) { return std::pair(*rank_of(all[i], now), all[i].since); };
    if (!found || order(k) < order(*found)) found = k;
  }
  return found;
}

}  // namespace

Room room_for(std::span<const Standing> all, std::string_view peer, std::size_t places, std::size_t share,
              Clock::time_point now) {
  const auto own = static_cast<std::size_t>(std::ranges::count(all, peer, &Standing::peer));
  if (own >= share) return {.is_full = true, .goes = first_to_go(all, peer, now)};
  if (all.size() < places) return {};
  return {.is_full = true, .goes = first_to_go(all, largest(all, [](const Standing&) { return 1; }), now)};
}

std::optional<std::size_t> gives_back(std::span<const Standing> all, std::string_view peer, Clock::time_point now) {
  const std::string_view most = largest(all, [](const Standing& one) { return one.bytes; });
  std::optional<std::size_t> found;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const Standing& one = all[k];
    if (one.peer != most || one.bytes == 0 || !moves_bytes(one)) continue;
    if (most == peer && !stands_still(one, now)) continue;
    if (!found || one.since < all[*found].since) found = k;
  }
  return found;
}

}  // namespace axiometry::server
