// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/live/lengths/length_task.h"

#include <gmock/gmock.h>

#include <string>

#include "axiometry/app/live/lengths/length_plans_test_support.h"
#include "axiometry/formats/tracking/tracking_lengths_csv.h"
#include "axiometry/formats/volumetric/volumetric_lengths_csv.h"

namespace axiometry::app {
namespace {

using testing::HasSubstr;
using testing_support::lines_task;
using testing_support::volume_body;
using testing_support::volume_task;

TEST(LengthTask, NamesThePartsOfAPlanAndTheirStops) {
  const LengthTask all = lines_task(0), one = lines_task(2);
  EXPECT_EQ(all.title(), "all 2 lines");
  EXPECT_EQ(one.title(), "measuring line xz");
  ASSERT_EQ(all.parts().size(), 3u);
  EXPECT_EQ(all.parts()[0].stops, all.stops().size());
  EXPECT_EQ(all.parts()[1].stops + all.parts()[2].stops, all.stop_count());
  EXPECT_EQ(one.stop_count(), one.stops().size());
  EXPECT_EQ(one.stops().front().group, "measuring line xz");
  EXPECT_EQ(one.stops().front().name, "target 1↑ run 1");
  const LengthTask part = volume_task(2);
  EXPECT_EQ(part.title(), "part 2 (station B, tool T1)");
  EXPECT_EQ(part.stop_count(), testing_support::volume_points);
  EXPECT_EQ(part.stops().back().name, "point " + std::to_string(testing_support::volume_points));
}

TEST(LengthTask, RefusesPartsThatThePlanDoesNotHave) {
  json::Value body = json::Value::object();
  body.add("plan", lines_task(0).plan_value());
  EXPECT_THAT(LengthTask::make(LengthPlanKind::lines, body, 3).error().message, HasSubstr("expected 1 to 2"));
  EXPECT_FALSE(LengthTask::make(LengthPlanKind::volume, volume_body(), 0));
  EXPECT_FALSE(LengthTask::make(LengthPlanKind::volume, volume_body(), 3));
  EXPECT_FALSE(LengthTask::make(LengthPlanKind::volume, body, 1));
  EXPECT_FALSE(LengthTask::make(LengthPlanKind::lines, json::Value::object(), 0));
}

TEST(LengthTask, APlanThatIsMadeAgainOnAnotherDayIsTheSame) {
  volumetric::CalibrationPlan plan = *volume_task(1).volume();
  const auto id_of = [](const volumetric::CalibrationPlan& of) { return volume_task(1, of).plan_id(); };
  const std::string id = id_of(plan);
  plan.date = "2030-01-01";
  EXPECT_EQ(id_of(plan), id);
  EXPECT_EQ(volume_task(2, plan).plan_id(), id) << "whatever the part";
  plan.runs[1].stops.pop_back();
  EXPECT_NE(id_of(plan), id);
}

TEST(LengthTask, RefusesOptionsThatLengthsCannotHave) {
  CaptureOptions options;
  options.part = 1;
  EXPECT_THAT(volume_task(1).open(options).error().message, HasSubstr("part"));
  EXPECT_THAT(lines_task(1).open(options).error().message, HasSubstr("part"));
  options = {};
  options.matcher.zero_at_first_target = true;
  EXPECT_FALSE(volume_task(1).open(options));
  EXPECT_FALSE(lines_task(0).open(options));
}

std::string lines_table(std::size_t line, double length_mm, std::size_t segment = 0) {
  const LengthTask task = lines_task(line);
  const TrackingLine& wanted = task.lines()->lines.front();
  std::vector<LengthReading> readings;
  for (const Approach& approach : approaches(wanted.plan))
    readings.push_back({wanted.id, approach, length_mm, segment});
  return "# noted\n" + formats::write_tracking_lengths(readings);
}

TEST(JoinedTables, GivesEachCaptureOfLinesDeadPathsOfItsOwn) {
  const LengthTask plan = lines_task(0);
  const auto joined =
      joined_tables(plan, {{"capture 1", lines_table(1, 100.0, 1)}, {"capture 2", lines_table(2, 200.0)}});
  ASSERT_TRUE(joined) << joined.error().message;
  EXPECT_THAT(*joined, HasSubstr("# noted"));
  const auto read = formats::read_tracking_lengths(*joined, *plan.all_lines());
  ASSERT_TRUE(read) << read.error().message;
  ASSERT_EQ(read->rows.size(), plan.stop_count());
  EXPECT_EQ(read->rows.front().reading.segment, 1u);
  EXPECT_EQ(read->rows.back().reading.segment, 2u);
  EXPECT_EQ(read->rows.back().reading.line, "xz");
}

TEST(JoinedTables, TakesALineFromTheLastCaptureOfItAndTellsThat) {
  const LengthTask plan = lines_task(0);
  const auto joined = joined_tables(plan, {{"capture 1", lines_table(1, 100.0)},
                                           {"capture 2", lines_table(2, 200.0)},
                                           {"capture 3", lines_table(1, 300.0)}});
  ASSERT_TRUE(joined) << joined.error().message;
  EXPECT_THAT(*joined, HasSubstr("line x: the lengths of capture 1 are left out, those of capture 3 came later"));
  const auto read = formats::read_tracking_lengths(*joined, *plan.all_lines());
  ASSERT_TRUE(read) << read.error().message;
  for (const auto& row : read->rows)
    EXPECT_EQ(row.reading.length_difference_mm, row.reading.line == "x" ? 300.0 : 200.0);
}

TEST(JoinedTables, PutsPartsOfAVolumeTogetherByTheirNames) {
  const std::string head = "station,tool,x_mm,y_mm,z_mm,length_mm\n";
  const std::vector<CapturedTable> tables = {{"capture 1", head + "B,T1,1,2,-3,10.5\nB,T1,4,5,-6,20.5\n"},
                                             {"capture 2", head + "A,T1,1,2,-3,30.5\n"},
                                             {"capture 4", head + "B,T1,7,8,-9,40.5\n"}};
  const auto joined = joined_tables(volume_task(1), tables);
  ASSERT_TRUE(joined) << joined.error().message;
  EXPECT_THAT(*joined, HasSubstr("station B, tool T1: the lengths of capture 1 are left out"));
  const auto read = formats::read_volumetric_lengths(*joined);
  ASSERT_TRUE(read) << read.error().message;
  ASSERT_EQ(read->readings.size(), 2u);
  EXPECT_EQ(read->readings[0].length_mm, 30.5);
  EXPECT_EQ(read->stations[read->readings[0].station], "A");
  EXPECT_EQ(read->readings[1].length_mm, 40.5);
  EXPECT_FALSE(joined_tables(volume_task(1), {{"a", "nothing"}, {"b", head}}));
}

}  // namespace
}  // namespace axiometry::app
