// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/document.h"
#include "axiometry/report/drawing/utf8.h"

#include <gtest/gtest.h>

namespace axiometry::report {
namespace {

bool operator==(const TextRun& a, const TextRun& b) {
  return a.text == b.text && a.italic == b.italic && a.bold == b.bold && a.bar == b.bar && a.script == b.script;
}

void expect_runs(const RichText& text, const RichText& expected) {
  ASSERT_EQ(text.size(), expected.size()) << plain_text(text);
  for (std::size_t k = 0; k < text.size(); ++k) EXPECT_TRUE(text[k] == expected[k]) << k << ": " << text[k].text;
}

TEST(Symbol, SetsLettersInItalicsAndArrowsUpright) {
  expect_runs(symbol("A↑"), {{.text = "A", .italic = true}, {.text = "↑"}});
}

TEST(Symbol, PutsABarOverTheLetterBeforeTheMacron) {
  expect_runs(symbol("B̄"), {{.text = "B", .italic = true, .bar = true}});
}

TEST(Symbol, SetsACountingIndexLowAndTheArrowAfterItOnTheLine) {
  expect_runs(symbol("x̄_i↑"), {{.text = "x", .italic = true, .bar = true},
                               {.text = "i", .italic = true, .script = Script::sub},
                               {.text = "↑"}});
}

TEST(Symbol, SetsANamingIndexUpright) {
  expect_runs(symbol("U_M,DEVICE"), {{.text = "U", .italic = true}, {.text = "M,DEVICE", .script = Script::sub}});
}

TEST(Symbol, SetsAnIndexThatIsAWordCutShortUpright) {
  expect_runs(symbol("p_c"), {{.text = "p", .italic = true}, {.text = "c", .script = Script::sub}});
  expect_runs(symbol("ν_eff"), {{.text = "ν", .italic = true}, {.text = "eff", .script = Script::sub}});
}

TEST(Symbol, TakesAnyBytes) {
  EXPECT_EQ(plain_text(symbol("")), "");
  EXPECT_EQ(plain_text(symbol("_")), "");
  EXPECT_EQ(plain_text(symbol("x_")), "x");
  EXPECT_EQ(plain_text(symbol("\xff\xc3")), "\xff\xc3");
}

TEST(Prose, TypesetsSymbolsAndLeavesNamesAlone) {
  const RichText text = prose("U_M,DEVICE, like machine_name (U_EVE).");
  expect_runs(text, {{.text = ""},
                     {.text = "U", .italic = true},
                     {.text = "M,DEVICE", .script = Script::sub},
                     {.text = ", like machine_name ("},
                     {.text = "U", .italic = true},
                     {.text = "EVE", .script = Script::sub},
                     {.text = ")."}});
}

TEST(Sentence, BeginsLargeAndEndsWithAStop) {
  EXPECT_EQ(plain_text(sentence("found 4 runs, expected 5")), "Found 4 runs, expected 5.");
  EXPECT_EQ(plain_text(sentence("Already one.")), "Already one.");
  EXPECT_EQ(plain_text(sentence("s is too small")), "s is too small.");
  EXPECT_EQ(plain_text(sentence("a gain of 1.1 of the sensor")), "A gain of 1.1 of the sensor.");
  EXPECT_EQ(plain_text(sentence("a = 3")), "a = 3.");
  EXPECT_EQ(plain_text(sentence("")), "");
}

TEST(FractionLength, CountsFromTheDecimalMark) {
  EXPECT_EQ(fraction_length("9.6"), 2u);
  EXPECT_EQ(fraction_length("\u22124,12"), 3u);
  EXPECT_EQ(fraction_length("14"), 0u);
  EXPECT_EQ(fraction_length("not applicable"), 0u);
  EXPECT_FALSE(is_number("–"));
  EXPECT_FALSE(is_number(""));
}

TEST(Cleaned, ReplacesWhatNoTextMayHold) {
  EXPECT_EQ(cleaned("a\x01"
                    "b\xff"
                    "c\n"),
            "a\uFFFD"
            "b\uFFFD"
            "c\n");
  EXPECT_EQ(cleaned("立式"), "立式");
}

}  // namespace
}  // namespace axiometry::report
