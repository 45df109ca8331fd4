// SPDX-License-Identifier: Apache-2.0
#include "axiometry/digest/sha256.h"

#include <gtest/gtest.h>

namespace axiometry {
namespace {

TEST(Sha256, AgreesWithThePublishedExample) {
  // FIPS 180-2, example B.1.
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

}  // namespace
}  // namespace axiometry
