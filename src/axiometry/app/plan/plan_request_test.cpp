// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/plan/plan_request.h"

#include <gmock/gmock.h>

#include <time.h>

#include <algorithm>

#include "axiometry/app/plan/nc_program.h"
#include "axiometry/formats/plan/plan_json.h"

namespace axiometry::app {
namespace {

using testing::HasSubstr;

constexpr const char* simple = R"({"axis": "X", "kind": "linear", "from": 0, "to": 500, "positions": null,
  "targets": null, "cycle": "standard", "runs": 5, "feed": 3000, "dwell_s": 3, "overrun": null, "seed": 7,
  "further": {"period": "10"}})";

json::Value value_of(const std::string& text) {
  const auto value = json::parse(text);
  EXPECT_TRUE(value) << text;
  return *value;
}

Result<RequestedPlan> asked(const std::string& text) { return requested_plan_of(value_of(text)); }

/// The simple request with one member or flag in place of another.
std::string with(const std::string& found, const std::string& replacement) {
  std::string text = simple;
  const auto at = text.find(found);
  EXPECT_NE(at, std::string::npos) << found;
  return text.replace(at, found.size(), replacement);
}

TEST(PlanRequest, MakesThePlanThatTheCommandLineMakes) {
  const std::string day_before = today();
  const auto plan = asked(simple);
  ASSERT_TRUE(plan) << plan.error().to_string();
  iso230_2::PlanRequest request;
  request.axis.name = "X";
  request.axis.travel_begin = Position::native(0);
  request.axis.travel_end = Position::native(500);
  request.axis.expected_period = Position::native(10);
  request.runs = 5;
  request.feed = 3000;
  request.dwell = Duration::s(3);
  request.seed = 7;
  const auto made_on = [&](const std::string& day) {
    request.date = day;
    return formats::write_plan(iso230_2::make_plan(request).value());
  };
  EXPECT_THAT(formats::write_plan(plan->planned.plan), testing::AnyOf(made_on(day_before), made_on(today())));
  EXPECT_TRUE(plan->planned.conforming());
}

TEST(PlanRequest, KeepsToTheCycleOfAnotherRuleAndThePlanToItsName) {
  const auto plan = asked(with("\"period\": \"10\"", "\"standard\": \"jis-b-6201\""));
  ASSERT_TRUE(plan) << plan.error().to_string();
  EXPECT_EQ(plan->planned.plan.cycle, TestCycle::step) << "the standard one of a page gives way";
  const auto read = formats::read_plan(formats::write_plan(plan->planned.plan));
  ASSERT_TRUE(read) << read.error().to_string();
  EXPECT_EQ(read->rule, "jis-b-6201");
  EXPECT_FALSE(asked(with("\"period\": \"10\"", "\"standard\": \"nmtba\"")));
}

TEST(PlanRequest, RefusesADateThatIsNoDay) {
  const auto plan = asked(with("\"period\": \"10\"", "\"period\": \"10\", \"date\": \"2026-13-45\""));
  ASSERT_FALSE(plan);
  EXPECT_THAT(plan.error().message, testing::HasSubstr("found the date of the plan \"2026-13-45\""));
}

TEST(PlanRequest, WithoutASeedSaysTheOneThatWasDrawnSoThatThePlanCanBeMadeAgain) {
  const auto first = asked(with("\"seed\": 7", "\"seed\": null"));
  ASSERT_TRUE(first);
  const auto again = requested_plan_of(first->request);
  ASSERT_TRUE(again) << again.error().to_string();
  EXPECT_EQ(first->planned.plan.targets, again->planned.plan.targets);
  EXPECT_TRUE(first->request.find("seed")->is(json::Kind::number));
}

TEST(PlanRequest, IsSaidBackWithAllItsMembers) {
  const auto plan = asked(R"({"axis": "X", "kind": "linear", "from": 0, "to": 500})");
  ASSERT_TRUE(plan) << plan.error().to_string();
  for (const char* name : {"positions", "targets", "runs", "feed", "dwell_s", "overrun"}) {
    ASSERT_NE(plan->request.find(name), nullptr) << name;
    EXPECT_TRUE(plan->request.find(name)->is(json::Kind::null)) << name;
  }
  EXPECT_EQ(plan->request.find("cycle")->text(), "standard");
  EXPECT_TRUE(plan->request.find("further")->members().empty());
}

