// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>

#include "server/access/security_event.h"
#include "server/log.h"

namespace axiometry::server {

/// Who was let in and who was not: a line each, "axiometry: security TIME EVENT peer=… method=… path=… status=…", the
/// time in UTC, all of it visible ASCII, without query, name, token and session. Of each event as many at once as
/// `burst`, then one in `pause`, so that who floods the server does not fill its disk; how many were left out is told
/// as "left-out event=… count=…" before the next line, and at the end. May be used from many threads.
class SecurityLog {
 public:
  using Clock = std::chrono::system_clock;
  static constexpr unsigned burst = 20;
  static constexpr std::chrono::seconds pause{10};

  struct Entry {
    SecurityEvent event = SecurityEvent::none;
    std::string_view peer;
    std::string_view method;
    std::string_view path;
    int status = 0;
  };

  explicit SecurityLog(std::function<void(std::string_view)> write = log_line) : write_(std::move(write)) {}
  ~SecurityLog();
  SecurityLog(const SecurityLog&) = delete;
  SecurityLog& operator=(const SecurityLog&) = delete;

  /// Nothing where the event is none.
  void tell(const Entry& entry, Clock::time_point now = Clock::now());

  /// How many were left out until now, as at the end: where the process is to end without it.
  void tell_left_out(Clock::time_point now = Clock::now()) noexcept;

 private:
  struct Allowance {
    unsigned lines = burst;
    Clock::time_point since{};  ///< time up to which pauses were counted
    std::uint64_t left_out = 0;

    void grow(Clock::time_point now);
  };
  static constexpr std::size_t kinds = static_cast<std::size_t>(SecurityEvent::quota_refused) + 1;

  void tell_left_out_of(std::size_t kind, Clock::time_point now);

  std::function<void(std::string_view)> write_;
  std::mutex mutex_;
  std::array<Allowance, kinds> allowances_{};  ///< allowance of each event
};

/// "token-refused"
std::string_view name_of(SecurityEvent event);

}  // namespace axiometry::server
