// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "axiometry/nc/axis_table.h"

namespace axiometry::nc {
namespace {

using testing::HasSubstr;

AxisCorrection correction() { return *AxisCorrection::make(AxisKind::linear, {0, 100}, {-1, 2}, {3, 4.5}); }

TEST(LinuxcncTable, WritesWhereTheAxisReallyWas) {
  const AxisTable* table = *axis_table_named("LinuxCNC");
  const auto text = table->write(correction(), {});
  EXPECT_EQ(*text, "0.000000 0.001000 -0.003000\n100.000000 99.998000 99.995500\n");
  const auto read = table->read(*text, {});
  EXPECT_NEAR(read->at(100, Direction::up), 2.0, 1e-3);
  EXPECT_NEAR(read->at(0, Direction::down), 3.0, 1e-3);
}

TEST(LinuxcncTable, WritesTrimsOfTypeOne) {
  const AxisTable* table = *axis_table_named("linuxcnc_type1");
  EXPECT_EQ(*table->write(correction(), {}), "0.000000 -0.001000 0.003000\n100.000000 0.002000 0.004500\n");
}

TEST(LinuxcncTable, RefusesWhereTheControlWouldEndReadingWithoutAWord) {
  const AxisTable* table = *axis_table_named("linuxcnc");
  const auto error = [&](const char* text) { return table->read(text, {}).error(); };
  EXPECT_EQ(error("0 0 0\n# comment\n1 1 1\n").at.line, 2u);
  EXPECT_EQ(error("0 0 0\n\n1 1 1\n").at.line, 2u);
  EXPECT_EQ(error("0,5 0,5 0,5\n").at.line, 1u);
  EXPECT_THAT(error("0 0 0\n0 0 0\n").message, HasSubstr("not above"));
  std::string long_table;
  for (int k = 0; k < 257; ++k) long_table += std::to_string(k) + " 0 0\n";
  EXPECT_THAT(error(long_table.c_str()).message, HasSubstr("256"));
}

}  // namespace
}  // namespace axiometry::nc
