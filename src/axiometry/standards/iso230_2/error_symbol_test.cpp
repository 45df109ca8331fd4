// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/error_symbol.h"

#include <gtest/gtest.h>

namespace axiometry::iso230_2 {
namespace {

Axis named(std::string name) {
  Axis axis;
  axis.name = std::move(name);
  return axis;
}

const ParameterInfo& parameter(std::string_view key) {
  for (const ParameterInfo& p : parameters)
    if (p.key == key) return p;
  ADD_FAILURE() << key;
  return parameters[0];
}

TEST(ErrorSymbol, IsThatOfTheStandardsExamples) {  // 8.2.4
  EXPECT_EQ(error_symbol(named("X"), parameter("A_up")), "E_XX,A↑");
  EXPECT_EQ(error_symbol(named("X"), parameter("A_down")), "E_XX,A↓");
  EXPECT_EQ(error_symbol(named("C"), parameter("B")), "E_CC,B");
  EXPECT_EQ(error_symbol(named("X1"), parameter("B_mean")), "E_X1X1,B̄");
}

TEST(ErrorSymbol, IsNoneOfNamesThatNoControlGives) {
  for (const char* name : {"", "x", "XY", "main spindle", "1", "Ä"}) {
    EXPECT_EQ(error_symbol(named(name)), "") << name;
    EXPECT_EQ(error_symbol(named(name), parameter("A")), "") << name;
  }
}

TEST(ErrorSymbol, IsNoneOfADiagonal) {
  Axis diagonal = named("D");
  diagonal.line_origin_mm = {0, 0, 0};
  diagonal.line_direction = {1, 1, 0};
  EXPECT_EQ(error_symbol(diagonal), "");
  Axis along_x = named("X");
  along_x.line_origin_mm = {0, 0, 0};
  along_x.line_direction = {1, 0, 0};
  EXPECT_EQ(error_symbol(along_x), "E_XX");
}

}  // namespace
}  // namespace axiometry::iso230_2
