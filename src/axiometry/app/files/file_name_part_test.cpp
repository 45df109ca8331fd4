// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/files/file_name_part.h"

#include <gtest/gtest.h>

namespace axiometry::app {
namespace {

TEST(FileNamePart, LeadsToNoOtherFolder) {
  EXPECT_EQ(file_name_part("xyz"), "xyz");
  EXPECT_EQ(file_name_part("../a/b\n"), ".._a_b_");
  EXPECT_EQ(file_name_part("größe"), "größe");
}

}  // namespace
}  // namespace axiometry::app
