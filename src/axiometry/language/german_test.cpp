// SPDX-License-Identifier: Apache-2.0
//
// The phrase book of German as a whole: that its rows are sound.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <span>

#include "axiometry/language/german.h"
#include "axiometry/language/language.h"
#include "axiometry/language/words.h"

namespace axiometry::language {
namespace {

std::multiset<char> places(std::string_view text) {
  std::multiset<char> all;
  for (std::size_t at = text.find('{'); at != std::string_view::npos; at = text.find('{', at + 1))
    all.insert(text[at + 1]);
  return all;
}

TEST(German, HasSortedTables) {
  for (const auto table : german_tables())
    for (std::size_t k = 1; k < table.size(); ++k) EXPECT_LT(table[k - 1].english, table[k].english);
}

TEST(German, SaysEveryPhraseOnce) {
  std::set<std::string_view> seen;
  for (const Phrase* phrase : phrases(Language::german))
    EXPECT_TRUE(seen.insert(phrase->english).second) << phrase->english;
}

TEST(German, HasThePlacesOfTheEnglish) {
  for (const Phrase* phrase : phrases(Language::german)) {
    const auto english = places(phrase->english);
    EXPECT_EQ(english, places(phrase->other)) << phrase->english;
    EXPECT_EQ(std::set<char>(english.begin(), english.end()).size(), english.size()) << phrase->english;
  }
}

TEST(German, EndsAsTheEnglishDoes) {
  for (const Phrase* phrase : phrases(Language::german)) {
    EXPECT_FALSE(phrase->other.empty()) << phrase->english;
    const bool is_abbreviation = !phrase->english.contains(' ');
    if (!is_abbreviation) EXPECT_EQ(phrase->english.ends_with('.'), phrase->other.ends_with('.')) << phrase->english;
    EXPECT_FALSE(phrase->other.starts_with(' ') || phrase->other.ends_with(' ')) << phrase->english;
  }
}

/// A text as a person would meet it: something plausible at each place.
TEST(German, FindsEachOfItsPhrases) {
  for (const Phrase* phrase : phrases(Language::german)) {
    std::string text;
    for (std::size_t k = 0; k < phrase->english.size(); ++k) {
      if (phrase->english[k] != '{') {
        text += phrase->english[k];
        continue;
      }
      text += "7";
      k = phrase->english.find('}', k);
    }
    EXPECT_TRUE(is_known(text, Language::german)) << text;
    EXPECT_FALSE(translated(text, Language::german).contains('{')) << text;
  }
}

}  // namespace
}  // namespace axiometry::language
