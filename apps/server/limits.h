// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstddef>

namespace axiometry::server {

/// When who was refused for want of workers or memory, which are soon free again, is told to come again.
inline constexpr std::chrono::seconds ask_again_soon{2};

/// What one client may take of the server. Who exceeds it is told so where that is possible, and cut off.
///
/// A peer is an address, so that all browsers of one machine, or behind one proxy, are one: it may have as many
/// connections as many people need (a browser opens six to a site), and when room runs out the connections that say
/// nothing go first (eviction.h), so that whoever comes anew gets in.
struct Limits {
  std::size_t upload_bytes = std::size_t{64} << 20;  ///< bytes of one body: 413
  std::size_t held_bytes = std::size_t{256} << 20;   ///< bytes of all bodies and answers on their way (eviction.h): 503
  std::size_t head_bytes = std::size_t{16} << 10;    ///< request line and header fields: 431
  std::size_t connections = 1000;                    ///< connections at once; for one more another goes
  std::size_t connections_of_one = 750;              ///< connections of one peer, likewise
  std::size_t waiting = 512;                         ///< requests that wait for a worker: 503
  std::size_t heavy_waiting = 320;                   ///< those that compute for long: 503; of one asker 240
  std::size_t bytes_per_second = std::size_t{64} << 10;  ///< rate that a body, or who reads an answer, must keep up
  std::chrono::seconds head{10};                         ///< time for the whole head, also of the first request: 408
  std::chrono::seconds grace{30};    ///< time for a body or an answer beside what its size allows: 408
  std::chrono::seconds idle{30};     ///< time between two requests
  std::chrono::seconds shutdown{5};  ///< time for requests in flight when the server is to end
  /// From the moment a worker begins; then 503, and what computes is told to stop.
  std::chrono::milliseconds light_deadline{20'000};  ///< time of light requests and of edits
  std::chrono::milliseconds heavy_deadline{60'000};
  std::chrono::milliseconds lone_deadline{180'000};  ///< Monte Carlo
  /// From there, of what may have begun to keep something and does not end: 504, and nobody knows.
  std::chrono::milliseconds outcome_deadline{60'000};
};

}  // namespace axiometry::server
