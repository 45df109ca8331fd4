// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/field/point_spread.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "axiometry/volumetric/field/unseen_reasons.h"

namespace axiometry::volumetric {
namespace {

TEST(PointSpread, IsAPlaneWhereOnePointStandsBesideTheLineOfTheOthers) {
  EXPECT_EQ(tool_spread(std::vector<Vector3>{{0, 0, -150}}), PointSpread::point);
  EXPECT_EQ(tool_spread(std::vector<Vector3>{{0, 0, -150}, {0.5, 0, -150.5}}), PointSpread::point);
  EXPECT_EQ(tool_spread(std::vector<Vector3>{{0, 0, -150}, {0.5, 0, -200}, {0, 0, -300}}), PointSpread::line);
  EXPECT_EQ(tool_spread(std::vector<Vector3>{{0, 0, -150}, {2, 0, -200}, {0, 0, -300}}), PointSpread::plane);
}

TEST(PointSpread, MovesToolsOnToTheLineThatTheyAllButStandOn) {
  const std::vector<Vector3> near = {{0, 0, -150}, {0.5, 0, -200}, {0, 0, -300}};
  EXPECT_LT(distance(seen_offsets(near)[1], {0, 0, -200}), 1e-9);
  EXPECT_EQ(seen_offsets(near)[0], near[0]);
  EXPECT_EQ(seen_offsets(near)[2], near[2]);
  const std::vector<Vector3> triangle = {{0, 0, -150}, {60, 0, -200}, {0, 0, -300}};
  EXPECT_EQ(seen_offsets(triangle), triangle);
  const std::vector<Vector3> one = {{0, 0, -150}, {0, 0.2, -150}};
  EXPECT_EQ(seen_offsets(one), (std::vector<Vector3>{{0, 0, -150}, {0, 0, -150}}));
}

TEST(UnseenReasons, ComeFromHowToolsAndStationsStand) {
  const std::vector<Vector3> tools = {{0, 0, -150}, {60, 0, -200}, {0, 0, -300}};
  const std::vector<Vector3> wide = {{0, 0, 0}, {900, 0, 0}, {0, 700, 0}}, row = {{0, 0, 0}, {400, 5, 0}, {900, 0, 0}};
  const auto of = [](const SetupShape& setup) {
    std::string all;
    for (const std::string& reason : unseen_reasons(setup)) all += reason + "; ";
    return all;
  };
  EXPECT_NE(of({tools, row}).find("within 10 mm of one line"), std::string::npos);
  EXPECT_NE(of({tools, wide}).find("do not show why"), std::string::npos) << "no cause that nobody looked at";
  EXPECT_NE(of({{tools[0], tools[2]}, wide}).find("all tool points lie on one line"), std::string::npos);
  EXPECT_NE(of({{tools[0], {0, 0.3, -200}, tools[2]}, wide}).find("within 0.30 mm of one line"), std::string::npos);
}

TEST(UnseenReasons, TellOfALeverThatIsShortBesideItsLine) {
  const auto with = [](double beside_mm) {
    return short_lever(std::vector<Vector3>{{0, 0, -150}, {beside_mm, 0, -200}, {0, 0, -300}});
  };
  EXPECT_FALSE(with(0.5)) << "on the line: not told at all";
  ASSERT_TRUE(with(3.0));
  EXPECT_NE(with(3.0)->find("within 3.0 mm of one line"), std::string::npos);
  EXPECT_NE(with(3.0)->find("150 mm"), std::string::npos);
  EXPECT_FALSE(with(50.0));
  EXPECT_FALSE(with(10.0));
}

}  // namespace
}  // namespace axiometry::volumetric
