// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/test_standard.h"

#include <gtest/gtest.h>

namespace axiometry {
namespace {

Axis along(Vector3 direction, std::string name) {
  Axis axis;
  axis.name = std::move(name);
  set_spatial_line(axis, {{1, 2, 3}, direction});
  return axis;
}

TEST(TestStandard, OfOneAxisIsIso2302WithOrWithoutALine) {
  Axis plain;
  plain.name = "X";
  for (const Axis& axis : {plain, along({1, 0, 0}, "X")}) {
    EXPECT_EQ(standard_of(axis), "ISO 230-2");
    EXPECT_EQ(edition_of(axis), "ISO 230-2:2014");
    EXPECT_EQ(title_of(axis), "Axis X");
    EXPECT_EQ(description_of(axis), "X (linear axis)");
  }
  EXPECT_EQ(octant_of(plain), "");
  EXPECT_EQ(octant_of(along({-1, 0, 0}, "X")), "−X");
}

TEST(TestStandard, OfADiagonalIsIso2306WithTheParametersOfIso2302) {
  const Axis axis = along({0.6, 0.0, -0.8}, "xz");
  EXPECT_EQ(standard_of(axis), "ISO 230-6");
  EXPECT_EQ(edition_of(axis), "ISO 230-6:2002, parameters as in ISO 230-2:2014");
  EXPECT_NE(edition_remark(axis).find("not at hand"), std::string::npos);
  EXPECT_EQ(word_for(axis), "diagonal");
  EXPECT_EQ(title_of(axis), "Diagonal xz");
  EXPECT_EQ(description_of(axis), "xz (diagonal of X and Z)");
  EXPECT_EQ(octant_of(axis), "+X −Z");
  EXPECT_EQ(description_of(along({1, 1, 1}, "")), "diagonal of X, Y and Z");
}

TEST(TestStandard, OfARotaryAxisIsIso2302WhateverLineItWasGiven) {
  Axis axis = along({1, 1, 0}, "C");
  axis.kind = AxisKind::rotary;
  EXPECT_EQ(standard_of(axis), "ISO 230-2");
  EXPECT_EQ(description_of(axis), "C (rotary axis)");
  EXPECT_EQ(octant_of(axis), "");
}

}  // namespace
}  // namespace axiometry
