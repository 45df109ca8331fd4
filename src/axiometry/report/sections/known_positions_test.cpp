// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/sections/known_positions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <variant>

#include "axiometry/language/language.h"

namespace axiometry::report {
namespace {

using ::testing::HasSubstr;

KnownPositions two_targets() {
  KnownPositions known;
  known.targets = {{Position::native(0.0), KnownMean{0.5, 2.0}, {}},
                   {Position::native(100.0), KnownMean{0.5, 2.0}, {}}};
  known.zero = 0.33;
  known.at_targets = 2.5;
  known.anywhere = 3.5;
  known.notes = {"the alignment is not in U: nothing is stated of its uncertainty"};
  return known;
}

std::string words_of(const KnownPositions& known) {
  const Section section = known_positions_section(known, AxisKind::linear, {});
  return plain_text(std::get<Paragraph>(section.blocks[0]).text);
}

TEST(KnownPositionsSection, SaysAgainstWhichZeroAndOnWhatCondition) {
  const std::string words = words_of(two_targets());
  EXPECT_THAT(words, HasSubstr("within 2.50 µm of their position, once the zero is shifted by 0.33 µm, if the axis"));
  EXPECT_THAT(words, HasSubstr("Anywhere between the first target and the last: within 3.50 µm."));
  for (const auto language : {language::Language::german, language::Language::french})
    EXPECT_TRUE(language::is_known(words, language)) << words;
}

TEST(KnownPositionsSection, SendsToTheNotesWhereNobodyKnows) {
  KnownPositions known = two_targets();
  known.anywhere.reset();
  EXPECT_THAT(words_of(known), HasSubstr("between the targets nobody can say; the notes tell why."));
  known.at_targets.reset();
  EXPECT_EQ(words_of(known), "To within what positions are known nobody can say; the notes tell why.");
}

}  // namespace
}  // namespace axiometry::report
