// SPDX-License-Identifier: Apache-2.0
#include "simulated_clock.h"

#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#include <atomic>

namespace axiometry::world {
namespace {
std::atomic<std::int64_t> now_ms{1'790'000'000'000};
}

void set_clock_ms(std::int64_t since_1970) { now_ms = since_1970; }
void move_clock_ms(std::int64_t by) { now_ms += by; }

}  // namespace axiometry::world

/// In place of that of the library of C, for the whole program.
extern "C" int clock_gettime(clockid_t clock, timespec* out) noexcept {
  if (clock != CLOCK_REALTIME) return static_cast<int>(syscall(SYS_clock_gettime, clock, out));
  const std::int64_t ms = axiometry::world::now_ms;
  *out = {ms / 1000, ms % 1000 * 1'000'000};
  return 0;
}
