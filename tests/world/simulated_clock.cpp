// SPDX-License-Identifier: Apache-2.0
#include "simulated_clock.h"

#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#include <atomic>

namespace axiometry::world {
namespace {
constexpr std::int64_t ns_per_ms = 1'000'000, ns_per_s = 1'000'000'000;
std::atomic<std::int64_t> now_ms{1'790'000'000'000};
std::atomic<std::int64_t> steady_ns{1'000 * ns_per_s};
constexpr std::int64_t ns_to_ask = 1'000;  // so that who only waits gets there
}  // namespace

void move_clock_ms(std::int64_t by) { now_ms += by; }

void pass_ms(std::int64_t by) {
  now_ms += by;
  steady_ns += by * ns_per_ms;
}

}  // namespace axiometry::world

using namespace axiometry::world;

/// In place of that of the library of C, for the whole program.
extern "C" int clock_gettime(clockid_t clock, timespec* out) noexcept {
  if (clock != CLOCK_REALTIME && clock != CLOCK_MONOTONIC)
    return static_cast<int>(syscall(SYS_clock_gettime, clock, out));
  const std::int64_t ns = clock == CLOCK_REALTIME ? now_ms* ns_per_ms : steady_ns += ns_to_ask;
  *out = {ns / ns_per_s, ns % ns_per_s};
  return 0;
}

extern "C" int __wrap_nanosleep(const timespec* wanted, timespec*) {
  pass_ms(wanted->tv_sec * 1000 + wanted->tv_nsec / ns_per_ms);
  return 0;
}
