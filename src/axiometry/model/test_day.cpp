// SPDX-License-Identifier: Apache-2.0
#include "axiometry/model/test_day.h"

#include <chrono>

#include "axiometry/base/time/iso_date.h"

namespace axiometry {

bool can_be_day_of_test(std::string_view iso_day_text) {
  using namespace std::chrono;
  constexpr std::string_view no_test_before = "1950-01-01";
  // East of Greenwich it may be the next day.
  return iso_day_text >= no_test_before && iso_day_text <= iso_day(floor<days>(system_clock::now()) + days(1));
}

std::string day_of_test(std::string_view date) {
  std::string day = iso_date(date);
  return can_be_day_of_test(day) ? day : std::string();
}

}  // namespace axiometry
