// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/plan/further.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "axiometry/standards/iso230_2/plan/plan.h"

namespace axiometry::iso230_2 {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

Plan long_plan(AxisKind kind = AxisKind::linear) {
  PlanRequest r;
  r.axis.name = "Y";
  r.axis.kind = kind;
  r.axis.travel_begin = Position::native(0);
  r.axis.travel_end = Position::native(kind == AxisKind::linear ? 3000 : 1440);
  r.seed = 7;
  return make_plan(r).value();
}

/// "5.3.3 missing" and the message.
std::vector<std::string> all_but_notes(const Plan& plan) {
  std::vector<std::string> list;
  for (const Finding& f : plan_findings(plan))
    if (f.severity != Severity::note)
      list.push_back(f.clause + " " + std::string(severity_name(f.severity)) + ": " + f.message);
  return list;
}

std::vector<std::string> told_of_part(const std::function<void(Plan& part)>& change, AxisKind kind = AxisKind::linear) {
  Plan plan = long_plan(kind);
  change(plan.further.at(0));
  return all_but_notes(plan);
}

constexpr const char* still_needed =
    "5.3.3 missing: the test with five approaches over 2 000 mm of the normal working area is also needed (6.2)";

TEST(FurtherPlan, OfItsOwnMakingIsTheOneThatTheClauseAsksFor) {
  EXPECT_THAT(all_but_notes(long_plan()), IsEmpty());
  EXPECT_THAT(all_but_notes(long_plan(AxisKind::rotary)), IsEmpty());
}

TEST(FurtherPlan, MustRestAtItsTargetsToo) {
  EXPECT_THAT(told_of_part([](Plan& part) { part.dwell = Duration::s(0); }),
              Contains(HasSubstr("5.1 missing: Normal working area, 500 to 2500 mm: found no dwell at the targets")));
}

TEST(FurtherPlan, HasFiveApproachesOverTheStretchOfTheSameAxis) {
  Plan plan = long_plan();
  Plan same = plan;
  same.further.clear();
  plan.further = {same};
  EXPECT_THAT(all_but_notes(plan), Contains(still_needed)) << "once more one approach over the whole";
  EXPECT_THAT(told_of_part([](Plan& part) {
                for (std::size_t i = 0; i < part.targets.size(); ++i)
                  part.targets[i] = Position::native(517.0 + 1.1 * static_cast<double>(i));
              }),
              Contains(still_needed))
      << "ten millimetres are no normal working area";
  const auto other = told_of_part([](Plan& part) { part.axis.name = "X"; });
  EXPECT_THAT(other, Contains(still_needed));
  EXPECT_THAT(other, Contains("5.3.3 departure: Normal working area, 500 to 2500 mm: found a further test of axis "
                              "\"X\", expected one of axis \"Y\" as the test it belongs to"));
  EXPECT_THAT(told_of_part([](Plan& part) { part.axis.kind = AxisKind::rotary; }), Contains(still_needed));
  EXPECT_THAT(told_of_part([](Plan& part) { part.axis.travel_begin = part.axis.travel_end = std::nullopt; }), IsEmpty())
      << "the test it belongs to tells the travel";
}

TEST(FurtherPlan, TellsWhetherItsOwnFeedIsReached) {
  Plan plan = long_plan();
  const auto notes = [&] {
    std::vector<std::string> list;
    for (const Finding& f : plan_findings(plan)) list.push_back(f.message);
    return list;
  };
  EXPECT_THAT(notes(), IsEmpty());
  plan.further[0].feed = 30'000;
  EXPECT_THAT(notes(),
              Contains(HasSubstr("Normal working area, 500 to 2500 mm: found overruns of 10 mm, expected 250 mm")));
}

}  // namespace
}  // namespace axiometry::iso230_2
