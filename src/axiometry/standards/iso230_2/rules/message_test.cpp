// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/rules/message.h"

#include <gtest/gtest.h>

#include <string>

#include "axiometry/standards/iso230_2/rules/rules.h"

namespace axiometry::iso230_2::rules {
namespace {

std::string part(const Message& said, std::size_t number) {
  return said.text.substr(said.deviations.at(number).at, said.deviations.at(number).length);
}

TEST(Message, KeepsItsDeviationsWithTheirPlaces) {
  const Message said = message("{} would be {} instead of {}", "R↑", deviation_message(AxisKind::linear, 2.0625),
                               deviation_message(AxisKind::linear, -9.7));
  EXPECT_EQ(said.text, "R↑ would be 2.06 µm instead of −9.7 µm");
  ASSERT_EQ(said.deviations.size(), 2u);
  EXPECT_EQ(part(said, 0), "2.06 µm");
  EXPECT_EQ(part(said, 1), "−9.7 µm");
  EXPECT_EQ(said.deviations[0].value.in_native(), 2.0625) << "and not what is left of it when rounded";
}

TEST(Message, WithinAnotherKeepsThem) {
  const Message inner = message("by {}", deviation_message(AxisKind::rotary, 3.0));
  const Message said = message("µ: run {}, {}, p = {:.2f}; {}", 3, inner, 0.25, inner);
  EXPECT_EQ(said.text, "µ: run 3, by 3 ″, p = 0.25; by 3 ″");
  ASSERT_EQ(said.deviations.size(), 2u);
  EXPECT_EQ(part(said, 0), "3 ″");
  EXPECT_EQ(part(said, 1), "3 ″");
}

TEST(Message, TakesAnyBytesOfItsArguments) {
  const std::string words = "{} \x01 \x02 \x03 {0}";
  const Message said = message("found {} at {}", words, deviation_message(AxisKind::linear, 1.0));
  EXPECT_EQ(said.text, "found " + words + " at 1 µm");
  ASSERT_EQ(said.deviations.size(), 1u);
  EXPECT_EQ(part(said, 0), "1 µm");
}

}  // namespace
}  // namespace axiometry::iso230_2::rules
