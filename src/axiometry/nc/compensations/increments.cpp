// SPDX-License-Identifier: Apache-2.0
#include "axiometry/nc/compensations/increments.h"

#include <fmt/format.h>

#include "axiometry/base/text/rounded_text.h"
#include "axiometry/nc/table_text.h"

namespace axiometry::nc::increments {

Result<std::vector<long long>> of_curve(const std::vector<double>& positions, const std::vector<double>& values,
                                        double count, const Range& range) {
  std::vector<long long> found;
  for (std::size_t k = 1; k < values.size(); ++k) {
    const long long step = counts(values[k], count) - counts(values[k - 1], count);
    if (step < range.lowest || step > range.highest)
      return fail(
          fmt::format("found {} {} to be added from {} to {}, expected {} to {} in one number of the table: {} "
                      "may do",
                      step, range.unit, format_rounded(positions[k - 1]), format_rounded(positions[k]), range.lowest,
                      range.highest, range.way_out));
    found.push_back(step);
  }
  return found;
}

}  // namespace axiometry::nc::increments
