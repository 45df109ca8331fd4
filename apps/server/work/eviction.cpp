// SPDX-License-Identifier: Apache-2.0
#include "server/work/eviction.h"

#include <algorithm>
#include <map>
#include <utility>

namespace axiometry::server {
namespace {

using Doing = ConnectionState::Doing;
using Clock = ConnectionState::Clock;

constexpr auto still = std::chrono::seconds(2);

bool moves_bytes(const ConnectionState& one) { return one.doing == Doing::receiving || one.doing == Doing::sending; }

bool stands_still(const ConnectionState& one, Clock::time_point now) { return now - one.since >= still; }

/// Who goes first has the lower one; nothing for those who stay.
std::optional<int> rank_of(const ConnectionState& one, Clock::time_point now) {
  if (one.doing == Doing::silent) return 0;
  if (one.doing == Doing::idle) return 1;
  if (moves_bytes(one) && stands_still(one, now)) return 2;
  return {};
}

bool is_body(const ConnectionState& one) { return one.doing != Doing::sending; }

bool is_small(const ConnectionState& one) { return is_body(one) && one.bytes <= small_body; }

std::size_t bytes_of(std::span<const ConnectionState> all, const auto& among) {
  std::size_t sum = 0;
  for (const ConnectionState& one : all) sum += among(one) ? one.bytes : 0;
  return sum;
}

/// The peer that has most; nobody where none has anything.
std::string_view largest(const std::map<std::string_view, std::size_t>& sums) {
  const auto most = std::ranges::max_element(sums, {}, &std::pair<const std::string_view, std::size_t>::second);
  return most == sums.end() ? std::string_view() : most->first;
}

std::optional<std::size_t> first_to_go(std::span<const ConnectionState> all, std::string_view peer,
                                       Clock::time_point now) {
  std::optional<std::size_t> found;
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (all[k].peer != peer || !rank_of(all[k], now)) continue;
    const auto order = [&](std::size_t i) { return std::pair(*rank_of(all[i], now), all[i].since); };
    if (!found || order(k) < order(*found)) found = k;
  }
  return found;
}

std::optional<std::size_t> gives_back_of(std::span<const ConnectionState> all, std::string_view asker,
                                         Clock::time_point now, const auto& among) {
  std::map<std::string_view, std::size_t> held;
  for (const ConnectionState& one : all) held[one.peer] += one.bytes;
  const auto gives = [&](const ConnectionState& one) {
    const bool gives_way = one.peer != asker && held[one.peer] >= held[asker];
    return one.bytes > 0 && moves_bytes(one) && among(one) && (gives_way || stands_still(one, now));
  };
  std::map<std::string_view, std::size_t> to_give;
  for (const ConnectionState& one : all)
    if (gives(one)) to_give[one.peer] += one.bytes;
  const std::string_view most = largest(to_give);
  std::optional<std::size_t> found;
  for (std::size_t k = 0; k < all.size(); ++k)
    if (all[k].peer == most && gives(all[k]) && (!found || all[k].since < all[*found].since)) found = k;
  return found;
}

}  // namespace

Room room_for(std::span<const ConnectionState> all, std::string_view peer, std::size_t places, std::size_t share,
              Clock::time_point now) {
  const auto own = static_cast<std::size_t>(std::ranges::count(all, peer, &ConnectionState::peer));
  if (own >= share) return {.is_full = true, .goes = first_to_go(all, peer, now)};
  if (all.size() < places) return {};
  std::map<std::string_view, std::size_t> may_go;
  for (const ConnectionState& one : all) may_go[one.peer] += rank_of(one, now) ? 1 : 0;
  return {.is_full = true, .goes = first_to_go(all, largest(may_go), now)};
}

Room memory_for(std::span<const ConnectionState> all, const MemoryClaim& claim, std::size_t most,
                Clock::time_point now) {
  const std::size_t kept_for_small = most / 8;
  const auto is_alike = [&](const ConnectionState& one) { return is_body(one) == claim.of_body; };
  const auto is_own = [&](const ConnectionState& one) { return one.peer == claim.peer && is_alike(one); };
  const auto any = [](const ConnectionState&) { return true; };
  const auto gives = [&](const auto& among) {
    return Room{.is_full = true, .goes = gives_back_of(all, claim.peer, now, among)};
  };
  const auto taken = [&](const auto& among) {
    const std::size_t small = bytes_of(all, is_small);
    return bytes_of(all, among) - small + std::max(small, kept_for_small);
  };
  if (claim.of_body && claim.held + claim.bytes <= small_body) {
    const auto is_own_small = [&](const ConnectionState& one) { return is_own(one) && is_small(one); };
    if (bytes_of(all, is_small) + claim.bytes <= kept_for_small &&
        bytes_of(all, is_own_small) + claim.bytes <= kept_for_small / 2)
      return {};
  }
  const std::size_t own = bytes_of(all, is_own);
  if (own > 0 && own + claim.bytes > most / 2) return gives(is_own);
  if (claim.of_body && taken(is_body) + claim.bytes > most / 4 * 3) return gives(is_alike);
  return taken(any) + claim.bytes > most ? gives(any) : Room{};
}

}  // namespace axiometry::server
