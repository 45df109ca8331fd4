// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstddef>

namespace axiometry::server {

/// What one client may take of the server. Who exceeds it is told so where that is possible, and cut off.
struct Limits {
  std::size_t upload_bytes = std::size_t{64} << 20;      ///< of one body: 413
  std::size_t bodies_bytes = std::size_t{256} << 20;     ///< of all bodies that are on their way or being answered: 503
  std::size_t head_bytes = std::size_t{16} << 10;        ///< request line and header fields: 431
  std::size_t connections = 1000;                        ///< more are closed at once
  std::size_t waiting = 512;                             ///< requests that wait for a worker: 503
  std::size_t heavy_waiting = 320;                       ///< those that compute for long: 503; of one asker 240
  std::size_t bytes_per_second = std::size_t{64} << 10;  ///< that a body, or who reads an answer, must keep up
  std::chrono::seconds head{10};                         ///< for the whole head, also of the first request: 408
  std::chrono::seconds grace{30};                        ///< for a body or an answer beside what its size allows: 408
  std::chrono::seconds idle{30};                         ///< between two requests
  std::chrono::seconds farewell{5};                      ///< for requests in flight when the server is to end
};

}  // namespace axiometry::server
