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
struct Standing {
  using Clock = std::chrono::steady_clock;
  enum class Doing {
    silent,     ///< has sent no whole request yet
    idle,       ///< between two requests
    receiving,  ///< a body comes
    waiting,    ///< for its answer
    sending,    ///< its answer goes out
  };
  std::string_view peer{};
  Doing doing = Doing::silent;
  Clock::time_point since{};  ///< when something of it came or went the last time
  std::size_t bytes = 0;      ///< of bodies and answers that it holds
};

/// The place of the connection that gives way to a new one of `peer`, where there are already `places` in all or
/// `share` of that peer: among those of the peer that has most (or has its share) a silent one, else an idle one, else
/// one whose answer or body does not move, each time the one that has been still for longest. One that waits for its
/// answer stays. Nothing where there is room, or nobody can go: then the new one does not come in.
struct Room {
  bool is_full = false;
  std::optional<std::size_t> goes{};
};
Room room_for(std::span<const Standing> all, std::string_view peer, std::size_t places, std::size_t share,
              Standing::Clock::time_point now);

/// The place of the connection that gives back what it holds so that `peer` can hold more: of those that receive or
/// send, of the peer that holds most, the one that has been still for longest; of the same peer only one that stands
/// still. Nothing where nobody can.
std::optional<std::size_t> gives_back(std::span<const Standing> all, std::string_view peer,
                                      Standing::Clock::time_point now);

}  // namespace axiometry::server
