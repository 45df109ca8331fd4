// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "axiometry/base/decimal_tie.h"
#include "axiometry/model/series.h"
#include "axiometry/standards/iso230_2/parameters.h"

namespace axiometry::iso230_2 {

/// How far a parameter may lie above its limit and still be at it, because binary arithmetic has moved it there
/// (base/decimal_tie.h). For use with at_most(): at_most(y, T, slack.of(parameter, y)).
struct ComparisonSlack {
  double means = 0.0;  ///< slack of E, E↑, E↓, M, B, B̄: far below the step in which these can differ from a limit
  double spreads = 0.0;  ///< slack of A, A↑, A↓, R, R↑, R↓, which hold roots

  /// For a value y of the parameter, all in its unit; of those with roots at most 1e-9 of the value.
  double of(const ParameterInfo& parameter, double y) const {
    const bool has_root = parameter.key.front() == 'A' || parameter.key.front() == 'R';
    return has_root ? std::min(spreads, 1e-9 * std::abs(y)) : means;
  }
};

inline ComparisonSlack comparison_slack(const Series& series) {
  DecimalReadings readings{series.target_count(), series.run_count(), 0.0};
  for (std::size_t i = 0; i < readings.targets; ++i)
    for (const Direction direction : {Direction::up, Direction::down})
      for (const double x : series.cell(i, direction))
        if (!std::isnan(x)) readings.magnitude = std::max(readings.magnitude, std::abs(x));
  return {rounding_of_means(readings), rounding_of_spreads(readings)};
}

}  // namespace axiometry::iso230_2
