// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/plan/plan_json.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <random>
#include <set>
#include <sstream>

#include "axiometry/model/fields.h"

namespace axiometry::formats {
namespace {

void expect_same_plan(const Plan& a, const Plan& b) {
  EXPECT_EQ(a.standard, b.standard);
  EXPECT_EQ(a.clause, b.clause);
  EXPECT_EQ(a.title, b.title);
  EXPECT_EQ(a.machine, b.machine);
  EXPECT_EQ(a.date, b.date);
  Metadata of_a, of_b;
  of_a.axis = a.axis;
  of_b.axis = b.axis;
  for (const Field& field : metadata_fields()) EXPECT_EQ(field.get(of_a), field.get(of_b)) << field.key;
  EXPECT_EQ(a.errors, b.errors);
  EXPECT_EQ(a.cycle, b.cycle);
  EXPECT_EQ(a.targets, b.targets);
  EXPECT_EQ(a.runs, b.runs);
  EXPECT_EQ(a.overrun, b.overrun);
  EXPECT_EQ(a.feed, b.feed);
  EXPECT_EQ(a.dwell, b.dwell);
  EXPECT_EQ(a.warm_up_runs, b.warm_up_runs);
  EXPECT_EQ(a.rule, b.rule);
  EXPECT_EQ(a.seed, b.seed);
  EXPECT_EQ(a.sequence, b.sequence);
  EXPECT_EQ(a.way_in_mm, b.way_in_mm);
  EXPECT_EQ(a.way_out_mm, b.way_out_mm);
  ASSERT_EQ(a.further.size(), b.further.size());
  for (std::size_t k = 0; k < a.further.size(); ++k) expect_same_plan(a.further[k], b.further[k]);
}

class AnyPlan {
 public:
  explicit AnyPlan(unsigned seed) : random_(seed) {}

  Plan make(bool with_further) {
    Plan plan;
    plan.standard = plan_standards[random_() % std::size(plan_standards)];
    plan.clause = plan_clauses[random_() % std::size(plan_clauses)];
    plan.title = text();
    plan.machine = text();
    plan.date = text();
    plan.axis.name = text();
    plan.axis.kind = random_() % 2 ? AxisKind::rotary : AxisKind::linear;
    plan.axis.scale_type = text();
    if (random_() % 2) plan.axis.travel_begin = Position::native(number(1e6));
    if (random_() % 2) plan.axis.travel_end = Position::native(number(1e6));
    if (random_() % 2) plan.axis.expected_period = Position::native(std::abs(number(1e6)));
    for (std::size_t k = random_() % 3; k > 0; --k) plan.axis.compensation_points.push_back(number(1e6));
    std::set<double> targets;
    for (std::size_t k = 1 + random_() % 6; k > 0; --k) targets.insert(number(1e9));
    for (double x : targets) plan.targets.push_back(Position::native(x));
    plan.rule = text();
    plan.runs = 1 + random_() % 10'000;
    plan.overrun = Position::native(std::abs(number(1e9)) + 1e-12);
    plan.feed = std::abs(number(1e9)) + 1e-12;
    plan.dwell = Duration::s(std::abs(number(100)));
    plan.warm_up_runs = random_() % 4;
    if (random_() % 2) plan.seed = random_() >> (random_() % 64);
    plan.cycle = static_cast<TestCycle>(random_() % 5);
    if (plan.cycle == TestCycle::user_defined) {
      for (std::size_t i = 0; i < plan.targets.size(); ++i)
        plan.sequence.push_back({i, Direction::down, plan.runs - 1});
      std::ranges::shuffle(plan.sequence, random_);
    }
    if (plan.axis.kind == AxisKind::linear && random_() % 2) {
      // As given, of any length: what is read is what was written, bit by bit.
      plan.axis.line_origin_mm = {number(1e6), number(1e6), number(1e6)};
      plan.axis.line_direction = {number(1e6), 0.5, number(1e6)};
      for (std::size_t k = random_() % 4; k > 0; --k) plan.way_in_mm.push_back({number(1e8), number(1e8), number(1)});
      for (std::size_t k = random_() % 3; k > 0; --k) plan.way_out_mm.push_back({number(1e8), number(1), number(1)});
    }
    if (with_further)
      for (std::size_t k = random_() % 3; k > 0; --k) plan.further.push_back(make(false));
    return plan;
  }

