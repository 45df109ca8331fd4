// SPDX-License-Identifier: Apache-2.0
//
// The examples of all manuals, damaged at random. Whatever a reader accepts must be evaluable by its invariants and
// survive being written and read; whatever it refuses must say what was found. Fuzzing does the same for hours.
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <random>

#include "axiometry/formats/format.h"
#include "tests/support/manual_example.h"
#include "tests/support/statistics_of_trials.h"

namespace axiometry::formats {
namespace {

void damage(std::string& text, std::mt19937& random) {
  const auto below = [&](std::size_t n) { return n == 0 ? 0 : random() % n; };
  constexpr std::string_view pieces[] = {"-", "0",  "9999999999", "1e308", ",",    ".",        "=", "\n",
                                         " ", "::", "|",          "nan",   "\xB5", "\xC4\xE3", "#", "*",
                                         "}", "{",  "[",          "1",     "\r",   "-0.0",     "\t"};
  const std::size_t at = below(text.size() + 1);
  switch (below(5)) {
    case 0: text.insert(at, pieces[below(std::size(pieces))]); break;
    case 1: text.erase(at, 1 + below(4)); break;
    case 2: text.resize(at); break;
    case 3: text.insert(below(text.size() + 1), text.substr(at, below(40))); break;
    default:
      if (at < text.size()) text[at] = static_cast<char>(below(256));
  }
}

void expect_survives(const Test& test) {
  const Format& json = *find_format("json");
  const auto again = json.read(json.write(test));
  ASSERT_TRUE(again) << again.error().to_string();
  ASSERT_EQ(again->series.reading_count(), test.series.reading_count());
  for (std::size_t i = 0; i < test.series.target_count(); ++i)
    for (Direction d : {Direction::up, Direction::down})
      for (std::size_t j = 0; j < test.series.run_count(); ++j)
        ASSERT_EQ(again->series.reading(i, d, j), test.series.reading(i, d, j));
  ASSERT_TRUE(test.times_s.empty() || test.times_s.size() == 2 * test.series.target_count() * test.series.run_count());
}

TEST(DamagedFiles, AreReadOrRefusedWithReasons) {
  for (const Format* format : format_table()) {
    const std::string example = testing_support::manual_example(format->manual);
    std::mt19937 random(20140501);
    std::size_t accepted = 0;
    const std::size_t rounds = testing_support::as_many(3000);
    for (std::size_t round = 0; round < rounds; ++round) {
      std::string text = example;
      for (std::uint32_t k = 0; k <= random() % 4; ++k) damage(text, random);
      const int score = format->recognise(text);
      ASSERT_TRUE(score >= 0 && score <= 100);
      const auto test = format->read(text);
      if (test) {
        ++accepted;
        ASSERT_NO_FATAL_FAILURE(expect_survives(*test)) << format->id << "\n" << text;
      } else {
        ASSERT_TRUE(test.error().message.starts_with("found ")) << format->id << ": " << test.error().message;
        ASSERT_TRUE(test.error().at.column == 0 || test.error().at.line > 0) << format->id << test.error().message;
      }
    }
    EXPECT_TRUE(100 * accepted > rounds || format->id == "ecmc-dat") << format->id;  // whose example is not whole
  }
}

}  // namespace
}  // namespace axiometry::formats
