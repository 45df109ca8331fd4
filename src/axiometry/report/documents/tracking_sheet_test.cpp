// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "axiometry/report/tracking.h"
#include "axiometry/report/writer.h"
#include "axiometry/tracking/lines/seven_lines.h"

namespace axiometry::report {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// The station stands 12 mm too far to the front: x, z and xz are lost.
TrackingPlan plan_with_lost_lines() {
  TrackingSetup setup;
  setup.travel = {{0, 0, -500}, {800, 600, 0}};
  setup.tool_offset_mm = {0, 0, -120};
  setup.station = {{100, -12, -600}, {}};
  setup.limits.elevation_highest_deg = 90.0;
  setup.limits.incidence_most_deg = 180.0;
  setup.obstacles = {{"vice <5>", BoxObstacle{{450, 130, -700}, {550, 230, -520}}}};
  tracking::LinesRequest request;
  request.machine = "Mill 5";
  request.seed = 3;
  return *tracking::plan_lines(setup, request);
}

std::string html_of(const TrackingPlan& plan, const Options& options = {}) {
  return *find_writer("html")->set(tracking_sheet(plan, Duration::s(3600), options), options);
}

TEST(TrackingSheet, TellsLinesLostLinesWaysAndTargets) {
  const TrackingPlan plan = plan_with_lost_lines();
  const std::string html = html_of(plan);
  for (const TrackingLine& line : plan.lines) EXPECT_THAT(html, HasSubstr(line.id));
  EXPECT_EQ(plan.lost.size(), 3u);
  EXPECT_THAT(html, HasSubstr("4 of 7 lines can be measured"));
  EXPECT_THAT(html, HasSubstr("12.0 mm outside the travel of Y"));
  EXPECT_THAT(html, HasSubstr("vice &lt;5&gt;"));
  EXPECT_THAT(html, HasSubstr("Mill 5"));
  EXPECT_THAT(html, HasSubstr("60 min"));
  EXPECT_THAT(html, Not(HasSubstr("nan")));
}

TEST(TrackingSheet, ATableOfTargetsHasTheCoordinatesOfTheMachine) {
  const TrackingPlan plan = plan_with_lost_lines();
  const Document document = tracking_sheet(plan, Duration::s(60), {});
  const auto section = std::ranges::find(document.sections, "targets", &Section::id);
  ASSERT_NE(section, document.sections.end());
  ASSERT_EQ(section->blocks.size(), plan.lines.size());
  for (std::size_t k = 0; k < plan.lines.size(); ++k) {
    const Table& table = std::get<Table>(section->blocks[k]);
    const Plan& line = plan.lines[k].plan;
    ASSERT_EQ(table.rows.size(), line.targets.size());
    const Vector3 at = spatial_line(line.axis)->at(line.targets[1]);
    for (std::size_t axis = 0; axis < 3; ++axis)
      EXPECT_EQ(plain_text(table.rows[1][2 + axis].text), format_fixed(at[axis], 3));
  }
}

TEST(TrackingSheet, FollowsTheDecimalMark) {
  Options options;
  options.numbers.decimal_mark = ',';
  EXPECT_THAT(html_of(plan_with_lost_lines(), options), HasSubstr("100,000"));
}

TEST(TrackingSheet, EveryWriterSetsIt) {
  const Document document = tracking_sheet(plan_with_lost_lines(), Duration::s(60), {});
  for (std::string_view extension : {"html", "pdf", "svg", "png", "csv"}) {
    const auto bytes = find_writer(extension)->set(document, {});
    ASSERT_TRUE(bytes) << extension;
    EXPECT_GT(bytes->size(), 200u) << extension;
  }
}

}  // namespace
}  // namespace axiometry::report
