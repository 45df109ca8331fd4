// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/csv/test_names.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

namespace axiometry::formats {
namespace {

TEST(TestNames, TakeOneEntryForNamesThatCountUp) {
  TestNames names;
  for (std::size_t k = 0; k < 100000; ++k) ASSERT_FALSE(names.add(fmt::format("T{:06}", k + 1), 2 + 110 * k));
  EXPECT_LE(names.entry_count(), 2u);  // T100000 has no zero in front
  EXPECT_EQ(names.add("T000001", 99999999), 2u);
  EXPECT_EQ(names.add("T054321", 99999999), 2u + 110 * 54320);
  EXPECT_EQ(names.add("T100000", 99999999), 2u + 110 * 99999);
}

TEST(TestNames, TellNumbersWithZerosInFrontFromThoseWithout) {
  TestNames names;
  EXPECT_FALSE(names.add("T7", 2));
  EXPECT_FALSE(names.add("T07", 3));
  EXPECT_FALSE(names.add("T007", 4));
  EXPECT_FALSE(names.add("7", 5));
  EXPECT_FALSE(names.add("T", 6));
  EXPECT_FALSE(names.add("T0", 7));
  EXPECT_FALSE(names.add("T99999999999999999999", 8));
  EXPECT_EQ(names.add("T07", 9), 3u);
  EXPECT_EQ(names.add("T99999999999999999999", 10), 8u);
}

TEST(TestNames, AreExactForAnyOrderOfNames) {
  std::mt19937 random(1);
  TestNames names;
  std::map<std::string, std::size_t> all;
  for (std::size_t line = 1; line < 20000; ++line) {
    const unsigned choice = random() % 4;
    const std::string name = choice == 0   ? fmt::format("A{}", random() % 3000)
                             : choice == 1 ? fmt::format("A{:04}", random() % 3000)
                             : choice == 2 ? fmt::format("A{}", line)
                                           : fmt::format("{:x}", random() % 5000);
    const auto [entry, is_new] = all.try_emplace(name, line);
    const auto before = names.add(name, line);
    ASSERT_EQ(before.has_value(), !is_new) << name;
    ASSERT_EQ(before.value_or(entry->second), entry->second) << name;
  }
}

}  // namespace
}  // namespace axiometry::formats
