// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/series/target_index.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace axiometry::formats {
namespace {

TEST(TargetIndex, NumbersAnySequenceOfTargetsAsASearchWould) {
  std::mt19937 random(3);
  TargetIndex index;
  for (int test = 0; test < 300; ++test) {
    std::vector<double> expected;
    const auto different = 1 + random() % (test % 3 == 0 ? 100 : 12);
    for (int k = 0; k < 400; ++k) {
      const double target =
          static_cast<double>(random() % 5 ? static_cast<std::size_t>(k) % different : random() % different) / 8 - 1;
      auto found = std::ranges::find(expected, target);
      if (found == expected.end()) found = expected.insert(expected.end(), target);
      ASSERT_EQ(index.number(target), found - expected.begin());
    }
    ASSERT_TRUE(std::ranges::equal(index.targets(), expected));
    const auto ranks = index.ranks();
    for (std::size_t i = 0; i < expected.size(); ++i)
      ASSERT_EQ(ranks[i], std::ranges::count_if(expected, [&](double t) { return t < expected[i]; }));
    index.restart();
  }
}

TEST(TargetIndex, TakesBothZerosAsOneTarget) {
  TargetIndex index;
  EXPECT_EQ(index.number(1.0), 0u);
  EXPECT_EQ(index.number(0.0), 1u);
  EXPECT_EQ(index.number(1.0), 0u);
  EXPECT_EQ(index.number(-0.0), 1u);
}

}  // namespace
}  // namespace axiometry::formats
