// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/machine/chain.h"

#include <gtest/gtest.h>

namespace axiometry::volumetric {
namespace {

TEST(KinematicChain, ReadsWhichAxesCarryTheWorkpiece) {
  const KinematicChain chain = KinematicChain::make("YXFZ").value();
  EXPECT_EQ(chain.order(), (std::array<std::size_t, 3>{1, 0, 2}));
  EXPECT_TRUE(chain.carries_workpiece(1));
  EXPECT_TRUE(chain.carries_workpiece(0));
  EXPECT_FALSE(chain.carries_workpiece(2));
  EXPECT_EQ(chain.text(), "YXFZ");
  EXPECT_EQ(KinematicChain::make("wXbYZt").value().text(), "XFYZ");
  EXPECT_EQ(KinematicChain::make("XYZF").value().text(), "XYZF");
}

TEST(KinematicChain, RefusesWhatIsNoChainOfThreeAxes) {
  for (const char* text : {"", "XYZ", "XFY", "XXFY", "XFYZF", "XFYA", "FXYZZ", "xfyz"})
    EXPECT_FALSE(KinematicChain::make(text)) << text;
}

// shared formulas of a bridge, a table and a cross table, written out by hand: what lies behind each axis.
TEST(KinematicChain, LeversReachFromAnAxisOverAllBehindItToTheTool) {
  const Vector3 q{1.0, 2.0, 4.0}, t{10.0, 20.0, 30.0};
  const auto bridge = KinematicChain::make("FXYZ").value().levers(q, t);
  EXPECT_EQ(bridge[0], (Vector3{10.0, 22.0, 34.0}));
  EXPECT_EQ(bridge[1], (Vector3{10.0, 20.0, 34.0}));
  EXPECT_EQ(bridge[2], t);
  const auto table = KinematicChain::make("XFYZ").value().levers(q, t);
  EXPECT_EQ(table[0], (Vector3{11.0, 22.0, 34.0}));
  const auto cross = KinematicChain::make("YXFZ").value().levers(q, t);
  EXPECT_EQ(cross[1], (Vector3{11.0, 22.0, 34.0}));
  EXPECT_EQ(cross[0], (Vector3{11.0, 20.0, 34.0}));
  EXPECT_EQ(cross[2], t);
}

}  // namespace
}  // namespace axiometry::volumetric
