// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/live/runs/capture_date.h"

#include <chrono>
#include <ctime>

#include "axiometry/base/time/iso_date.h"

namespace axiometry::app {

std::string arrival_date(std::optional<ArrivalNs> first_arrival) {
  if (!first_arrival) return {};
  using namespace std::chrono;
  const std::time_t seconds = system_clock::to_time_t(time_point_cast<system_clock::duration>(
      floor<std::chrono::seconds>(sys_time<nanoseconds>(nanoseconds(*first_arrival)))));
  std::tm local{};
  if (::localtime_r(&seconds, &local) == nullptr) return {};
  return iso_day(year(local.tm_year + 1900) / month(static_cast<unsigned>(local.tm_mon) + 1) /
                 day(static_cast<unsigned>(local.tm_mday)));
}

Result<Test> dated_test(const CaptureSession& session, const std::string& from,
                        std::optional<ArrivalNs> first_arrival) {
  AXIOMETRY_TRY(Test test, session.test());
  test.provenance.file = from;
  if (first_arrival) test.metadata.conditions.date = arrival_date(first_arrival);
  return test;
}

}  // namespace axiometry::app