 private:
  std::string text() { return random_() % 2 ? std::string() : std::string("µ \"quoted\" \\ text\n"); }
  double number(double limit) {
    return limit * std::ldexp(static_cast<double>(random_() >> 11), -52) - limit * (1.0 - 0x1p-52);
  }
  std::mt19937_64 random_;
};

TEST(PlanJson, ReadsBackExactlyWhatItWrote) {
  AnyPlan any(2302);
  for (int trial = 0; trial < 500; ++trial) {
    const Plan plan = any.make(true);
    ASSERT_TRUE(check_sound(plan)) << check_sound(plan).error().message;
    const std::string text = write_plan(plan);
    EXPECT_TRUE(text.ends_with("}\n"));
    const auto again = read_plan(text);
    ASSERT_TRUE(again) << again.error().to_string() << "\n" << text;
    expect_same_plan(plan, *again);
    EXPECT_EQ(write_plan(*again), text);
  }
}

TEST(PlanJson, EverySeedSurvives) {
  Plan plan = AnyPlan(1).make(false);
  for (std::uint64_t seed : {std::uint64_t{0}, std::uint64_t{7}, (std::uint64_t{1} << 53) - 1, std::uint64_t{1} << 53,
                             (std::uint64_t{1} << 53) + 1, std::numeric_limits<std::uint64_t>::max()}) {
    plan.seed = seed;
    const auto again = read_plan(write_plan(plan));
    ASSERT_TRUE(again) << again.error().to_string();
    EXPECT_EQ(again->seed, seed);
  }
}

constexpr std::string_view small = R"({"axis": {"kind": "linear"}, "cycle": "standard", "targets": [0, 10, 20],
 "runs": 2, "overrun": 5, "feed": 1000, "dwell_s": 3})";

std::string with(std::string_view what, std::string_view instead) {
  std::string text(small);
  const std::size_t at = text.find(what);
  EXPECT_NE(at, text.npos) << what;
  return text.replace(at, what.size(), instead);
}

std::string reason(std::string_view bytes) {
  const auto plan = read_plan(bytes);
  return plan ? "" : plan.error().to_string();
}

TEST(PlanJson, ReadsWhatAPersonWrote) {
  const auto plan =
      read_plan(with("\"runs\": 2", "\"runs\": 2, \"machine\": null, \"findings\": [{}], \"duration_s\": 1"));
  ASSERT_TRUE(plan) << plan.error().to_string();
  EXPECT_EQ(plan->standard, "ISO 230-2:2014");
  EXPECT_EQ(plan->machine, "");
  EXPECT_EQ(plan->warm_up_runs, 0u);
  EXPECT_FALSE(plan->seed);
  EXPECT_EQ(plan->targets.size(), 3u);
  EXPECT_EQ(plan->dwell, Duration::s(3));
}

TEST(PlanJson, SortsTargetsAndKeepsTheSequenceOnThePositionsItNames) {
  const auto plan = read_plan(R"({"axis": {"kind": "rotary"}, "cycle": "user-defined", "targets": [90, -30, 45],
    "runs": 1, "overrun": 5, "feed": 1000, "dwell_s": 0, "sequence": [[1, "down", 1], [2, "up", 1], [3, "up", 1]]})");
  ASSERT_TRUE(plan) << plan.error().to_string();
  EXPECT_EQ(plan->targets, (std::vector{Position::native(-30), Position::native(45), Position::native(90)}));
  EXPECT_EQ(plan->sequence,
            (std::vector<axiometry::Approach>{{2, Direction::down, 0}, {0, Direction::up, 0}, {1, Direction::up, 0}}));
}

