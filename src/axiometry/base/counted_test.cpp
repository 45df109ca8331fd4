// SPDX-License-Identifier: Apache-2.0
#include "axiometry/base/counted.h"

#include <gtest/gtest.h>

namespace axiometry {
namespace {

TEST(Counted, IsSingularOfOneThingAlone) {
  EXPECT_EQ(counted(0, "station"), "0 stations");
  EXPECT_EQ(counted(1, "station"), "1 station");
  EXPECT_EQ(counted(2, "station"), "2 stations");
  EXPECT_EQ(counted(1, "approach", "approaches"), "1 approach");
  EXPECT_EQ(counted(21, "approach", "approaches"), "21 approaches");
}

}  // namespace
}  // namespace axiometry
