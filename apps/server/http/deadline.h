// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <cstdint>
#include <utility>

namespace axiometry::server {

/// The time that one step of a connection may take.
class Deadline {
 public:
  using Clock = std::chrono::steady_clock;

  explicit Deadline(const boost::asio::any_io_executor& executor) : timer_(executor) {}

  /// Calls that then, unless this is set anew or lifted before. It must hold what holds this.
  template <typename Then>
  void set(Clock::time_point end, Then then) {
    has_passed_ = false;
    timer_.expires_at(end);
    timer_.async_wait(
        [this, number = ++number_, then = std::move(then)](const boost::system::error_code& code) mutable {
          if (code || number != number_) return;
          has_passed_ = true;
          then();
        });
  }

  void lift() {
    ++number_;
    timer_.cancel();
  }

  bool has_passed() const { return has_passed_; }

 private:
  boost::asio::steady_timer timer_;
  std::uint64_t number_ = 0;  // number of the last one, so that one that has passed meanwhile is known
  bool has_passed_ = false;
};

}  // namespace axiometry::server
