// SPDX-License-Identifier: Apache-2.0
#include "cli/text/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <string>

#include "cli/text/terminal.h"

namespace axiometry::cli {
namespace {

volatile std::sig_atomic_t interrupt_count = 0;  // a signal can reach nothing but a global

void on_interrupt(int) { interrupt_count = 1; }

constexpr std::size_t bar_width = 24;
constexpr auto quiet_time = std::chrono::milliseconds(500);

/// "1 234 567"
std::string grouped(std::size_t number) {
  std::string digits = fmt::format("{}", number);
  for (auto place = static_cast<std::ptrdiff_t>(digits.size()) - 3; place > 0; place -= 3)
    digits.insert(static_cast<std::size_t>(place), " ");
  return digits;
}

}  // namespace

InterruptGuard::InterruptGuard() {
  struct sigaction action {};
  action.sa_handler = on_interrupt;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigaction(SIGINT, &action, nullptr);
}

InterruptGuard::~InterruptGuard() { std::signal(SIGINT, SIG_DFL); }

bool InterruptGuard::interrupted() { return interrupt_count != 0; }

ProgressBar::ProgressBar(bool wanted) : shown_(wanted && isatty(STDERR_FILENO) != 0) {}

ProgressBar::~ProgressBar() { clear(); }

bool ProgressBar::operator()(const uncertainty::Progress& progress) {
  if (InterruptGuard::interrupted()) return false;
  if (!shown_) return true;
  const auto now = std::chrono::steady_clock::now();
  if (!begin_ || progress.trials <= last_trials_) {  // a run has begun, or another one
    begin_ = now;
    begin_trials_ = progress.trials;
  }
  last_trials_ = progress.trials;
  if (now - *begin_ < quiet_time) return true;
  std::string line;
  if (progress.of && *progress.of > 0) {
    const double done = static_cast<double>(progress.trials) / static_cast<double>(*progress.of);
    const auto filled = std::min(bar_width, static_cast<std::size_t>(done * static_cast<double>(bar_width)));
    const auto left_to_do = static_cast<double>(*progress.of - std::min(progress.trials, *progress.of));
    const double seconds = std::chrono::duration<double>(now - *begin_).count() * left_to_do /
                           static_cast<double>(progress.trials - begin_trials_);
    line = fmt::format("[{}{}] {:3.0f} %  {} of {} trials, {:.0f} s left", std::string(filled, '#'),
                       std::string(bar_width - filled, '-'), 100.0 * done, grouped(progress.trials),
                       grouped(*progress.of), seconds);
  } else {
    line = fmt::format("{} trials, until two digits are stable", grouped(progress.trials));
  }
  fmt::print(stderr, "\r{}", left(line, width_));
  width_ = display_width(line);
  std::fflush(stderr);
  return true;
}

void ProgressBar::clear() {
  if (width_ > 0) fmt::print(stderr, "\r{}\r", std::string(width_, ' '));
  width_ = 0;
}

}  // namespace axiometry::cli
