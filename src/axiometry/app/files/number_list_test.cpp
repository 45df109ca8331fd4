// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/files/number_list.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace axiometry::app {
namespace {

using testing::ElementsAre;

TEST(Vectors, AreThreeNumbers) {
  EXPECT_EQ(*parse_vector("653.60, -27.13,262.18"), (Vector3{653.60, -27.13, 262.18}));
  for (const char* text : {"", "1,2", "1,2,3,4", "1,2,x", "1;2;3", "1,2,nan", "1,,2"})
    EXPECT_FALSE(parse_vector(text)) << text;
}

TEST(Distances, AreNumbersPiecesAndEllipses) {
  EXPECT_THAT(*parse_distances("10,20,35.5"), ElementsAre(10, 20, 35.5));
  EXPECT_THAT(*parse_distances("10,20,…,50"), ElementsAre(10, 20, 30, 40, 50));
  EXPECT_THAT(*parse_distances("10,20,...,40,100:300:100"), ElementsAre(10, 20, 30, 40, 100, 200, 300));
  EXPECT_THAT(*parse_distances("5"), ElementsAre(5));
  EXPECT_EQ(parse_distances("10,20,…,1100")->size(), 110u);
  EXPECT_EQ((*parse_distances("0.1:1:0.1"))[2], 0.1 + 2 * 0.1);
}

TEST(Distances, ThatAreNoneAreRefused) {
  for (const char* text : {"", "0,10", "1e-300,10", "-5", "10,5", "10,10", "10,…,50", "…,50", "10,20,…", "10,20,…,45",
                           "10:20", "10:5:1", "10:20:0", "10:20:-1", "1:1e9:0.001", "a", "10,20,…,…,50", "1e300"})
    EXPECT_FALSE(parse_distances(text)) << text;
}

}  // namespace
}  // namespace axiometry::app
