// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/live/runs/capture_date.h"

#include <fmt/format.h>

#include <chrono>

namespace axiometry::app {

std::string arrival_date(std::optional<ArrivalNs> first_arrival) {
  if (!first_arrival) return {};
  using namespace std::chrono;
  const year_month_day day(floor<days>(sys_time<nanoseconds>(nanoseconds(*first_arrival))));
  return fmt::format("{:04}-{:02}-{:02}", static_cast<int>(day.year()), static_cast<unsigned>(day.month()),
                     static_cast<unsigned>(day.day()));
}

Result<Test> dated_test(const CaptureSession& session, const std::string& from,
                        std::optional<ArrivalNs> first_arrival) {
  AXIOMETRY_TRY(Test test, session.test());
  test.provenance.file = from;
  if (first_arrival) test.metadata.conditions.date = arrival_date(first_arrival);
  return test;
}

}  // namespace axiometry::app
