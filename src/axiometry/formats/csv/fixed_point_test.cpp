// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/csv/fixed_point.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <charconv>
#include <cmath>
#include <random>
#include <string>

namespace axiometry::formats {
namespace {

struct Read {
  double value;
  std::size_t size;
};

Read fixed(std::string text, int mark = '.') {
  const std::size_t size = text.size();
  text += ",";
  text.resize(text.size() + fixed_point_reach, ' ');
  const FixedPoint number = read_fixed_point(text.data(), mark);
  return {number.value,
          number.end ? std::min<std::size_t>(static_cast<std::size_t>(number.end - text.data()), size) : 0};
}

TEST(FixedPoint, IsBitForBitWhatFromCharsGives) {
  std::mt19937_64 random(230);
  for (int trial = 0; trial < 300000; ++trial) {
    const int digits = 1 + static_cast<int>(random() % 15);
    const int decimals = static_cast<int>(random() % static_cast<unsigned>(digits + 1));
    std::string text;
    for (int k = 0; k < digits; ++k) {
      if (k == digits - decimals && decimals > 0) text += '.';
      text += static_cast<char>('0' + random() % 10);
    }
    if (random() % 2) text.insert(0, "-");
    double expected = 0.0;
    std::from_chars(text.data(), text.data() + text.size(), expected);
    const Read read = fixed(text);
    ASSERT_EQ(read.size, text.size()) << text;
    ASSERT_EQ(std::bit_cast<std::uint64_t>(read.value), std::bit_cast<std::uint64_t>(expected)) << text;
  }
}

TEST(FixedPoint, KeepsTheSignOfZero) { EXPECT_TRUE(std::signbit(fixed("-0.0").value)); }

TEST(FixedPoint, LeavesWhatIsNotPlainToOthers) {
  for (const char* text : {"", "-", ".", "-.", "1234567890123456", "0.1234567890123456", "+1", "x"})
    EXPECT_EQ(fixed(text).size, 0u) << text;
}

TEST(FixedPoint, EndsWhereTheNumberEnds) {
  EXPECT_EQ(fixed("1e5").size, 1u);
  EXPECT_EQ(fixed("1.5.2").size, 3u);
  EXPECT_EQ(fixed("12345678.87654321").size, 0u);
  EXPECT_EQ(fixed("1234567.87654321").size, 16u);
}

TEST(FixedPoint, KnowsTheDecimalMarkOfTheFile) {
  EXPECT_EQ(fixed("1,5", ',').value, 1.5);
  EXPECT_EQ(fixed("1.5", no_decimal_mark).size, 1u);
}

}  // namespace
}  // namespace axiometry::formats
