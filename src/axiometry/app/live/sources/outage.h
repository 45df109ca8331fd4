// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <memory>
#include <string>

#include "axiometry/app/live/sources/live_source.h"
#include "axiometry/base/counted.h"
#include "axiometry/base/quantity.h"

namespace axiometry::app {

constexpr auto first_pause = std::chrono::milliseconds(500);
constexpr auto longest_pause = std::chrono::seconds(8);

/// A source that is away: since when, and what was tried. Pauses between attempts double, from 0.5 s to 8 s.
class Outage {
 public:
  using Clock = std::chrono::steady_clock;

  /// What came of trying; neither: it was stopped meanwhile.
  struct Result {
    std::unique_ptr<LiveStream> stream = nullptr;
    bool given_up = false;
  };

  /// From now on. `samples` had come before; `attempts` were made.
  Outage(std::size_t samples, Duration give_up, std::size_t attempts = 0)
      : last_moment_(since_ +
                     std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(give_up.in_s()))),
        samples_(samples),
        attempts_(attempts) {}

  /// Until it has lasted as long as it may. `wait(until)` is false when it was stopped meanwhile.
  template <typename Wait>
  Result try_again(bool at_once, const Connect& connect, Wait wait) {
    while (true) {
      if (!at_once && !wait(std::min(Clock::now() + pause_, last_moment_))) return {};
      if (Clock::now() >= last_moment_) return {.given_up = true};
      if (!at_once) pause_ = std::min<Clock::duration>(2 * pause_, longest_pause);
      at_once = false;
      ++attempts_;
      if (auto again = connect()) return {.stream = *std::move(again)};
    }
  }

  std::size_t samples() const { return samples_; }
  std::string attempts_text() const { return counted(attempts_, "attempt"); }
  double lasted_s(Clock::time_point until) const { return std::chrono::duration<double>(until - since_).count(); }

 private:
  Clock::time_point since_ = Clock::now();
  Clock::time_point last_moment_;
  Clock::duration pause_ = first_pause;  ///< time before the next attempt
  std::size_t samples_;
  std::size_t attempts_;
};

}  // namespace axiometry::app