TEST(PlanJson, RefusesWithTheRightPlace) {
  EXPECT_EQ(reason(small), "");
  EXPECT_EQ(reason(with("2, \"over", "0, \"over")), "line 2:10: found 0 runs, expected 1 to 10000");
  EXPECT_EQ(reason(with("20]", "10]")), "line 1:70: found the target 10 a second time, expected each once");
  EXPECT_EQ(reason(with("20]", "2e9]")),
            "line 1:70: found target 1 at 2000000000, expected a position within ±1000000000");
  EXPECT_EQ(reason(with("1000", "-1")), "line 2:35: found a feed of -1, expected 1e-06 to 1000000000");
  EXPECT_EQ(reason(with("5,", "0,")), "line 2:24: found an overrun of 0, expected 1e-06 to 1000000000");
  EXPECT_EQ(reason(with("\"runs\": 2", "\"runs\": 2.5")),
            "line 2:10: found \"runs\" 2.5, expected a whole number of 0 or more");
  EXPECT_EQ(
      reason(with("\"feed\"", "\"fed\"")),
      "line 1:1: found no member \"feed\" in the plan, expected axis, cycle, targets, runs, overrun, feed, dwell_s");
  EXPECT_EQ(reason(with("\"runs\": 2", "\"runs\": 2, \"sed\": 1")),
            "line 2:20: found the unknown member \"sed\" in the plan, expected perhaps \"seed\"");
  EXPECT_EQ(
      reason(with("\"standard\"", "\"zigzag\"")),
      "line 1:39: found the cycle \"zigzag\", expected one of standard, step, pilgrim, unidirectional, user-defined");
  EXPECT_EQ(reason(with("{\"kind\": \"linear\"}", "{}")),
            "line 1:10: found no member \"kind\" in axis, expected \"linear\" or \"rotary\"");
  EXPECT_EQ(reason(with("[0, 10, 20]", "[]")), "line 1:62: found a plan without targets, expected at least one");
  EXPECT_EQ(reason(with("[0, 10, 20]", "[0, \"a\"]")),
            "line 1:66: found \"targets\" that is of the kind string, expected a number");
  EXPECT_EQ(reason(with("{\"axis\"", "{\"standard\": \"ISO 230-2:2006\", \"axis\"")),
            "line 1:14: found the standard \"ISO 230-2:2006\", expected one of ISO 230-2:2014, ISO 230-6:2002");
  EXPECT_TRUE(reason(with("{\"axis\"", "{\"clause\": \"5.3.9\", \"axis\""))
                  .starts_with("line 1:12: found the clause \"5.3.9\", expected one of 5.3.2, 5.3.3"));
  EXPECT_EQ(reason(with("\"standard\"", "\"user-defined\"")),
            "line 1:39: found a user-defined cycle without a sequence, expected the approaches in their order");
  EXPECT_EQ(reason("[1]"), "line 1:1: found JSON that is no object, expected a plan");
  EXPECT_NE(reason(""), "");
  EXPECT_NE(reason(with("\"linear\"", "\"liner\"")), "");
  EXPECT_NE(reason(with("\"runs\": 2", "\"runs\": 1e300")), "");
  EXPECT_NE(reason(with("\"runs\": 2", "\"runs\": 2, \"seed\": 9007199254740993")), "");
  EXPECT_NE(reason(with("\"runs\": 2", "\"runs\": 2, \"seed\": \"18446744073709551616\"")), "");
  EXPECT_NE(reason(with("\"runs\": 2", "\"runs\": 2, \"seed\": -1")), "");
  EXPECT_NE(reason(with("\"runs\": 2", "\"runs\": 2, \"format\": \"axiometry-test/1\"")), "");
  EXPECT_NE(reason(with("\"runs\": 2", "\"runs\": null")), "");
}

TEST(PlanJson, TellsATrackingPlanFromAPlan) {
  EXPECT_EQ(reason(R"({"format": "axiometry-tracking-plan/1", "setup": {}, "lines": []})"),
            "line 1:12: found a tracking plan of several lines, expected the plan of one test, such as one of its "
            "lines");
}

