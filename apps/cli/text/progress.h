// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <functional>
#include <optional>

#include "axiometry/uncertainty/monte_carlo.h"

namespace axiometry::cli {

/// While it lives, Ctrl-C asks the running calculation to end instead of ending the process; a second one ends
/// the process as ever.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  static bool interrupted();
};

/// A bar on the standard error where that is a terminal, for runs that take longer than half a second.
class ProgressBar {
 public:
  explicit ProgressBar(bool wanted);
  ~ProgressBar();

  /// To be called now and then; false once Ctrl-C was pressed.
  bool operator()(const uncertainty::Progress& progress);

  /// Takes the bar off the line, before anything else is written.
  void clear();

 private:
  bool shown_ = false;
  std::size_t width_ = 0;  ///< width of what stands in the line now
  std::size_t last_trials_ = 0;
  std::size_t begin_trials_ = 0;  ///< when this run was first heard of, at `begin_`
  std::optional<std::chrono::steady_clock::time_point> begin_;
};

}  // namespace axiometry::cli
