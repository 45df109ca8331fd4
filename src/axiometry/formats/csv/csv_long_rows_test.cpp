// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/csv/csv_long_rows.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <random>

#include "tests/support/pieces.h"
#include "tests/support/statistics_of_trials.h"

namespace axiometry::formats {
namespace {

using testing_support::Pieces;

std::string described(const NamedTest& test) {
  std::string text = fmt::format("{} {}:", test.name, test.line);
  for (Position p : test.series.targets()) text += fmt::format(" {}", p.in_native());
  for (Direction d : {Direction::up, Direction::down})
    for (std::size_t i = 0; i < test.series.target_count(); ++i)
      for (double x : test.series.cell(i, d)) text += fmt::format(" {:x}", std::bit_cast<std::uint64_t>(x));
  return text + "\n";
}

/// All tests of a text, or what is wrong with it.
std::string by_rows(std::string_view text, LongRows::Path path) {
  auto preamble = read_preamble(text);
  const std::size_t begin = preamble->size;
  const auto layout = long_layout(*preamble);
  std::string result;
  LongRows rows(
      *std::move(preamble), *layout,
      [&](NamedTest&& test) -> Result<void> {
        result += described(test);
        return {};
      },
      path);
  if (auto done = rows.take(text.substr(begin), text.data() + text.size()); !done)
    return result + done.error().to_string();
  if (auto done = rows.finish(); !done) return result + done.error().to_string();
  return result;
}

std::string by_pieces(std::string_view text, std::size_t longest) {
  Pieces pieces(text, longest);
  std::string result;
  const auto done = find_format("csv-long")->read_many(pieces, [&](NamedTest&& test) -> Result<void> {
    result += described(test);
    return {};
  });
  return done ? result : result + done.error().to_string();
}

std::string many_tests(std::size_t count, char delimiter, char mark, std::string_view line_end) {
  std::mt19937 random(230);
  std::string text = fmt::format("test{0}target_mm{0}direction{0}run{0}deviation_um{1}", delimiter, line_end);
  for (std::size_t t = 0; t < count; ++t) {
    const std::size_t targets = 2 + random() % 12;
    for (int run = 1; run <= 3; ++run)
      for (int d = 0; d < 2; ++d)
        for (std::size_t i = 0; i < targets; ++i) {
          std::string row = fmt::format("S{0}|{1:.3f}|{2}|{3}|{4:.{5}f}", t, 10.5 * static_cast<double>(i) - 20,
                                        d == 0 ? "up" : "down", run,
                                        static_cast<double>(random() % 100000) / 1024.0 - 48.0, random() % 12);
          std::ranges::replace(row, '.', mark);
          std::ranges::replace(row, '|', delimiter);
          text += row + std::string(line_end);
        }
  }
  return text;
}

TEST(CsvLongRows, ReadPlainRowsAsTheyReadAllOthers) {
  for (const auto& text :
       {many_tests(60, ',', '.', "\n"), many_tests(60, ';', ',', "\r\n"), many_tests(60, '\t', '.', "\n")})
    EXPECT_EQ(by_rows(text, LongRows::Path::fast), by_rows(text, LongRows::Path::general_only));
}

TEST(CsvLongRows, AgreeOnDamagedTextToo) {
  const std::string whole = many_tests(3, ',', '.', "\n");
  std::mt19937 random(7);
  constexpr std::string_view bytes = "0123456789.,-+eE \t\n\r\"#;updown\xB5";
  for (int trial = 0; trial < 3000; ++trial) {
    std::string text = whole;
    const std::size_t header = text.find('\n') + 1;
    for (auto damage = 1 + random() % 3; damage > 0; --damage)
      text[header + random() % (text.size() - header)] = bytes[random() % bytes.size()];
    ASSERT_EQ(by_rows(text, LongRows::Path::fast), by_rows(text, LongRows::Path::general_only)) << text;
  }
}

TEST(CsvLongRows, CountApproachesThemselvesWhereRunsAreNotNumbered) {
  const std::string numbered =
      "test,target_mm,direction,run,deviation_um\nA,0,up,1,1\nA,9,up,1,2\nA,9,down,1,3\nA,0,up,2,4\nA,9,up,2,-\n"
      "A,9,up,3,5\nB,0,up,1,6\nB,9,up,1,7\nB,0,up,2,8\n";
  std::string counted =
      "test,target_mm,direction,deviation_um\nA,0,up,1\nA,9,up,2\nA,9,down,3\nA,0,up,4\nA,9,up,-\n"
      "A,9,up,5\nB,0,up,6\nB,9,up,7\nB,0,up,8\n" +
      std::string(200, '\n');
  const std::string expected = by_rows(numbered, LongRows::Path::general_only);
  EXPECT_EQ(by_rows(counted, LongRows::Path::general_only), expected);
  EXPECT_EQ(by_rows(counted, LongRows::Path::fast), expected);
}

TEST(CsvLongRows, DoNotDependOnHowTheFileIsCutIntoPieces) {
  const std::string text = "# axis: X\n" + many_tests(40, ',', '.', "\n");
  const std::string expected = by_rows(text, LongRows::Path::general_only);
  for (std::size_t longest : {1u, 7u, 4096u, 100000000u}) EXPECT_EQ(by_pieces(text, longest), expected) << longest;
  EXPECT_EQ(by_pieces(text.substr(0, text.size() - 1), 1000), expected);
}

TEST(CsvLongRows, ReadFilesLargerThanTheirBuffer) {
  const std::string text = many_tests(2000, ',', '.', "\n");
  ASSERT_GT(text.size(), std::size_t{1} << 20);
  EXPECT_EQ(by_pieces(text, 65536), by_rows(text, LongRows::Path::general_only));
}

TEST(CsvLongRows, DoNotReadOnBehindALastLineWithoutLineBreak) {
  // The buffer still holds what stood there before; every cut of a long file must end where it was cut.
  const std::string text = many_tests(700, ',', '.', "\n");
  const std::size_t row = text.rfind('\n', text.size() - 2) + 1;
  constexpr std::size_t step = testing_support::is_watched ? 5 : 1;
  for (std::size_t size = row; size <= text.size(); size += step) {
    const std::string_view cut = std::string_view(text).substr(0, size);
    ASSERT_EQ(by_pieces(cut, 100000), by_rows(cut, LongRows::Path::general_only)) << size;
  }
}

TEST(CsvLongRows, ReadRowsThatRepeatTheTestBeforeInPartOnly) {
  const std::string header = "test,target_mm,direction,run,deviation_um\n";
  const std::string a = "A,0,up,1,1\nA,9.5,up,1,1\nA,9.5,down,1,2\nA,0,down,1,3\n";
  const std::string b = "B,0,up,1,1.5\nB,9.25,up,1,-1\nB,9.25,down,1,2\nB,0,down,2,+3\nB,0,down,1,4\n";
  const std::string c = "C,0,up,1,1e1\nC,9.5,up,1,1\r\nC,9.5,down,1,2\n";
  for (const std::string& text : {header + a + b + c, header + b + a + c, header + c + a + b})
    EXPECT_EQ(by_rows(text + std::string(200, '\n'), LongRows::Path::fast),
              by_rows(text, LongRows::Path::general_only));
}

TEST(CsvLongRows, RefuseATestThatComesBackAndNameBothLines) {
  const std::string header = "test,target_mm,direction,run,deviation_um\n";
  const std::string a = "A,0,up,1,1\nA,9,up,1,1\n";
  const std::string b = "B,0,up,1,1\nB,9,up,1,1\n";
  EXPECT_THAT(by_pieces(header + a + b + a, 5),
              testing::EndsWith(
                  "line 6:1: found the test \"A\" again, expected its rows to stand together; it began on line 2"));
}

TEST(CsvLongRows, RefuseALineWithoutEnd) {
  const std::string text = "test,target_mm,direction,run,deviation_um\n" + std::string(std::size_t{1} << 20, '1');
  EXPECT_EQ(by_pieces(text, 4096), "found a line of more than 256 KiB, expected shorter ones");
}

TEST(CsvLongRows, PassOnTheErrorOfWhoeverTakesTheTests) {
  const std::string text = many_tests(3, ',', '.', "\n");
  Pieces pieces(text, 1000);
  const auto done =
      find_format("csv-long")->read_many(pieces, [](NamedTest&&) -> Result<void> { return fail("enough"); });
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().message, "enough");
}

TEST(CsvLongRows, AreForFilesWithATestColumn) {
  const Format& format = *find_format("csv-long");
  EXPECT_TRUE(format.holds_many("test,target_mm,direction,run,deviation_um\n"));
  EXPECT_FALSE(format.holds_many("target_mm,direction,run,deviation_um\n"));
}

}  // namespace
}  // namespace axiometry::formats
