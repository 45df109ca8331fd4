// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/information.h"

#include <gtest/gtest.h>

namespace axiometry::iso230_2 {
namespace {

TEST(SmallerRepeatability, IsToldOnlyWhereItIsAskedForAndBothExist) {
  Metadata metadata;
  AxisParameters p;
  p.R_up = Deviation::native(2.0);
  p.R_down = Deviation::native(1.5);
  EXPECT_FALSE(smaller_repeatability(metadata, p));
  metadata.conditions.smaller_repeatability = false;
  EXPECT_FALSE(smaller_repeatability(metadata, p));
  metadata.conditions.smaller_repeatability = true;
  ASSERT_TRUE(smaller_repeatability(metadata, p));
  EXPECT_EQ(smaller_repeatability(metadata, p)->value.in_native(), 1.5);
  EXPECT_EQ(smaller_repeatability(metadata, p)->parameter->key, "R_down");
  p.R_down = Deviation::native(2.0);
  EXPECT_EQ(smaller_repeatability(metadata, p)->parameter->key, "R_up");
  p.R_down.reset();
  EXPECT_FALSE(smaller_repeatability(metadata, p)) << "of one direction nothing is the smaller";
}

}  // namespace
}  // namespace axiometry::iso230_2
