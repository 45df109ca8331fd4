// SPDX-License-Identifier: Apache-2.0
//
// The phrase books of all languages: that their rows are sound, and that no language has rows that another lacks.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <span>
#include <string>

#include "axiometry/language/language.h"
#include "axiometry/language/phrase_file.h"
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

TEST(Phrases, BeginWithEnglishWhichNeedsNone) {
  ASSERT_GE(languages().size(), 3u);
  EXPECT_EQ(languages().front(), Language::english);
  EXPECT_TRUE(phrases(Language::english).empty());
}

TEST(Pairs, AreOfTheSameTextsInTheSameOrderInEveryLanguage) {
  const auto wanted = pairs_of(tag(Language::german));
  ASSERT_GT(wanted.size(), 7000u);
  for (const Language language : translated_languages()) {
    const auto own = pairs_of(tag(language));
    ASSERT_EQ(own.size(), wanted.size()) << tag(language);
    for (std::size_t k = 0; k < wanted.size(); ++k) {
      ASSERT_EQ(own[k].english, wanted[k].english) << tag(language);
      EXPECT_EQ(own[k].subject, wanted[k].subject) << tag(language) << ": " << wanted[k].english;
    }
  }
}

/// "{n|test|tests} of {all}" has n, for one word of two, and all.
struct NamedPlaces {
  std::set<std::string> values, choices;
};
NamedPlaces named_places(std::string_view text) {
  NamedPlaces all;
  for (std::size_t at = text.find('{'); at != std::string_view::npos; at = text.find('{', at + 1)) {
    const std::size_t end = text.find_first_of("|}", at);
    (text[end] == '|' ? all.choices : all.values).emplace(text.substr(at + 1, end - at - 1));
  }
  return all;
}

TEST(Pairs, OfThePageHaveThePlacesOfTheEnglish) {
  for (const Language language : translated_languages())
    for (const PhrasePair& pair : pairs_of(tag(language))) {
      if (!pair.of_page_alone) continue;
      const NamedPlaces english = named_places(pair.english), other = named_places(pair.other);
      EXPECT_EQ(english.values, other.values) << tag(language) << ": " << pair.english;
      for (const std::string& name : other.choices)
        EXPECT_TRUE(english.choices.contains(name) || english.values.contains(name)) << pair.english;
      EXPECT_FALSE(pair.other.empty()) << tag(language) << ": " << pair.english;
    }
}

TEST(Pairs, AreThereOnceBesideThoseOfThePage) {
  std::set<std::string> seen;
  for (const PhrasePair& pair : pairs_of(tag(Language::german)))
    EXPECT_TRUE(seen.insert(pair.english).second) << pair.english;
}

TEST(Pairs, AreSortedWithinTheirSubject) {
  const auto pairs = pairs_of(tag(Language::german));
  for (std::size_t k = 1; k < pairs.size(); ++k)
    if (pairs[k].subject == pairs[k - 1].subject) EXPECT_LT(pairs[k - 1].english, pairs[k].english);
}

TEST(Phrases, AreSaidOnce) {
  for (const Language language : translated_languages()) {
    std::set<std::string_view> seen;
    for (const Phrase& phrase : phrases(language))
      EXPECT_TRUE(seen.insert(phrase.english).second) << tag(language) << ": " << phrase.english;
  }
}

TEST(Phrases, HaveThePlacesOfTheEnglish) {
  for (const Language language : translated_languages())
    for (const Phrase& phrase : phrases(language)) {
      const auto english = places(phrase.english);
      EXPECT_EQ(english, places(phrase.other)) << tag(language) << ": " << phrase.english;
      EXPECT_EQ(std::set<char>(english.begin(), english.end()).size(), english.size()) << phrase.english;
    }
}

TEST(Phrases, EndAsTheEnglishDoes) {
  for (const Language language : translated_languages())
    for (const Phrase& phrase : phrases(language)) {
      EXPECT_FALSE(phrase.other.empty()) << phrase.english;
      const bool is_abbreviation = !phrase.english.contains(' ');
      if (!is_abbreviation) EXPECT_EQ(phrase.english.ends_with('.'), phrase.other.ends_with('.')) << phrase.english;
      EXPECT_FALSE(phrase.other.starts_with(' ') || phrase.other.ends_with(' ')) << phrase.english;
    }
}

/// A text as a person would meet it: something plausible at each place.
TEST(Phrases, AreFound) {
  for (const Language language : translated_languages())
    for (const Phrase& phrase : phrases(language)) {
      std::string text;
      for (std::size_t k = 0; k < phrase.english.size(); ++k) {
        if (phrase.english[k] != '{') {
          text += phrase.english[k];
          continue;
        }
        text += "7";
        k = phrase.english.find('}', k);
      }
      EXPECT_TRUE(is_known(text, language)) << tag(language) << ": " << text;
      EXPECT_FALSE(translated(text, language).contains('{')) << tag(language) << ": " << text;
    }
}

/// With a number at each place that no other has: 70, 71, ….
std::string filled(std::string_view text) {
  std::string all;
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (text[k] != '{') {
      all += text[k];
      continue;
    }
    all += "7";
    all += text[k + 1];
    k = text.find('}', k);
  }
  return all;
}

/// Many entries would fit a text; the one that is taken is its own, and what is at its places goes where it belongs.
TEST(Phrases, AreTakenForTheirOwnTexts) {
  for (const Language language : translated_languages())
    for (const Phrase& phrase : phrases(language)) {
      const std::string text = filled(phrase.english);
      if (has_no_words(text)) continue;  // "{0#}: {1}" is an entry for words at its places
      EXPECT_EQ(translated(text, language), filled(phrase.other)) << phrase.english;
    }
}

}  // namespace
}  // namespace axiometry::language
