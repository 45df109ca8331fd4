// SPDX-License-Identifier: Apache-2.0
#include "axiometry/base/text/text.h"

#include <gtest/gtest.h>

#include "axiometry/base/read_budget.h"
#include "axiometry/base/text/number_text.h"

namespace axiometry {
namespace {

TEST(Text, FindsTheFirstByteThatIsNotUtf8) {
  EXPECT_EQ(text::invalid_utf8("µm ″ 𝛼"), std::nullopt);
  EXPECT_EQ(text::invalid_utf8("a\xB5m"), 1u);            // Latin-1
  EXPECT_EQ(text::invalid_utf8("\xC0\x80"), 0u);          // overlong
  EXPECT_EQ(text::invalid_utf8("\xED\xA0\x80"), 0u);      // surrogate
  EXPECT_EQ(text::invalid_utf8("ab\xE2\x80"), 2u);        // cut off
  EXPECT_EQ(text::invalid_utf8("\xF4\x90\x80\x80"), 0u);  // beyond U+10FFFF
}

TEST(Text, QuotesWhatCannotBePrinted) {
  EXPECT_EQ(text::quoted("a\tb"), "\"a\\x09b\"");
  EXPECT_EQ(text::quoted("\xB5m"), "\"\\xB5m\"");
  EXPECT_EQ(text::quoted("µm"), "\"µm\"");
  EXPECT_EQ(text::quoted(std::string(50, 'x')), "\"" + std::string(40, 'x') + "…\"");
}

TEST(Text, SplitsTrimsAndCompares) {
  EXPECT_EQ(text::split("a||b", '|'), (std::vector<std::string_view>{"a", "", "b"}));
  EXPECT_EQ(text::words("  a\tb "), (std::vector<std::string_view>{"a", "b"}));
  EXPECT_EQ(text::trim(" \t x \r\n"), "x");
  EXPECT_TRUE(text::equal_ignoring_case("Up", "uP"));
}

TEST(Text, NamesTheNearestWordAndNoFarOne) {
  const std::vector<std::string_view> keys = {"machine.name", "machine.type"};
  EXPECT_EQ(text::nearest("machin.name", keys), "machine.name");
  EXPECT_EQ(text::nearest("zzz", keys), std::nullopt);
  EXPECT_EQ(text::nearest("mymachine.namexx", {"machine.name"}), "machine.name") << "four letters more";
  EXPECT_EQ(text::nearest(std::string(50'000'000, 'a'), keys), std::nullopt) << "at once";
}

std::size_t letters_changed(std::string_view a, std::string_view b) {
  if (a.empty() || b.empty()) return a.size() + b.size();
  const std::size_t last = letters_changed(a.substr(1), b.substr(1)) + (a[0] != b[0]);
  return std::min({last, letters_changed(a.substr(1), b) + 1, letters_changed(a, b.substr(1)) + 1});
}

TEST(Text, NamesTheWordOfWhichTheFewestLettersChange) {
  std::uint32_t chance = 1;
  const auto drawn = [&] {
    std::string word;
    for (std::size_t k = 0, length = (chance = chance * 1664525 + 1013904223) >> 24; k < 1 + length % 6; ++k)
      word += static_cast<char>('a' + ((chance = chance * 1664525 + 1013904223) >> 24) % 3);
    return word;
  };
  for (int k = 0; k < 300; ++k) {
    const std::string word = drawn(), first = drawn(), second = drawn();
    const std::size_t to_first = letters_changed(word, first), to_second = letters_changed(word, second);
    const std::size_t fewest = std::min(to_first, to_second);
    const auto near = text::nearest(word, {first, second});
    if (fewest > word.size() / 3)
      EXPECT_EQ(near, std::nullopt) << word << ' ' << first << ' ' << second;
    else
      EXPECT_EQ(near, to_first == fewest ? first : second) << word << ' ' << first << ' ' << second;
  }
}

TEST(Text, TakesNoEndlessWordForATypingError) {
  const std::string longest(read_budget::name_bytes, 'a');
  EXPECT_EQ(text::nearest(longest, {longest}), longest);
  EXPECT_EQ(text::nearest(longest + 'a', {longest, longest + 'a'}), std::nullopt);
  EXPECT_EQ(text::nearest("machine", {std::string(1 << 20, 'm'), "machine.name", "machines"}), "machines");
}

TEST(NumberText, ReadsWholeNumbersOfAnyUsualSpelling) {
  EXPECT_EQ(parse_number("-4.1"), -4.1);
  EXPECT_EQ(parse_number("+.0016"), 0.0016);
  EXPECT_EQ(parse_number("3e-2"), 0.03);
  for (const char* bad : {"", "+", "-", "+-1", "1,5", "1 ", "nan", "inf", "1e999", "0x10", "1e"})
    EXPECT_EQ(parse_number(bad), std::nullopt) << bad;
}

TEST(NumberText, ShowsATrueMinusAndNoNegativeZero) {
  EXPECT_EQ(format_fixed(-1.25, 1), "\u22121.2");
  EXPECT_EQ(format_fixed(-0.04, 1), "0.0");
  EXPECT_EQ(format_fixed(1234.5, 2, {','}), "1234,50");
  EXPECT_EQ(format_shortest(-353.834), "\u2212353.834");
  EXPECT_EQ(format_shortest(-0.0), "0");
  EXPECT_EQ(format_shortest(0.1), "0.1");
}

TEST(NumberText, PutsUncertaintyToSignificantDigits) {
  EXPECT_EQ(decimals_for(4.2706, 2), 1);
  EXPECT_EQ(decimals_for(14.4, 2), 0);
  EXPECT_EQ(decimals_for(0.0234, 2), 3);
  EXPECT_EQ(decimals_for(0.0996, 2), 2);  // shown as 0.10
  EXPECT_EQ(decimals_for(9.96, 2), 0);    // shown as 10
  EXPECT_EQ(decimals_for(0.0, 2), 0);
  EXPECT_EQ(decimals_for(4271.0, 2), -2);
  EXPECT_EQ(decimals_for(9960.0, 2), -3);  // shown as 10000
  EXPECT_EQ(format_fixed(4271.0, -2), "4300");
  EXPECT_EQ(format_fixed(-49.0, -2), "0");
  EXPECT_EQ(format_fixed(-9586.4, -2), "\u22129600");
}

TEST(Text, MakesCellsThatASpreadsheetReadsBackAndDoesNotRun) {
  EXPECT_EQ(text::csv_cell("a;b"), "a;b");
  EXPECT_EQ(text::csv_cell("a;b", ';'), "\"a;b\"");
  EXPECT_EQ(text::csv_cell("say \"a\"\n"), "\"say \"\"a\"\"\n\"");
  EXPECT_EQ(text::no_formula("=1+2"), "'=1+2");
  EXPECT_EQ(text::no_formula("-"), "-");
  EXPECT_EQ(text::no_formula("X"), "X");
  EXPECT_EQ(text::no_formula("@SUM(A1)"), "'@SUM(A1)");
  EXPECT_EQ(text::no_formula("\t=1"), "'\t'=1");
}

TEST(NoFormula, SeesWhatASpreadsheetOfAnotherCountryWouldTakeForACell) {
  EXPECT_EQ(text::no_formula("mill;=cmd|' /C calc'!A0"), "mill;'=cmd|' /C calc'!A0");
  EXPECT_EQ(text::no_formula("a, =1+2"), "a, '=1+2");
  EXPECT_EQ(text::no_formula("a\t@x\n+y"), "a\t'@x\n'+y");
  EXPECT_EQ(text::no_formula("a,\"-x\""), "a,\"'-x\"");
  EXPECT_EQ(text::no_formula("a, -0.5; +3"), "a, '-0.5; +3") << "separated by commas";
  for (const char* harmless : {"a, -0.5, +3,-1e-3", "a; -0.5; +3", "x = y; 2 + 2", "a-b,c", "=", "", "5;-"})
    EXPECT_EQ(text::no_formula(harmless), harmless);
}

}  // namespace
}  // namespace axiometry
