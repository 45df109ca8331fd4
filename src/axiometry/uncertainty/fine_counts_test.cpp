// SPDX-License-Identifier: Apache-2.0
#include "axiometry/uncertainty/fine_counts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "axiometry/numeric/moments.h"
#include "axiometry/numeric/random/random.h"

namespace axiometry::uncertainty {
namespace {

/// Normal values about 5, and some far outside of the core.
std::vector<double> some_values(std::size_t count) {
  std::vector<double> values(count);
  numeric::fill_normal({7, 0, count}, values);
  for (std::size_t i = 0; i < count; ++i) values[i] = 5.0 + (i % 97 == 13 ? 30.0 : 1.0) * values[i];
  return values;
}

CoreLayout some_layout() {
  std::vector<double> first(10'000);
  numeric::fill_normal({7, 1, 0}, first);
  for (double& x : first) x += 5.0;
  return CoreLayout::from_first(first, 0.95);
}

void expect_same(const ValueMoments& a, const ValueMoments& b) {
  EXPECT_EQ(a.count, b.count);
  EXPECT_EQ(a.mean, b.mean);
  EXPECT_EQ(a.squares, b.squares);
  EXPECT_EQ(a.min, b.min);
  EXPECT_EQ(a.max, b.max);
}

TEST(ValueMoments, AreThoseOfTwoPassesAndTheSameOnEveryTarget) {
  for (std::size_t count : {1u, 2u, 15u, 16u, 17u, 511u, 512u, 529u, 10'000u}) {
    const std::vector<double> values = some_values(count);
    const numeric::Moments expected = numeric::moments(values);
    const ValueMoments plain = ValueMoments::of(values, 5.1, numeric::VectorTarget::plain);
    EXPECT_NEAR(plain.mean, expected.mean, 1e-13) << count;
    EXPECT_NEAR(plain.sd(), count < 2 ? 0.0 : expected.standard_deviation, 1e-12) << count;
    EXPECT_EQ(plain.min, std::ranges::min(values));
    EXPECT_EQ(plain.max, std::ranges::max(values));
    for (numeric::VectorTarget target : numeric::available_vector_targets()) {
      SCOPED_TRACE(std::to_string(count) + ' ' + std::string(vector_target_name(target)));
      expect_same(ValueMoments::of(values, 5.1, target), plain);
    }
  }
}

TEST(FineCounts, PutsEveryValueIntoItsCellOnEveryTarget) {
  const CoreLayout layout = some_layout();
  for (std::size_t count : {1u, 15u, 16u, 31u, 513u, 10'000u}) {
    std::vector<double> values = some_values(count);
    for (numeric::VectorTarget target : numeric::available_vector_targets()) {
      SCOPED_TRACE(std::to_string(count) + ' ' + std::string(vector_target_name(target)));
      FineCounts counts(layout);
      const ValueMoments moments = counts.add(values, target);
      expect_same(moments, ValueMoments::of(values, layout.near_mean));
      const SampledDistribution distribution = counts.distribution({moments.min, moments.max});
      ASSERT_EQ(distribution.trials(), count);
      std::ranges::sort(values);
      const double slack = 1e-9 * layout.cell;  // of a value on an edge
      for (const SampledDistribution::Cell& cell : distribution.cells()) {
        const auto first = values.begin() + static_cast<std::ptrdiff_t>(cell.below);
        EXPECT_GE(*first, cell.lower - slack);
        EXPECT_LE(*(first + static_cast<std::ptrdiff_t>(cell.count) - 1), cell.upper + slack);
      }
    }
  }
}

TEST(FineCounts, LosesNoValueOnTheEdgesOfItsCore) {
  const CoreLayout layout{-8.0, 1.0 / 1024, 1024.0, 0.0};
  const double end = layout.edge(CoreLayout::cell_count);
  std::vector<double> values;
  for (double edge : {layout.lower, layout.edge(1), end - layout.cell, end})
    for (double x : {std::nextafter(edge, -100.0), edge, std::nextafter(edge, 100.0)}) values.push_back(x);
  for (numeric::VectorTarget target : numeric::available_vector_targets()) {
    FineCounts counts(layout);
    counts.add(values, target);
    const SampledDistribution distribution = counts.distribution({values.front(), values.back()});
    EXPECT_EQ(distribution.trials(), values.size()) << vector_target_name(target);
    EXPECT_EQ(distribution.quantile(0.0), values.front());
    EXPECT_EQ(distribution.quantile(1.0), values.back());
  }
}

TEST(FineCounts, TellsByItsMomentsThatAValueIsNotFinite) {
  const CoreLayout layout = some_layout();
  for (double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), -1e200})
    for (std::size_t at : {3u, 600u, 1000u})
      for (numeric::VectorTarget target : numeric::available_vector_targets()) {
        std::vector<double> values = some_values(1001);
        values[at] = bad;
        FineCounts counts(layout);
        EXPECT_FALSE(std::isfinite(counts.add(values, target).squares)) << bad << ' ' << at;
      }
}

}  // namespace
}  // namespace axiometry::uncertainty