TEST(PlanJson, NamesTheWayOrLineThatIsNone) {
  const auto of = [](std::string_view axis, std::string_view ways) {
    const std::string line = with("{\"kind\": \"linear\"}", "{\"kind\": " + std::string(axis) + "}");
    return reason(std::string(line).insert(line.find("\"cycle"), std::string(ways)));
  };
  constexpr std::string_view good = R"("linear", "line_origin_mm": [0, 0, 5], "line_direction": [1, 1, 0])";
  EXPECT_EQ(of(good, ""), "");
  EXPECT_EQ(of(good, "\n\"way_in_mm\": [[1, 2, 3], [4, 5, 6]], \"way_out_mm\": null, "), "");
  EXPECT_EQ(of(good, "\n\"way_in_mm\": [[1, 2, 3], [4, 5]], "),
            "line 2:26: found a point of \"way_in_mm\" that is none, expected [x, y, z] in mm");
  EXPECT_EQ(of(good, "\n\"way_out_mm\": [[1, 2, 2e9]], "),
            "line 2:15: found a way over (1, 2, 2000000000) mm, expected finite coordinates up to 1e9");
  EXPECT_EQ(of("\"linear\"", "\n\"way_out_mm\": [[1, 2, 3]], "),
            "line 2:15: found a way in or out in space, expected a line in space for it to lead to");
  constexpr std::string_view bad = "line 1:10: found an invalid line in space, expected three finite numbers";
  EXPECT_TRUE(of(R"("linear", "line_origin_mm": [0, 0, 5])", "").starts_with(bad));
  EXPECT_TRUE(of(R"("linear", "line_origin_mm": [0, 0, 5], "line_direction": [0, 0, 0])", "").starts_with(bad));
  EXPECT_TRUE(of(R"("rotary", "line_origin_mm": [0, 0, 5], "line_direction": [1, 0, 0])", "").starts_with(bad));
}

TEST(PlanJson, NamesTheApproachThatDoesNotFit) {
  const auto of = [](std::string_view sequence) {
    return reason(
        with("\"cycle\": \"standard\"", "\"cycle\": \"user-defined\", \"sequence\":\n" + std::string(sequence)));
  };
  EXPECT_EQ(of(R"([[1, "up", 1], [1, "down", 1]])"), "");
  EXPECT_EQ(of(R"([[1, "up", 1], [4, "up", 1]])"), "line 2:17: found an approach to target 4, expected 1 to 3");
  EXPECT_EQ(of(R"([[1, "up", 1], [0, "up", 1]])"), "line 2:17: found an approach to target 0, expected 1 to 3");
  EXPECT_EQ(of(R"([[1, "up", 1], [1, "down", 3], [1, "up", 3]])"),
            "line 2:16: found run 3 in the sequence, expected 1 to 2");
  EXPECT_EQ(of(R"([[1, "up", 1], [2, "up", 1], [1, "up", 1], [3, "up", 1]])"),
            "line 2:30: found run 1 ↑ of target 1 a second time in the sequence, expected each once");
  EXPECT_EQ(of(R"([[1, "left", 1]])"), "line 2:6: found \"left\", expected \"up\" or \"down\"");
  EXPECT_EQ(of(R"([[1, "up"]])"), "line 2:2: expected [number of the target, \"up\" or \"down\", number of the run]");
}

TEST(PlanJson, DamagedFilesGiveASoundPlanOrAReason) {
  AnyPlan any(5);
  std::mt19937 random(6);
  std::size_t read = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    std::string text = write_plan(any.make(true));
    for (int change = 0; change < 3; ++change) {
      constexpr std::string_view bytes = "0123456789-.eE[]{},:\"nultrefas \xff";
      char& byte = text[random() % text.size()];
      const bool digit = byte >= '0' && byte <= '9';
      if (digit || trial % 2) byte = bytes[random() % (trial % 2 ? bytes.size() : 10)];
    }
    const auto plan = read_plan(text);
    read += plan.has_value();
    EXPECT_TRUE(plan ? check_sound(*plan).has_value() : !plan.error().message.empty()) << text;
  }
  EXPECT_GT(read, 100u);
}

