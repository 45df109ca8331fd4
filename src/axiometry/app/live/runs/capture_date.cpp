// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/live/runs/capture_date.h"

#include <chrono>

#include "axiometry/base/time/iso_date.h"

namespace axiometry::app {

std::string arrival_date(std::optional<ArrivalNs> first_arrival) {
  if (!first_arrival) return {};
  using namespace std::chrono;
  return iso_day(floor<days>(sys_time<nanoseconds>(nanoseconds(*first_arrival))));
}

Result<Test> dated_test(const CaptureSession& session, const std::string& from,
                        std::optional<ArrivalNs> first_arrival) {
  AXIOMETRY_TRY(Test test, session.test());
  test.provenance.file = from;
  if (first_arrival) test.metadata.conditions.date = arrival_date(first_arrival);
  return test;
}

}  // namespace axiometry::app
