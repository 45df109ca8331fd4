// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>

#include "axiometry/app/evaluate/evaluate.h"
#include "axiometry/report/report.h"

namespace axiometry::app {

/// What a report is made of, all of a test that was evaluated; which must outlive it.
inline report::Subject report_subject(const Evaluated& evaluated, std::string trail_head = {}) {
  return {evaluated.test,         evaluated.assessment,  evaluated.judgements,
          evaluated.verified,     std::move(trail_head), evaluated.temperatures ? &*evaluated.temperatures : nullptr,
          evaluated.environment()};
}

}  // namespace axiometry::app
