// SPDX-License-Identifier: Apache-2.0
#include "server/access/security_log.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <utility>

#include "axiometry/base/time/iso_date.h"

namespace axiometry::server {
namespace {

constexpr std::size_t word_max = 60;  // bytes of what others said

std::string time_text(SecurityLog::Clock::time_point now) {
  const auto second = std::chrono::floor<std::chrono::seconds>(now);
  const auto day = std::chrono::floor<std::chrono::days>(second);
  const std::chrono::hh_mm_ss time(second - day);
  return fmt::format("{}T{:02}:{:02}:{:02}Z", iso_day(day), time.hours().count(), time.minutes().count(),
                     time.seconds().count());
}

std::string word(std::string_view text) {
  return text.size() <= word_max ? log_text(text) : log_text(text.substr(0, word_max)) + "...";
}

}  // namespace

std::string_view name_of(SecurityEvent event) {
  switch (event) {
    case SecurityEvent::none: return "none";
    case SecurityEvent::signed_in: return "signed-in";
    case SecurityEvent::signed_in_ending_another: return "signed-in-ending-another";
    case SecurityEvent::sign_in_refused: return "sign-in-refused";
    case SecurityEvent::signed_out: return "signed-out";
    case SecurityEvent::session_refused: return "session-refused";
    case SecurityEvent::token_missing: return "token-missing";
    case SecurityEvent::token_refused: return "token-refused";
    case SecurityEvent::host_refused: return "host-refused";
    case SecurityEvent::origin_refused: return "origin-refused";
    case SecurityEvent::method_refused: return "method-refused";
    case SecurityEvent::quota_refused: return "quota-refused";
  }
  return "none";
}

/// A clock that went back grants nothing.
void SecurityLog::Allowance::grow(Clock::time_point now) {
  if (lines == burst || now < since) since = now;
  const auto more = (now - since) / pause;
  lines = static_cast<unsigned>(std::min<std::int64_t>(burst, lines + more));
  since += more * pause;
}

SecurityLog::~SecurityLog() { tell_left_out(); }

void SecurityLog::tell(const Entry& entry, Clock::time_point now) {
  if (entry.event == SecurityEvent::none) return;
  const std::scoped_lock lock(mutex_);
  for (std::size_t kind = 0; kind < kinds; ++kind) {
    allowances_[kind].grow(now);
    if (allowances_[kind].lines > 0) tell_left_out_of(kind, now);
  }
  Allowance& own = allowances_[static_cast<std::size_t>(entry.event)];
  if (own.lines == 0) {
    ++own.left_out;
    return;
  }
  --own.lines;
  write_(fmt::format("axiometry: security {} {} peer={} method={} path={} status={}", time_text(now),
                     name_of(entry.event), word(entry.peer), word(entry.method), word(entry.path), entry.status));
}

void SecurityLog::tell_left_out(Clock::time_point now) noexcept {
  try {
    const std::scoped_lock lock(mutex_);
    for (std::size_t kind = 0; kind < kinds; ++kind) tell_left_out_of(kind, now);
  } catch (const std::exception& exception) {
    log_failure("the log's end", exception);
  }
}

void SecurityLog::tell_left_out_of(std::size_t kind, Clock::time_point now) {
  Allowance& allowance = allowances_[kind];
  const std::uint64_t count = std::exchange(allowance.left_out, 0);
  if (count == 0) return;
  write_(fmt::format("axiometry: security {} left-out event={} count={}", time_text(now),
                     name_of(static_cast<SecurityEvent>(kind)), count));
}

}  // namespace axiometry::server
