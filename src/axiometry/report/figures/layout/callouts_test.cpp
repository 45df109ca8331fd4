// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/figures/layout/callouts.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace axiometry::report::plot {
namespace {

TEST(Callouts, ShareARowOnTheOuterSidesOfTheirLeaders) {
  const std::vector<CalloutRequest> requests = {{208, 80, false}, {192, 80, true}};
  const auto places = place_callouts(requests, 20, 480);
  EXPECT_EQ(places[0].row, 0);
  EXPECT_EQ(places[1].row, 0);
  EXPECT_GT(places[0].text_left, 208);
  EXPECT_LT(places[1].text_left + 80, 192);
}

TEST(Callouts, TakeASecondRowAtTheEdge) {
  const std::vector<CalloutRequest> requests = {{48, 80, false}, {32, 80, true}};
  const auto places = place_callouts(requests, 20, 480);
  EXPECT_EQ(places[0].row, 0);
  EXPECT_EQ(places[1].row, 1);
}

TEST(Callouts, WiderThanTheRoomStandInRowsOfTheirOwn) {
  const std::vector<CalloutRequest> requests = {{100, 600, false}, {120, 600, false}};
  const auto places = place_callouts(requests, 20, 480);
  EXPECT_NE(places[0].row, places[1].row);
  EXPECT_EQ(places[0].text_left, 20);
}

RC_GTEST_PROP(Callouts, NeverOverlapAndNeverStandOnALeader, ()) {
  const double a = *rc::gen::inRange(40, 460);
  const double b = a + *rc::gen::elementOf(std::vector<double>{-200, -60, -16, 16, 60, 200});
  RC_PRE(b > 35.0 && b < 465.0);
  const std::vector<CalloutRequest> requests = {{a, static_cast<double>(*rc::gen::inRange(30, 150)), a < b},
                                                {b, static_cast<double>(*rc::gen::inRange(30, 150)), b < a}};
  const auto places = place_callouts(requests, 20, 480);
  const auto right = [&](std::size_t k) { return places[k].text_left + requests[k].width; };
  for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
    RC_ASSERT(places[k].text_left >= 20.0);
    RC_ASSERT(right(k) <= 480.0);
    const std::size_t other = 1 - k;
    const double leader = requests[other].leader_x;
    const bool leader_passes = places[other].row >= places[k].row;
    RC_ASSERT(!leader_passes || leader < places[k].text_left || leader > right(k));
  }
  if (places[0].row == places[1].row) {
    RC_ASSERT(right(0) < places[1].text_left || right(1) < places[0].text_left);
  }
}

}  // namespace
}  // namespace axiometry::report::plot
