// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "axiometry/model/series.h"
#include "axiometry/standards/iso230_2/parameters.h"

namespace axiometry::compensation {

struct RetestTrials {
  std::uint64_t seed = 1;
  std::optional<std::size_t> runs{};  ///< how many runs the re-test has; as many as the test where nobody knows
};

/// What re-tests will show with the table active, if the axis stays as it is and scatters as it did.
struct ExpectedRetest {
  iso230_2::AxisParameters median;      ///< half of the re-tests show less
  iso230_2::AxisParameters percent_95;  ///< 95 % of them show less
  std::size_t trials = 0;
};

/// Trials of docs/theory/compensation.md: the table has in it what scatter did to the means of the test, and a re-test
/// scatters anew, so that its reading is r_i + s (z_i/√n_i + z_ij) with the mean r_i that is predicted and standard
/// normal z; where runs of the test differ as a whole or have slopes of their own, those of the re-test do so too, as
/// shifts and slopes of ↑ and ↓ went together in the test, and the table has the mean of the test's runs in it. s is
/// that of all targets of a direction together; of each target its own where they differ for sure. How little the
/// readings of one test tell about s counts: each trial draws s √(ν/χ²_ν). Nothing where no target has two readings in
/// a direction. The same test gives the same numbers.
std::optional<ExpectedRetest> expected_retest(const Series& predicted, RetestTrials trials = {});

}  // namespace axiometry::compensation