TEST(PlanJson, RefusesFurtherPlansOfFurtherPlans) {
  Plan plan = AnyPlan(3).make(false);
  plan.further = {AnyPlan(4).make(false)};
  std::string text = write_plan(plan);
  ASSERT_TRUE(read_plan(text));
  plan.further[0].further = {AnyPlan(5).make(false)};
  const auto again = read_plan(json::dump(plan_value(plan)));
  ASSERT_FALSE(again);
  EXPECT_EQ(again.error().message, "found a further plan with further plans, expected one level");
}

TEST(PlanJson, TheSchemaInTheRepositoryIsTheOneTheProgramPrints) {
  std::ifstream stream(AXIOMETRY_SOURCE_DIR "/schema/axiometry-plan.schema.json", std::ios::binary);
  std::stringstream text;
  text << stream.rdbuf();
  EXPECT_EQ(text.str(), json::dump(plan_schema()) + "\n");
}

TEST(PlanJson, RefusesADateThatIsNoDayAndReadsOtherWords) {
  const auto dated = [](const std::string& date) {
    return read_plan(R"({"axis": {"name": "X", "kind": "linear"}, "cycle": "standard", "targets": [0, 10],
 "runs": 1, "overrun": 1, "feed": 1000, "dwell_s": 1, "date": ")" +
                     date + "\"}");
  };
  for (const char* none : {"2026-02-30", "30.02.2026"}) {
    const auto refused = dated(none);
    ASSERT_FALSE(refused) << none;
    EXPECT_EQ(refused.error().message, plan_date_refusal(none));
    EXPECT_NE(refused.error().to_string().find("2:"), std::string::npos) << "where it stands";
  }
  for (const char* date : {"2026-02-28", "", "spring 2026"}) {
    const auto plan = dated(date);
    ASSERT_TRUE(plan) << plan.error().to_string();
    EXPECT_EQ(plan->date, date);
  }
}

TEST(PlanJson, SaysWhatErrorsItIsMadeForAndRefusesOthersWithTheirPlace) {
  const auto plan_with = [](const std::string& errors, const std::string& axis = "X") {
    return R"({"axis": {"name": ")" + axis + R"(", "kind": "linear"}, "cycle": "standard", "targets": [0, 10],
 "runs": 1, "overrun": 1, "feed": 1000, "dwell_s": 1, "errors": )" +
           errors + "}";
  };
  const auto plan = read_plan(plan_with(R"(["EYX", "eax"])"));
  ASSERT_TRUE(plan) << plan.error().to_string();
  EXPECT_EQ(plan->errors, (std::vector<MotionName>{{'Y', 'X'}, {'A', 'X'}}));
  expect_same_plan(*read_plan(write_plan(*plan)), *plan);
  for (const char* none : {"null", "[]"}) {
    const auto of_positions = read_plan(plan_with(none));
    ASSERT_TRUE(of_positions) << none;
    EXPECT_EQ(write_plan(*of_positions).find("errors"), std::string::npos);
  }
  const auto fault = [&](const std::string& errors, const std::string& axis = "X") {
    const auto read = read_plan(plan_with(errors, axis));
    return read ? std::string() : read.error().to_string();
  };
  EXPECT_NE(fault(R"("EYX")").find("line 2:65: "), std::string::npos) << fault(R"("EYX")");
  EXPECT_NE(fault("[1]").find("line 2:66: "), std::string::npos) << fault("[1]");
  EXPECT_NE(fault(R"(["yaw"])").find("2:66: found the error \"yaw\""), std::string::npos) << fault(R"(["yaw"])");
  EXPECT_NE(fault(R"(["EYX", "EYX"])").find("found EYX twice"), std::string::npos);
  EXPECT_NE(fault(R"(["EYX"])", "Y").find("2:65: found the error EYX in a plan of the axis \"Y\""), std::string::npos)
      << fault(R"(["EYX"])", "Y");
}

}  // namespace
}  // namespace axiometry::formats
