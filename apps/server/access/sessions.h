// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstddef>
#include <map>
#include <mutex>
#include <string>
#include <string_view>

namespace axiometry::server {

/// Who has signed in. A session is a random value of 256 bits that only its owner knows: here are hashes alone. It can
/// be ended by itself, ends when it is old or was not used, and ends with the program. May be used from many threads.
class Sessions {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::hours longest{30 * 24};  ///< longest life of a session
  static constexpr std::chrono::hours unused{7 * 24};    ///< longest time that a session may lie unused
  static constexpr std::size_t most = 10'000;  ///< number of sessions; for one more the one unused for longest ends

  struct Begun {
    std::string session;
    bool ends_another = false;
  };
  Begun begin(Clock::time_point now);
  bool knows(std::string_view session, Clock::time_point now);
  bool end(std::string_view session);  ///< whether there was one
  std::size_t count() const;

 private:
  struct Times {
    Clock::time_point began;
    Clock::time_point used;
  };
  static bool is_over(const Times& times, Clock::time_point now);

  mutable std::mutex mutex_;
  std::map<std::string, Times, std::less<>> all_;  // keyed by SHA-256: how long a search takes tells nothing
};

}  // namespace axiometry::server
