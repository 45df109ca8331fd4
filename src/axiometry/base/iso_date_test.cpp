// SPDX-License-Identifier: Apache-2.0
#include "axiometry/base/iso_date.h"

#include <gtest/gtest.h>

namespace axiometry {
namespace {

TEST(IsoDate, ReadsWhatIsCertainAndNothingElse) {
  EXPECT_EQ(iso_date("2014-05-15"), "2014-05-15");
  EXPECT_EQ(iso_date("2014-05-15T09:30:00Z"), "2014-05-15");
  EXPECT_EQ(iso_date(" 5.3.2026 "), "2026-03-05");
  EXPECT_EQ(iso_date("2014/5/15 10:00"), "2014-05-15");
  EXPECT_EQ(iso_date("05/06/2014"), "");
  EXPECT_EQ(iso_date("2014-02-30"), "");
  EXPECT_EQ(iso_date("spring 2014"), "");
  EXPECT_EQ(iso_date("None: simulated"), "");
  EXPECT_EQ(iso_date(""), "");
}

}  // namespace
}  // namespace axiometry
