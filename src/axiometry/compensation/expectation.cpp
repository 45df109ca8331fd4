// SPDX-License-Identifier: Apache-2.0
#include "axiometry/compensation/expectation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "axiometry/compensation/retest_model.h"
#include "axiometry/standards/readings/runs_made.h"

namespace axiometry::compensation {
namespace {

constexpr std::size_t trials_most = 1000, trials_least = 40;
constexpr std::size_t readings_most = 10'000'000;  // of all trials, what a second can do

/// The value that this share of the trials lies below.
double quantile(std::vector<double>& values, double share) {
  const auto at = static_cast<std::ptrdiff_t>(std::ceil(share * static_cast<double>(values.size()))) - 1;
  std::ranges::nth_element(values, values.begin() + at);
  return values[static_cast<std::size_t>(at)];
}

}  // namespace

std::optional<ExpectedRetest> expected_retest(const Series& predicted, RetestTrials of_retest) {
  // A number without readings is no run that was not shifted.
  const auto model = retest::RetestModel::of(without_empty_runs(predicted), of_retest.runs);
  if (!model) return std::nullopt;
  ExpectedRetest expected;
  expected.trials = std::clamp(readings_most / model->numbers_each(), trials_least, trials_most);
  std::array<std::vector<double>, std::size(iso230_2::parameters)> values;
  for (std::size_t trial = 0; trial < expected.trials; ++trial) {
    const iso230_2::AxisParameters drawn = iso230_2::evaluate_axis(model->drawn(of_retest.seed, trial));
    for (std::size_t p = 0; p < values.size(); ++p)
      if (const auto& value = drawn.*iso230_2::parameters[p].member) values[p].push_back(value->in_native());
  }
  for (std::size_t p = 0; p < values.size(); ++p) {
    if (values[p].empty()) continue;
    const auto member = iso230_2::parameters[p].member;
    expected.median.*member = Deviation::native(quantile(values[p], 0.5));
    expected.percent_95.*member = Deviation::native(quantile(values[p], 0.95));
  }
  return expected;
}

}  // namespace axiometry::compensation
