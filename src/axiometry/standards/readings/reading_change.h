// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>

#include "axiometry/base/result.h"
#include "axiometry/model/test.h"

/// What all corrections of readings have in common. Private to standards/.
namespace axiometry {

/// One reading as a correction sees it.
struct ReadingAt {
  double target = 0.0;     ///< P_i, mm or °
  double deviation = 0.0;  ///< x_ij, µm or ″
  double length = 0.0;     ///< displayed, from the datum: P_i + x_ij less the datum, µm or ″
  double share = 0.0;      ///< share of the course of the test (test_course.h)
};

/// What is added to a reading, µm or ″.
using ReadingChange = std::function<double(const ReadingAt&)>;

struct ChangedTest {
  Test test;
  Deviation smallest;  ///< smallest amount that was added
  Deviation largest;
};

/// Where the instrument was set to zero: `nde.datum`, else the first target.
Position datum_of(const Metadata& metadata, const Series& series);
inline Position datum_of(const Test& test) { return datum_of(test.metadata, test.series); }

/// The test with something added to each of its readings; `as_measured` keeps what the readings were before the first
/// change, a missing reading stays missing. Fails where a reading becomes none (Series::make_dense).
Result<ChangedTest> change_readings(Test test, const ReadingChange& added);

}  // namespace axiometry
