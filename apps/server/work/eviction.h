// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

/// Which connection goes when there is room for no more. A peer is an address, or who has signed in.
namespace axiometry::server {

/// What one connection does and takes.
struct ConnectionState {
  using Clock = std::chrono::steady_clock;
  enum class Doing {
    silent,     ///< has sent no whole request yet
    idle,       ///< it is between two requests
    receiving,  ///< a body comes
    waiting,    ///< it waits for its answer
    sending,    ///< its answer goes out
  };
  std::string_view peer{};
  Doing doing = Doing::silent;
  Clock::time_point since{};  ///< when something of it came or went the last time
  std::size_t bytes = 0;      ///< bytes of bodies and answers that it holds
};

/// The place of the connection that gives way to a new one of `peer`, where there are already `places` in all or
/// `share` of that peer: among those of the peer that has most who may go (or has its share) a silent one, else an idle
/// one, else one whose answer or body does not move, each time the one that has been still for longest. One that waits
/// for its answer stays. Nothing where there is room, or nobody can go: then the new one does not come in.
struct Room {
  bool is_full = false;
  std::optional<std::size_t> goes{};
};
Room room_for(std::span<const ConnectionState> all, std::string_view peer, std::size_t places, std::size_t share,
              ConnectionState::Clock::time_point now);

/// What somebody is to hold beside what it holds already.
struct MemoryClaim {
  std::string_view peer{};
  std::size_t bytes = 0;
  bool of_body = false;  ///< they are of a body, else of an answer
  std::size_t held = 0;  ///< bytes of the same body that have come before
};

/// Of these any connection may have one, so that a list or an edit is answered beside uploads.
inline constexpr std::size_t small_body = std::size_t{64} << 10;

/// Whether that fits into `most` bytes for all, and which place gives back what it holds where it does not: of those
/// that receive or send and either stand still or are of another peer that holds no less, of the peer that has most to
/// give so, the one that has been still for longest. Nothing where nobody can.
///
/// Bodies, which stay as long as they wait, have at most three quarters of it together, so that there is always room
/// for answers, and of that an eighth of all is kept for small ones, half of it for one peer; where they are more they
/// count as the large ones do. One peer has at most half of all for its bodies, and half for its answers.
Room memory_for(std::span<const ConnectionState> all, const MemoryClaim& claim, std::size_t most,
                ConnectionState::Clock::time_point now);

}  // namespace axiometry::server
