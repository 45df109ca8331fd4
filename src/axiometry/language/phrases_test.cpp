// SPDX-License-Identifier: Apache-2.0
//
// The phrase books of all languages: that their rows are sound, and that no language has rows that another lacks.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <span>
#include <string>

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

std::span<const Language> translated_languages() { return languages().subspan(1); }

std::set<std::string_view> english_texts(Language language) {
  std::set<std::string_view> all;
  for (const Phrase* phrase : phrases(language)) all.insert(phrase->english);
  return all;
}

TEST(German, HasSortedTables) {
  for (const auto table : german_tables())
    for (std::size_t k = 1; k < table.size(); ++k) EXPECT_LT(table[k - 1].english, table[k].english);
}

TEST(Phrases, BeginWithEnglishWhichNeedsNone) {
  ASSERT_GE(languages().size(), 3u);
  EXPECT_EQ(languages().front(), Language::english);
  EXPECT_TRUE(phrases(Language::english).empty());
}

TEST(Phrases, AreThereInEveryLanguageForTheSameTexts) {
  const auto wanted = english_texts(Language::german);
  ASSERT_GT(wanted.size(), 3000u);
  for (const Language language : translated_languages()) {
    const auto has = english_texts(language);
    for (const std::string_view text : wanted) EXPECT_TRUE(has.contains(text)) << tag(language) << " lacks: " << text;
    for (const std::string_view text : has)
      EXPECT_TRUE(wanted.contains(text)) << tag(language) << " alone has: " << text;
  }
}

TEST(Phrases, AreSaidOnce) {
  for (const Language language : translated_languages()) {
    std::set<std::string_view> seen;
    for (const Phrase* phrase : phrases(language))
      EXPECT_TRUE(seen.insert(phrase->english).second) << tag(language) << ": " << phrase->english;
  }
}

TEST(Phrases, HaveThePlacesOfTheEnglish) {
  for (const Language language : translated_languages())
    for (const Phrase* phrase : phrases(language)) {
      const auto english = places(phrase->english);
      EXPECT_EQ(english, places(phrase->other)) << tag(language) << ": " << phrase->english;
      EXPECT_EQ(std::set<char>(english.begin(), english.end()).size(), english.size()) << phrase->english;
    }
}

TEST(Phrases, EndAsTheEnglishDoes) {
  for (const Language language : translated_languages())
    for (const Phrase* phrase : phrases(language)) {
      EXPECT_FALSE(phrase->other.empty()) << phrase->english;
      const bool is_abbreviation = !phrase->english.contains(' ');
      if (!is_abbreviation) EXPECT_EQ(phrase->english.ends_with('.'), phrase->other.ends_with('.')) << phrase->english;
      EXPECT_FALSE(phrase->other.starts_with(' ') || phrase->other.ends_with(' ')) << phrase->english;
    }
}

/// A text as a person would meet it: something plausible at each place.
TEST(Phrases, AreFound) {
  for (const Language language : translated_languages())
    for (const Phrase* phrase : phrases(language)) {
      std::string text;
      for (std::size_t k = 0; k < phrase->english.size(); ++k) {
        if (phrase->english[k] != '{') {
          text += phrase->english[k];
          continue;
        }
        text += "7";
        k = phrase->english.find('}', k);
      }
      EXPECT_TRUE(is_known(text, language)) << tag(language) << ": " << text;
      EXPECT_FALSE(translated(text, language).contains('{')) << tag(language) << ": " << text;
    }
}

}  // namespace
}  // namespace axiometry::language
