// SPDX-License-Identifier: Apache-2.0
#include "axiometry/numeric/leave_one_out.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

namespace axiometry::numeric {
namespace {

double plain_median(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

double plain_deviation(const std::vector<double>& values) {
  long double mean = 0, squares = 0;
  for (const double x : values) mean += x / static_cast<long double>(values.size());
  for (const double x : values) squares += (x - mean) * (x - mean);
  return static_cast<double>(std::sqrt(squares / static_cast<long double>(values.size() - 1)));
}

/// Of equal distances the later value: the one above the median.
std::vector<double> without_farthest(std::vector<double> values) {
  const double median = plain_median(values);
  std::ranges::sort(values);
  const bool lowest = median - values.front() > values.back() - median;
  values.erase(lowest ? values.begin() : values.end() - 1);
  return values;
}

void expect_as_plain(const std::vector<double>& values) {
  const LeaveOneOut all(values);
  for (std::size_t k = 0; k < values.size(); ++k) {
    std::vector<double> others = values;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(k));
    EXPECT_EQ(all.median_without(k), plain_median(others));
    if (others.size() < 2) continue;
    const double deviation = plain_deviation(others);
    EXPECT_NEAR(all.deviation_without(k), deviation, 1e-9 * deviation);
    if (others.size() < 3) continue;
    const double but_for_one = plain_deviation(without_farthest(others));
    EXPECT_NEAR(all.deviation_but_for_farthest(k), but_for_one, 1e-9 * but_for_one);
  }
}

TEST(LeaveOneOut, IsWhatTheOthersAloneHave) {
  expect_as_plain({1.0, 2.0});
  expect_as_plain({0.0, 1.0, 1e6, 1e6 + 1e-3});
  expect_as_plain({3.0, 3.0, 3.0, 3.0, 3.0});
  expect_as_plain({-1e9, 0.1, 0.2, 0.3, 1e9, 0.25});
}

RC_GTEST_PROP(LeaveOneOut, IsWhatTheOthersAloneHaveOfAnySample, ()) {
  const auto count = *rc::gen::inRange(2, 40);
  const auto whole = *rc::gen::container<std::vector<int>>(static_cast<std::size_t>(count), rc::gen::inRange(-50, 51));
  std::vector<double> values;
  for (const int x : whole) values.push_back(0.1 * x + (x % 17 == 0 ? 1e5 : 0.0));
  expect_as_plain(values);
}

}  // namespace
}  // namespace axiometry::numeric
