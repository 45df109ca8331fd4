// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/devices/camonitor_codes.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace axiometry::formats {
namespace {

/// Codes of a whole test, with cycles and targets of the given widths.
std::vector<std::string> codes_of(std::size_t cycles, std::size_t targets, int cycle_digits, int target_digits) {
  std::vector<std::string> codes;
  for (std::size_t c = 1; c <= cycles; ++c)
    for (int d : {1, 2})
      for (std::size_t p = 1; p <= targets; ++p)
        codes.push_back(fmt::format("{}{:0{}}{:0{}}", d, c, cycle_digits, p, target_digits));
  return codes;
}

struct Grid {
  std::size_t cycles;
  std::size_t targets;
  int cycle_digits;
  int target_digits;
};

class WholeTests : public testing::TestWithParam<Grid> {};

TEST_P(WholeTests, AreUnderstoodHoweverManyDigitsTheirPartsHave) {
  const auto [cycles, targets, cycle_digits, target_digits] = GetParam();
  const std::vector<std::string> codes = codes_of(cycles, targets, cycle_digits, target_digits);
  const auto meanings = test_codes(std::vector<std::string_view>(codes.begin(), codes.end()));
  ASSERT_TRUE(meanings) << meanings.error().to_string();
  std::size_t k = 0;
  for (std::size_t c = 1; c <= cycles; ++c)
    for (Direction d : {Direction::up, Direction::down})
      for (std::size_t p = 1; p <= targets; ++p, ++k) {
        EXPECT_EQ((*meanings)[k].cycle, c) << codes[k];
        EXPECT_EQ((*meanings)[k].target, p) << codes[k];
        EXPECT_EQ((*meanings)[k].direction, d) << codes[k];
      }
}

// The scripts write direction, cycle, a zero and the target, cycle and target as wide as their largest.
INSTANTIATE_TEST_SUITE_P(Codes, WholeTests,
                         testing::Values(Grid{5, 8, 1, 2}, Grid{5, 11, 1, 3}, Grid{10, 8, 2, 2}, Grid{10, 21, 2, 3},
                                         Grid{1, 2, 1, 2}, Grid{3, 120, 1, 4}, Grid{5, 5, 1, 1}));

TEST(TestCodes, AreNumbersThatBeginWithADirection) {
  EXPECT_TRUE(is_test_code("1101"));
  EXPECT_TRUE(is_test_code("25011"));
  for (const char* other : {"0", "11", "3101", "1101.5", "-1101", "", "1x01", "1234567890"})
    EXPECT_FALSE(is_test_code(other)) << other;
}

TEST(TestCodes, AreRefusedWhenTheyFormNoGrid) {
  const std::vector<std::string_view> lengths = {"1101", "11002"};
  EXPECT_EQ(test_codes(lengths).error().message,
            "found the test numbers 1101 and 11002, expected all with as many digits");
  const std::vector<std::string_view> zeros = {"1000", "1001"};
  EXPECT_EQ(test_codes(zeros).error().message,
            "found test numbers such as 1000, expected direction (1 or 2), cycle and target from 1");
}

}  // namespace
}  // namespace axiometry::formats
