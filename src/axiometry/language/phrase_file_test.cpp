// SPDX-License-Identifier: Apache-2.0
#include "axiometry/language/phrase_file.h"

#include <gtest/gtest.h>

namespace axiometry::language {
namespace {

std::string fault_of(std::string_view text) {
  const auto pairs = read_pairs(text);
  return pairs ? "" : pairs.error().message;
}

TEST(ReadPairs, TakesTwoLinesForEachPhraseAndItsSubject) {
  const auto pairs = read_pairs("# head\n# of two lines\n\none\nun\n\ntwo {0=}\ndeux {0}\n\n# more\n\nthree\ntrois");
  ASSERT_TRUE(pairs.has_value());
  ASSERT_EQ(pairs->size(), 3u);
  EXPECT_EQ((*pairs)[1].english, "two {0=}");
  EXPECT_EQ((*pairs)[1].other, "deux {0}");
  EXPECT_EQ((*pairs)[1].subject, "head");
  EXPECT_EQ((*pairs)[2].subject, "more");
  EXPECT_EQ((*pairs)[2].other, "trois");
}

TEST(ReadPairs, KnowsWhatThePageAloneHas) {
  const auto pairs = read_pairs("one\nun\n\n# The page: its texts\n\nfree [of cost]\ngratuit\n\n# more\n\ntwo\ndeux\n");
  ASSERT_TRUE(pairs.has_value());
  ASSERT_EQ(pairs->size(), 3u);
  EXPECT_FALSE((*pairs)[0].of_page_alone);
  EXPECT_TRUE((*pairs)[1].of_page_alone);
  EXPECT_FALSE((*pairs)[2].of_page_alone);
}

TEST(ReadPairs, TakesBlankLinesAnywhereBetweenPairs) {
  const auto pairs = read_pairs("\n\none\nun\n\n\n\ntwo\ndeux\n\n");
  ASSERT_TRUE(pairs.has_value());
  EXPECT_EQ(pairs->size(), 2u);
  EXPECT_TRUE(read_pairs("")->empty());
}

TEST(ReadPairs, SaysInWhichLineAPairIsNotOne) {
  EXPECT_EQ(fault_of("one\n\ntwo\ndeux\n"), "line 2: found no line after 'one'");
  EXPECT_EQ(fault_of("one\nun\n\ntwo"), "line 4: found no line after 'two'");
  EXPECT_EQ(fault_of("one\n# un\n"), "line 2: found no line after 'one'");
  EXPECT_EQ(fault_of("one\nun\nune\n"), "line 3: found a third line 'une', expected a blank one");
}

TEST(ReadPairs, RefusesBlanksThatNobodySees) {
  EXPECT_EQ(fault_of("one \nun\n"), "line 1: found a blank at an end of 'one '");
  EXPECT_EQ(fault_of("one\n\tun\n"), "line 2: found a blank at an end of '\tun'");
  EXPECT_EQ(fault_of("one\r\nun\r\n"), "line 1: found a blank at an end of 'one\r'");
}

}  // namespace
}  // namespace axiometry::language
