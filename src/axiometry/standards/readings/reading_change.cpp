// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/readings/reading_change.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "axiometry/standards/readings/test_course.h"

namespace axiometry {

Position datum_of(const Metadata& metadata, const Series& series) {
  return metadata.nde.datum.value_or(series.targets().front());
}

Result<ChangedTest> change_readings(Test test, const ReadingChange& added) {
  const Series& series = test.series;
  const TestCourse course = course_of(test);
  const double datum = datum_of(test).in_native();
  const double per_position = deviation_per_position(test.metadata.axis.kind);
  std::vector<double> deviations;
  deviations.reserve(2 * series.target_count() * series.run_count());
  double smallest = std::numeric_limits<double>::infinity();
  double largest = -smallest;
  for (Direction direction : {Direction::up, Direction::down})
    for (std::size_t i = 0; i < series.target_count(); ++i) {
      const double target = series.targets()[i].in_native();
      const auto readings = series.cell(i, direction);
      for (std::size_t j = 0; j < readings.size(); ++j) {
        const double x = readings[j];
        deviations.push_back(x);
        if (std::isnan(x)) continue;
        const double length = (target - datum) * per_position + x;
        const double change = added({target, x, length, course.at(series, i, direction, j)}) + 0.0;  // no −0
        deviations.back() += change;
        smallest = std::min(smallest, change);
        largest = std::max(largest, change);
      }
    }
  AXIOMETRY_TRY(Series result, Series::make_dense({series.targets().begin(), series.targets().end()},
                                                  series.run_count(), std::move(deviations)));
  Series before = std::exchange(test.series, std::move(result));
  if (!test.as_measured) test.as_measured = std::move(before);
  return ChangedTest{std::move(test), Deviation::native(smallest), Deviation::native(largest)};
}

}  // namespace axiometry
