// SPDX-License-Identifier: Apache-2.0
#include "axiometry/store/database/clock.h"

#include <fmt/format.h>

#include <chrono>

#include "axiometry/base/time/iso_date.h"

namespace axiometry::store {

std::string now_text() {
  using namespace std::chrono;
  const auto now = floor<milliseconds>(system_clock::now());
  const auto day = floor<days>(now);
  const hh_mm_ss time(now - day);
  return fmt::format("{}T{:02}:{:02}:{:02}.{:03}Z", iso_day(day), time.hours().count(), time.minutes().count(),
                     time.seconds().count(), time.subseconds().count());
}

Change change_now(const By& by) { return {now_text(), by.actor, by.reason}; }

}  // namespace axiometry::store