TEST(PlanRequest, TakesEveryFlagOfTheCommandLineByItsName) {
  const auto plan = asked(with("{\"period\": \"10\"}",
                               R"({"soft-limits": "5:495", "period": "5", "compensation-points": "0:500:50",
      "segment": "100", "acceleration": "2000", "machine": "M <b>1</b>", "date": "2026-01-02", "interval": "40",
      "step": "0.01", "measure": "20:480", "warm-up": "2"})"));
  ASSERT_TRUE(plan) << plan.error().to_string();
  EXPECT_EQ(plan->planned.plan.machine, "M <b>1</b>");
  EXPECT_EQ(plan->planned.plan.date, "2026-01-02");
  EXPECT_EQ(plan->planned.plan.warm_up_runs, 2u);
  EXPECT_EQ(plan->planned.plan.acceleration, 2000.0);
  EXPECT_GE(plan->planned.plan.targets.front(), Position::native(20));
  const auto periodic = asked(with("{\"period\": \"10\"}", R"({"periodic": "10", "at": "200"})"));
  ASSERT_TRUE(periodic) << periodic.error().to_string();
  EXPECT_NEAR(periodic->planned.plan.targets.front().in_native(), 185, 5);
  const auto sequence = asked(R"({"axis": "X", "kind": "linear", "from": 0, "to": 500, "targets": 4,
    "cycle": "user-defined", "further": {"sequence": "1+ 3+ 4- 2-"}})");
  ASSERT_TRUE(sequence) << sequence.error().to_string();
  EXPECT_EQ(approaches(sequence->planned.plan).size(), 4u);
}

TEST(PlanRequest, KeepsTheFurtherPlansOfALongAxis) {
  const auto plan = asked(with("\"to\": 500", "\"to\": 6000"));
  ASSERT_TRUE(plan) << plan.error().to_string();
  ASSERT_EQ(plan->planned.plan.further.size(), 1u);
  const json::Value draft = draft_value(*plan, {});
  ASSERT_EQ(draft.find("parts")->items().size(), 2u);
  EXPECT_THAT(draft.find("parts")->items()[1].find("figure_svg")->text(), HasSubstr("<svg"));
  const auto two = asked(R"({"axis": "Y", "kind": "linear", "from": 0, "to": 6000, "cycle": "standard",
    "further": {"area": "500, 3000:4000"}})");
  ASSERT_TRUE(two) << two.error().to_string();
  EXPECT_EQ(two->planned.plan.further.size(), 2u);
}

struct Bad {
  std::string found;
  std::string replacement;
  std::string message;
};

TEST(PlanRequest, NamesTheMemberThatIsWrong) {
  const Bad table[] = {
      {"\"kind\": \"linear\"", "\"kind\": \"slanted\"", "kind: found \"slanted\", expected linear or rotary"},
      {"\"from\": 0", "\"from\": \"0\"", "from: found string, expected number"},
      {"\"to\": 500, ", "", "found no member \"to\""},
      {"\"runs\": 5", "\"runs\": 5.5", "runs: found 5.5, expected a whole number"},
      {"\"runs\": 5", "\"runs\": -1", "runs: found -1, expected a whole number"},
      {"\"targets\": null, \"cycle\": \"standard\", \"runs\": 5", "\"targets\": 11, \"runs\": 10000",
       "found 11 targets in 10000 runs, 220000 readings in all, expected at most 100000"},
      {"\"seed\": 7", "\"seed\": 1e300", "seed: found"},
      {"\"seed\": 7", "\"sead\": 7", "found the unknown member \"sead\", expected perhaps \"seed\""},
      {"\"positions\": null", "\"positions\": []", "positions: found an empty list"},
      {"\"positions\": null", "\"positions\": [\"1\"]", "positions: found string, expected a number"},
      {"\"feed\": 3000", "\"feed\": -3", "expected a number above 0"},
      {"\"period\": \"10\"", "\"period\": \"ten\"", "period: found \"ten\", expected a number"},
      {"\"period\": \"10\"", "\"period\": 10", "period: found number, expected a string"},
      {"\"period\": \"10\"", "\"periods\": \"10\"", "found the unknown flag \"periods\", expected perhaps \"period\""},
      {"\"period\": \"10\"", "\"feed\": \"10\"", "found feed in further, expected it as the member \"feed\""},
      {"\"period\": \"10\"", "\"out\": \"/etc/passwd\"", "found the unknown flag \"out\""},
      {"\"period\": \"10\"", "\"at\": \"10\"", "found at without periodic"},
      {"\"period\": \"10\"", "\"period\": \"10\", \"periodic\": \"10\"", "found both periodic and period"},
      {"\"period\": \"10\"", "\"sequence\": \"/etc/passwd\"", "expected the number of a target and its direction"},
      {"\"period\": \"10\"", "\"acceleration\": \"0\"", "expected"},
  };
  for (const Bad& bad : table) {
    const auto plan = asked(with(bad.found, bad.replacement));
    ASSERT_FALSE(plan) << bad.replacement;
    EXPECT_THAT(plan.error().message, HasSubstr(bad.message));
  }
  EXPECT_EQ(asked(with("\"kind\": \"linear\"", "\"kind\": \"slanted\"")).error().at.line, 1u);
  EXPECT_EQ(asked(with("\"10\"", "\"ten\"")).error().at.line, 3u);
}

