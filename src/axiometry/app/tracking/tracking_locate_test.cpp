// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/tracking/tracking_locate.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "axiometry/base/text/text.h"
#include "axiometry/formats/tracking/station_json.h"
#include "axiometry/model/station_bounds.h"
#include "tests/support/temporary_folder.h"

namespace axiometry::app {
namespace {

TrackingSetup setup() {
  TrackingSetup s;
  s.travel = {{0, 0, 0}, {1000, 600, 500}};
  s.tool_offset_mm = {0, 0, -150};
  s.station.position_mm = {480, 310, -250};
  return s;
}

/// The table of planned points with the lengths that the true station gives.
std::string filled(const PlannedLocation& planned, Vector3 truth) {
  std::string full;
  const std::string table = location_points_csv(planned);
  for (std::string_view line : text::split(table, '\n')) {
    full += line;
    if (!line.empty() && line.front() >= '0' && line.front() <= '9') {
      const std::size_t i = full.ends_with(',') ? static_cast<std::size_t>(line.front() - '1') : 0;
      full += fmt::format("{:.5f}", distance(planned.plan.points_mm[i], truth) - 400.0);
    }
    full += '\n';
  }
  return full;
}

TEST(TrackingLocate, PlannedPointsFindTheStationWhenTheirTableIsFilledIn) {
  const auto planned = plan_location_points(setup(), 8);
  ASSERT_TRUE(planned) << planned.error().to_string();
  const Vector3 truth{481.234, 308.765, -251.111};
  const testing_support::TemporaryFolder folder;
  const std::string file = folder.written("filled.csv", filled(*planned, truth));
  const auto located = locate({file, {}, {}});
  EXPECT_FALSE(locate({file, {}, {0, 0, -150}})) << "its coordinates hold the tool already";
  ASSERT_TRUE(located) << located.error().to_string();
  for (const tracking::Finding& finding : located->location.findings)
    EXPECT_FALSE(finding.message.starts_with("passed over")) << finding.message;
  EXPECT_NEAR(distance(located->location.refined.station_mm, truth), 0.0, 1e-4);
  EXPECT_FALSE(located->location.is_serious());

  const Experiment presented = present(*located, {});
  const auto station = formats::read_station(json::dump(presented.json));
  ASSERT_TRUE(station) << station.error().to_string();
  EXPECT_EQ(station->position_mm, located->location.refined.station_mm);
  const tracking::RefinedFit& fit = located->location.refined;
  EXPECT_EQ((*station->covariance_mm2)[1][2],
            fit.covariance_stated_mm2[1][2] * widening_for_bounds(fit.chi_squared, fit.degrees_of_freedom));
  EXPECT_EQ(present(*planned, {}).document.sections.size(), 3);
}

TEST(TrackingLocate, ATableThatWasFilledInIsNotReplaced) {
  const auto planned = plan_location_points(setup(), 8);
  ASSERT_TRUE(planned) << planned.error().to_string();
  const testing_support::TemporaryFolder folder;
  const std::string file = folder.written("table.csv", "anything");
  ASSERT_TRUE(write_location_points(*planned, file));
  ASSERT_TRUE(write_location_points(*planned, file)) << "nothing was filled in yet";
  std::string full = location_points_csv(*planned);
  full.insert(full.find('\n', full.find("\n1,") + 1), "12.345");  // the first length alone
  folder.written("table.csv", full);
  const auto again = write_location_points(*planned, file);
  EXPECT_EQ(folder.content("table.csv"), full);
  ASSERT_FALSE(again);
  EXPECT_EQ(again.error().file, file);
}

TEST(TrackingLocate, TheToolIsAddedToCoordinatesOfTheAxes) {
  const Vector3 truth{500, 300, -200}, tool{10, -20, -150};
  std::string table = "x_mm,y_mm,z_mm,length_difference_mm\n";
  for (const Vector3 q : {Vector3{100, 100, 300}, Vector3{900, 150, 100}, Vector3{850, 550, 400}, Vector3{120, 500, 50},
                          Vector3{500, 350, 450}, Vector3{300, 50, 20}, Vector3{700, 400, 200}})
    table += fmt::format("{},{},{},{}\n", q.x, q.y, q.z, distance(q + tool, truth));
  const testing_support::TemporaryFolder folder;
  const std::string file = folder.written("axes.csv", table);
  const auto located = locate({file, {}, tool});
  ASSERT_TRUE(located) << located.error().to_string();
  EXPECT_NEAR(distance(located->location.refined.station_mm, truth), 0.0, 1e-8);
}

TEST(TrackingLocate, WhatIsWrongInTheFileNamesIt) {
  const testing_support::TemporaryFolder folder;
  const std::string file = folder.written("bad.csv", "x_mm,y_mm,z_mm,length_difference_mm\n1,2,3\n");
  const auto located = locate({file, {}, {}});
  ASSERT_FALSE(located);
  EXPECT_EQ(located.error().file, file);
  EXPECT_EQ(located.error().at.line, 2);
  EXPECT_FALSE(locate({"/nowhere/points.csv", {}, {}}));
}

}  // namespace
}  // namespace axiometry::app
