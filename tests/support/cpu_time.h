// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ctime>

namespace axiometry::testing_support {

/// What this thread has computed until now, s: a bound of it holds on a busy machine, where a clock's does not.
inline double cpu_seconds() {
  std::timespec time{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace axiometry::testing_support
