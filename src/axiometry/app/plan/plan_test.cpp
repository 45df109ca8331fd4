// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/plan/plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "axiometry/app/plan/nc_program.h"
#include "axiometry/base/json/json.h"
#include "axiometry/formats/plan/plan_json.h"
#include "tests/support/temporary_folder.h"

namespace axiometry::app {
namespace {

using ::testing::HasSubstr;

class PlanFiles : public ::testing::Test {
 protected:
  static Plan plan(double to) {
    iso230_2::PlanRequest r;
    r.axis.travel_begin = Position::native(0);
    r.axis.travel_end = Position::native(to);
    r.seed = 1;
    return iso230_2::make_plan(r).value();
  }

  testing_support::TemporaryFolder folder_;
};

TEST_F(PlanFiles, ReadBackWithoutWhatWasAddedForPeople) {
  PlannedTest test = planned(plan(500), std::nullopt).value();
  test.findings = {{"equally-spaced-targets", "5.2", iso230_2::Severity::note, "found \"this\""}};
  OutputNames names;
  names.json = folder_.file("plan.json");
  ASSERT_TRUE(write_plan_outputs(test, names, {}));
  const auto root = json::parse(folder_.content("plan.json"));
  ASSERT_TRUE(root);
  EXPECT_EQ(root->find("findings")->items()[0].find("id")->text(), "equally-spaced-targets");
  EXPECT_EQ(root->find("findings")->items()[0].find("message")->text(), "found \"this\"");
  EXPECT_NEAR(root->find("duration_s")->number(), test.duration.in_s(), 0.05);
  const auto again = read_plan_file(names.json);
  ASSERT_TRUE(again) << again.error().to_string();
  EXPECT_EQ(again->targets, test.plan.targets);
}

TEST_F(PlanFiles, NameTheFileOfAnError) {
  const auto bad = read_plan_file(folder_.written("bad.json", "{\n  \"axis\": 3}"));
  ASSERT_FALSE(bad);
  EXPECT_THAT(bad.error().to_string(), HasSubstr("bad.json:"));
  EXPECT_THAT(read_plan_file(folder_.file("none.json")).error().to_string(), HasSubstr("none.json"));
}

TEST_F(PlanFiles, SequencesAreListsOrFiles) {
  const std::string file = folder_.written("sequence.txt", "1+ 2+ # up\n2-\n");
  EXPECT_EQ(read_sequence("1+ 2+ 2-").value(), read_sequence(file).value());
  EXPECT_THAT(read_sequence(folder_.file("none.txt")).error().message, HasSubstr("expected the number of a target"));
}

TEST(PlanDuration, RestsOnAnAccelerationThatAnAxisHas) {
  iso230_2::PlanRequest r;
  r.axis.travel_begin = Position::native(0);
  r.axis.travel_end = Position::native(500);
  const Plan plan = iso230_2::make_plan(r).value();
  for (double acceleration : {0.0, -5.0, 1e-300, 1e300})
    EXPECT_THAT(planned(plan, acceleration).error().message, HasSubstr("expected 0.001 to 1000000"));
}

TEST(PlanDuration, CountsTheFurtherPlans) {
  iso230_2::PlanRequest r;
  r.axis.travel_begin = Position::native(0);
  r.axis.travel_end = Position::native(6000);
  const Plan plan = iso230_2::make_plan(r).value();
  ASSERT_EQ(plan.further.size(), 1u);
  const PlannedTest test = planned(plan, 2000).value();
  EXPECT_EQ(test.plan.acceleration, 2000);
  EXPECT_NEAR(test.duration_in_all.in_s() - test.duration.in_s(),
              iso230_2::estimated_duration(test.plan.further[0]).in_s(), 1e-9);
}

// One acceleration, wherever the plan goes: its file, its sheet, its part program.
TEST(PlanUseCase, KeepsTheAccelerationThatWasStated) {
  iso230_2::PlanRequest r;
  r.axis.name = "X";
  r.axis.travel_begin = Position::native(0);
  r.axis.travel_end = Position::native(6000);
  r.acceleration = 250;
  const PlannedTest made = planned(iso230_2::make_plan(r).value(), {}).value();
  const Plan kept = formats::read_plan(formats::write_plan(made.plan)).value();
  EXPECT_EQ(kept.acceleration, 250);
  EXPECT_EQ(kept.further.at(0).acceleration, 250);
  EXPECT_EQ(planned(kept, {})->duration_in_all, made.duration_in_all);
  EXPECT_GT(made.duration_in_all, planned(kept, 1000)->duration_in_all);
  EXPECT_THAT(nc_program_of(kept, {.dialect = "linuxcnc"}).value(), HasSubstr("250 MM/S2"));
}

TEST(PlanUseCase, TakesTheDateThatTheEnvironmentFixes) {
  const char* before = std::getenv("SOURCE_DATE_EPOCH");
  const std::string kept = before ? before : "";
  ::setenv("SOURCE_DATE_EPOCH", "951782400", 1);
  EXPECT_EQ(today(), "2000-02-29");
  before ? ::setenv("SOURCE_DATE_EPOCH", kept.c_str(), 1) : ::unsetenv("SOURCE_DATE_EPOCH");
  EXPECT_EQ(today().size(), 10u);
}

TEST(PlanUseCase, IsDatedAsItWasSaidOrToday) {
  EXPECT_EQ(plan_date("2026-11-21").value(), "2026-11-21");
  EXPECT_EQ(plan_date("21 Nov 2026").value(), "2026-11-21");
  EXPECT_EQ(plan_date(" ").value().size(), 10u);
  for (const char* none : {"2026-13-45", "2026-02-30", "tomorrow", "11/12/2026", "2026-11"}) {
    const auto refused = plan_date(none);
    ASSERT_FALSE(refused) << none;
    EXPECT_THAT(refused.error().message, testing::AllOf(HasSubstr(none), HasSubstr("expected a day such as")));
  }
}

}  // namespace
}  // namespace axiometry::app
