// SPDX-License-Identifier: Apache-2.0
#include "axiometry/tracking/lengths/reading_order.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "axiometry/tracking/lines/line_test_support.h"

namespace axiometry::tracking {
namespace {

using namespace testing_support;
using ::testing::HasSubstr;

std::vector<OrderedLength> shown(const TrackingPlan& plan) {
  std::vector<OrderedLength> lengths;
  for (const LengthReading& r : measured(plan, {})) lengths.push_back({r.length_difference_mm});
  return lengths;
}

std::string fault(const TrackingPlan& plan, const std::vector<OrderedLength>& lengths) {
  const auto readings = assign_in_order(plan, lengths);
  if (!readings) return readings.error().message;
  const auto checked = check_order(plan, *readings, true);
  return checked ? "" : checked.error().message;
}

TEST(ReadingOrder, AssignsLengthsToTheApproachesOfThePlan) {
  const TrackingPlan plan = two_lines();
  const auto readings = assign_in_order(plan, shown(plan));
  ASSERT_TRUE(readings);
  const auto truth = measured(plan, {});
  for (std::size_t k = 0; k < truth.size(); ++k) {
    EXPECT_EQ((*readings)[k].line, truth[k].line);
    EXPECT_EQ((*readings)[k].approach, truth[k].approach);
  }
  EXPECT_EQ(fault(plan, shown(plan)), "");
}

TEST(ReadingOrder, FindsWhereAReadingWasLost) {
  for (const std::size_t runs : {1u, 3u}) {
    const TrackingPlan plan = two_lines(runs);
    const std::size_t count = shown(plan).size();
    for (std::size_t lost = 2; lost + 4 < count; ++lost) {
      if (lost == count / 2 || lost + 1 == count / 2 || lost % 7 == 0 || lost % 7 == 6) continue;  // alike at the turns
      auto fewer = shown(plan);
      fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(lost));
      EXPECT_THAT(fault(plan, fewer), HasSubstr(fmt::format("from reading {} on", lost + 1))) << lost << ' ' << runs;
      auto filled = fewer;
      filled.push_back(filled.back());
      EXPECT_THAT(fault(plan, filled), HasSubstr("as if 1 reading was missing before it")) << lost << ' ' << runs;
    }
  }
}

TEST(ReadingOrder, FindsWhereAReadingIsTooMany) {
  const TrackingPlan plan = two_lines();
  auto more = shown(plan);
  more.insert(more.begin() + 24, more[23]);
  EXPECT_THAT(fault(plan, more), HasSubstr("found 141 lengths, expected 140"));
  more.pop_back();
  EXPECT_THAT(fault(plan, more), HasSubstr("from reading 25 on"));
}

TEST(ReadingOrder, FindsWhereOneWasLostAndAnotherTakenTwice) {
  const TrackingPlan plan = two_lines();
  for (const std::size_t lost : {3u, 23u, 44u, 65u})
    for (const std::size_t twice : {10u, 31u, 54u, 80u, 115u}) {
      if (twice > lost ? twice < lost + 4 : lost < twice + 4) continue;
      auto lengths = shown(plan);
      const auto at = [&](std::size_t k) { return lengths.begin() + static_cast<std::ptrdiff_t>(k); };
      const OrderedLength again = lengths[twice];
      if (twice > lost) {
        lengths.insert(at(twice), again);
        lengths.erase(at(lost));
      } else {
        lengths.erase(at(lost));
        lengths.insert(at(twice), again);
      }
      // Where nearly all that follows is shifted, the loss alone is told.
      EXPECT_THAT(fault(plan, lengths),
                  HasSubstr(twice > 100 ? "do not fit the order" : "and others again from reading"))
          << lost << ' ' << twice;
    }
}

TEST(ReadingOrder, LeavesReadingsOutThatWereNotTaken) {
  const TrackingPlan plan = two_lines();
  auto lengths = shown(plan);
  lengths[10].missing = true;
  const auto readings = assign_in_order(plan, lengths);
  ASSERT_TRUE(readings);
  EXPECT_EQ(readings->size(), 139u);
  EXPECT_TRUE(check_order(plan, *readings, true));
}

TEST(ReadingOrder, TakesABreakOfTheBeamForNoLostReading) {
  const TrackingPlan plan = two_lines();
  for (const double jump : {0.3, -3.0, 47.0, 2000.0})
    for (std::size_t before = 1; before < 70; ++before) {
      auto lengths = shown(plan);
      for (std::size_t k = before; k < 70; ++k) lengths[k].length_difference_mm += jump;
      EXPECT_EQ(fault(plan, lengths), "") << jump << " before " << before;
    }
}

TEST(ReadingOrder, RefusesTheLengthsOfOtherTargets) {
  const TrackingPlan plan = two_lines();
  TrackingPlan other = plan;
  for (TrackingLine& line : other.lines)
    for (std::size_t i = 1; i + 1 < line.plan.targets.size(); ++i)
      line.plan.targets[i] = Position::native(line.plan.targets[i].in_native() + (i % 2 == 0 ? 9.0 : -7.0));
  EXPECT_THAT(fault(plan, shown(other)), HasSubstr("another plan"));
}

}  // namespace
}  // namespace axiometry::tracking