TEST(PlanRequest, APlanOfAFileIsCheckedInPlaceOfARequest) {
  const auto made = asked(simple);
  const std::string file = write_requested(*made);
  for (const json::Value& given : {json::Value(file), value_of(file)}) {
    json::Value body = json::Value::object();
    body.add("plan", given);
    const auto plan = requested_plan(body);
    ASSERT_TRUE(plan) << plan.error().to_string();
    EXPECT_EQ(plan->planned.plan.targets, made->planned.plan.targets);
    EXPECT_TRUE(plan->request.is(json::Kind::null));
  }
  json::Value body = json::Value::object();
  body.add("plan", "{\n  \"targets\": [1, 1]}");
  EXPECT_EQ(requested_plan(body).error().at.line, 1u);
  EXPECT_THAT(requested_plan(value_of("{}")).error().message, HasSubstr("neither a request nor a plan"));
}

TEST(PlanRequest, CountsWhatIsAskedForBeforeItIsMade) {
  const auto further = [](const std::string& flag) { return asked(with("\"period\": \"10\"", flag)).error().message; };
  EXPECT_THAT(further(R"("compensation-points": "0:500:1e-3")"),
              HasSubstr("compensation-points: found \"0:500:1e-3\", 500001 positions in all, expected at most 10000"));
  std::string areas = "0";
  for (int k = 0; k < 100; ++k) areas += ",0";
  EXPECT_THAT(further(R"("area": ")" + areas + '"'), HasSubstr("more than 100 stretches"));
  std::string positions = "0";
  for (int k = 1; k <= 10'000; ++k) positions += ",1";
  EXPECT_THAT(asked(with("\"positions\": null", "\"positions\": [" + positions + "]")).error().message,
              HasSubstr("positions: found 10001 of them, expected at most 10000"));
}

TEST(PlanRequest, HasNoSeedWhereNothingIsDrawn) {
  const auto seeded = [](const char* travel, const char* targets, const char* seed) -> Result<void> {
    PlanRequestDraft wish;
    const std::pair<std::string_view, const char*> given[] = {
        {"--travel", travel}, {"--targets", targets}, {"--seed", seed}};
    for (const PlanOption& option : plan_options())
      for (const auto& [name, text] : given)
        if (option.name == name && *text != '\0') AXIOMETRY_TRY_VOID(option.apply(text, wish));
    AXIOMETRY_TRY(const auto request, completed(wish));
    AXIOMETRY_TRY(const Plan plan, iso230_2::make_plan(request));
    return check_seed_used(wish, plan);
  };
  const auto refused = seeded("0:500", "20,130,240,350,460", "7");
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("found a seed beside the positions of all targets"));
  EXPECT_TRUE(seeded("0:500", "20,130,240,350,460", ""));
  EXPECT_TRUE(seeded("0:500", "5", "7"));
  EXPECT_TRUE(seeded("0:3000", "20,1300,2900", "7")) << "targets of the normal working area are drawn";
}

TEST(PlanRequest, TakesNoNameThatIsNoLineOfText) {
  EXPECT_THAT(asked(with("\"X\"", "\"X\\nG0 Z-1\"")).error().message, HasSubstr("U+000A in the name of the axis"));
  const std::string bottomless(100'000, 'X');
  EXPECT_THAT(asked(with("\"X\"", "\"" + bottomless + "\"")).error().message, HasSubstr("expected at most 500"));
}

TEST(PlanRequest, IsKeptBesideThePlanAndReadAgainWithItsAcceleration) {
  const auto made = asked(with("\"period\": \"10\"", "\"acceleration\": \"200\""));
  ASSERT_TRUE(made) << made.error().to_string();
  const auto read = read_requested(write_requested(*made));
  ASSERT_TRUE(read) << read.error().to_string();
  EXPECT_EQ(write_requested(*read), write_requested(*made));
  EXPECT_EQ(read->planned.plan.acceleration, 200.0);
  EXPECT_TRUE(formats::read_plan(write_requested(*made)));
}

/// That it has computed, without what it waited.
double seconds_of_this_thread() {
  timespec time{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

TEST(PlanRequest, ADraftComesWhileAPersonTypes) {
  double shortest_s = 1.0;
  for (int attempt = 0; attempt < 5; ++attempt) {  // whatever else the machine has to do
    const double begin_s = seconds_of_this_thread();
    const auto plan = asked(simple);
    const std::string text = json::dump(draft_value(*plan, {}), 0);
    shortest_s = std::min(shortest_s, seconds_of_this_thread() - begin_s);
    EXPECT_THAT(text, HasSubstr("<svg"));
  }
  EXPECT_LT(shortest_s, 0.05);
}

TEST(NcOptions, AreReadFromTexts) {
  const std::vector<std::pair<std::string, std::string>> texts = {
      {"unit", "inch"},       {"unrolled", ""},       {"trigger_m_code", "27"}, {"number", ""},    {"decimals", "5"},
      {"block_numbers", "0"}, {"stop_at_start", "1"}, {"frame", "G54"},         {"rollover", "on"}};
  const auto options = nc_options(texts);
  ASSERT_TRUE(options) << options.error().message;
  EXPECT_EQ(options->unit, nc::LengthUnit::inch);
  EXPECT_TRUE(options->unrolled && options->stop_at_start && !options->block_numbers);
  EXPECT_EQ(options->trigger_m_code, 27u);
  EXPECT_FALSE(options->number);
  EXPECT_EQ(options->decimals, 5);
  EXPECT_EQ(options->frame, "G54");
  EXPECT_TRUE(options->rollover);
  EXPECT_EQ(nc_options({})->frame, "active");
  EXPECT_FALSE(nc_options({})->rollover);
  for (const auto& [name, text] : std::vector<std::pair<std::string, std::string>>{{"unit", "ell"},
                                                                                   {"unrolled", "maybe"},
                                                                                   {"decimals", "7"},
                                                                                   {"trigger_m_code", "-1"},
                                                                                   {"rollover", "perhaps"},
                                                                                   {"file", "x"}}) {
    const std::pair<std::string, std::string> one[] = {{name, text}};
    EXPECT_THAT(nc_options(one).error().message, HasSubstr(name + ": found"));
  }
}

TEST(NcProgramOfAPlan, IsWrittenForAPlanAtHandAndForItsParts) {
  const auto plan = asked(with("\"to\": 500", "\"to\": 6000"));
  NcRequest request{.dialect = "linuxcnc"};
  const auto whole = nc_program_of(plan->planned.plan, request);
  request.part = 2;
  const auto part = nc_program_of(plan->planned.plan, request);
  ASSERT_TRUE(whole && part);
  EXPECT_NE(*whole, *part);
  request.part = 3;
  EXPECT_THAT(nc_program_of(plan->planned.plan, request).error().message, HasSubstr("expected 1 to 2"));
}

TEST(PlanRequest, TakesErrorsOtherThanPositions) {
  const auto plan = asked(with("\"period\": \"10\"", "\"error\": \"EYX, ebx\""));
  ASSERT_TRUE(plan) << plan.error().to_string();
  EXPECT_EQ(plan->planned.plan.errors, (std::vector<MotionName>{{'Y', 'X'}, {'B', 'X'}}));
  const auto fault = [](const std::string& further) {
    const auto refused = asked(with("\"period\": \"10\"", further));
    return refused ? std::string() : refused.error().message;
  };
  EXPECT_THAT(fault("\"error\": \"yaw\""), HasSubstr("error: found the error \"yaw\""));
  EXPECT_THAT(fault("\"error\": \"EXY\""), HasSubstr("in a plan of the axis \"X\""));
  EXPECT_THAT(fault("\"error\": \"EYX\", \"periodic\": \"10\""), HasSubstr("found both error and periodic"));
}

}  // namespace
}  // namespace axiometry::app
