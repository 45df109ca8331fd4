// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <regex>

#include "axiometry/nc/dialect.h"
#include "axiometry/nc/script.h"
#include "tests/support/nc_controls.h"
#include "tests/support/statistics_of_trials.h"

namespace axiometry::nc {
namespace {

using testing_support::run_program;
using testing_support::Trace;
using testing_support::Visit;

constexpr TestCycle all_cycles[] = {TestCycle::standard, TestCycle::step, TestCycle::pilgrim, TestCycle::unidirectional,
                                    TestCycle::user_defined};

/// A test that people might make, and some that they would not.
class AnyPlan {
 public:
  explicit AnyPlan(unsigned seed) : random_(seed) {}

  Plan make(TestCycle cycle, AxisKind kind) {
    Plan plan;
    plan.axis.kind = kind;
    plan.axis.name = kind == AxisKind::linear ? std::string(1, "XYZ"[below(3)]) : std::string(1, "ABC"[below(3)]);
    plan.cycle = cycle;
    plan.clause = "5.3.2";
    plan.machine = "Fräsmaschine (alt)";
    double position = -800.0 + static_cast<double>(below(900'000)) / 1000.0;
    for (std::size_t i = 0, m = 1 + below(9); i < m; ++i) {
      plan.targets.push_back(Position::native(std::round(position * 1000.0) / 1000.0));
      position += below(3) == 0 ? 0.25 + 0.001 * static_cast<double>(below(1000)) : 30.0;
    }
    plan.runs = 1 + below(7);
    plan.overrun = Position::native(0.5 + 0.25 * static_cast<double>(below(40)));
    plan.feed = 50.0 + static_cast<double>(below(20'000));
    plan.dwell = Duration::s(std::array{0.0, 0.25, 1.0, 3.005, 4.371}[below(5)]);
    plan.warm_up_runs = below(4);
    if (cycle == TestCycle::user_defined) {
      plan.cycle = TestCycle::standard;
      plan.sequence = approaches(plan);
      if (below(2) == 0) std::shuffle(plan.sequence.begin(), plan.sequence.end(), random_);
      plan.cycle = cycle;
    }
    return plan;
  }

 private:
  std::size_t below(std::size_t n) { return random_() % n; }
  std::mt19937 random_;
};

std::string write(const Dialect& dialect, const Plan& plan, const ProgramOptions& options = {}) {
  const auto program = dialect.write({&plan, 1}, options);
  EXPECT_TRUE(program) << dialect.id << ": " << (program ? "" : program.error().message);
  return program ? *program : "";
}

std::string refusal(std::string_view dialect, const Plan& plan, const ProgramOptions& options = {}) {
  const auto program = find_dialect(dialect)->write({&plan, 1}, options);
  return program ? "" : program.error().message;
}

Plan small_plan(AxisKind kind = AxisKind::linear) {
  Plan plan = AnyPlan(1).make(TestCycle::standard, kind);
  plan.axis.name = kind == AxisKind::linear ? "X" : "C";
  plan.targets = {Position::native(0), Position::native(10), Position::native(20)};
  plan.runs = 5;
  plan.overrun = Position::native(2);
  plan.feed = 1000;
  plan.dwell = Duration::s(3);
  return plan;
}

/// Every position, feed, dwell and M code as the plan has it.
void expect_walked(const Trace& trace, const Plan& plan, const ProgramOptions& options, double dwell_step_s) {
  const std::vector<PlannedMove> expected = moves(plan);
  ASSERT_EQ(trace.visits.size(), expected.size());
  const Reach ends = reach(plan);
  for (std::size_t k = 0; k < expected.size(); ++k) {
    const Visit& visit = trace.visits[k];
    const double error = std::abs(visit.position - expected[k].to.in_native());
    ASSERT_LE(error, 0.5 * visit.resolution + 1e-9) << "move " << k;
    ASSERT_GE(visit.position, ends.lowest.in_native() - visit.resolution);
    ASSERT_LE(visit.position, ends.highest.in_native() + visit.resolution);
    ASSERT_NEAR(visit.feed, plan.feed, 1e-4 * plan.feed);
    if (!expected[k].approach) {
      ASSERT_EQ(visit.dwells, 0u) << "move " << k << " dwells on its way";
      ASSERT_TRUE(visit.m_codes.empty());
      continue;
    }
    ASSERT_LE(error, trace.inch && plan.axis.kind == AxisKind::linear ? 0.5e-4 : 1e-9) << "target moved";
    const double way = visit.position - trace.visits[k - 1].position;
    ASSERT_EQ(way > 0.0, expected[k].approach->direction == Direction::up) << "move " << k;
    ASSERT_GE(visit.dwell_s, plan.dwell.in_s() - 1e-9);
    ASSERT_LE(visit.dwell_s, plan.dwell.in_s() + dwell_step_s);
    if (options.trigger_m_code) {
      ASSERT_EQ(visit.m_codes, (std::vector<unsigned>{*options.trigger_m_code, 9}));  // coolant: it must fall again
      ASSERT_NEAR(visit.dwell_before_m_code_s[0], visit.dwell_s / 2, dwell_step_s);
      ASSERT_EQ(visit.dwell_before_m_code_s[1], visit.dwell_s);
    } else {
      ASSERT_TRUE(visit.m_codes.empty());
    }
  }
}

/// Validation: the programs' text is run by interpreters that share no code with the writers.
class EveryDialect : public testing::TestWithParam<const Dialect*> {};

TEST_P(EveryDialect, DrivesEveryMoveOfThePlanInOrderDirectionFeedAndDwell) {
  const Dialect& dialect = *GetParam();
  const double dwell_step_s = dialect.id == "fagor" ? 0.01 : 0.001;
  unsigned seed = 0;
  for (TestCycle cycle : all_cycles)
    for (AxisKind kind : {AxisKind::linear, AxisKind::rotary})
      for (LengthUnit unit : {LengthUnit::mm, LengthUnit::inch})
        for (bool unrolled : {false, true})
          for (bool trigger : {false, true})
            for (int repeat = 0; repeat < 3; ++repeat) {
              const Plan plan = AnyPlan(++seed).make(cycle, kind);
              ProgramOptions options{.unit = unit, .unrolled = unrolled, .decimals = repeat + 2};
              if (trigger) options.trigger_m_code = 8;
              options.stop_at_start = repeat == 1;
              options.block_numbers = repeat != 2 || dialect.id == "heidenhain";
              const std::string program = write(dialect, plan, options);
              Trace trace;
              ASSERT_NO_THROW(trace = run_program(dialect.id, program)) << program;
              ASSERT_NO_FATAL_FAILURE(expect_walked(trace, plan, options, dwell_step_s)) << program;
              EXPECT_EQ(trace.axis, plan.axis.name) << "another axis moves";
              for (std::size_t k = 0; k < trace.visits.size(); ++k)
                EXPECT_EQ(trace.visits[k].stops, options.stop_at_start && k == 0 ? 1u : 0u);
            }
}

TEST_P(EveryDialect, LoopsOverTheRunsUnlessTheyShallBeWrittenOut) {
  const Dialect& dialect = *GetParam();
  for (TestCycle cycle : all_cycles) {
    Plan plan = small_plan();
    plan.cycle = cycle;
    if (cycle == TestCycle::user_defined) plan.sequence = approaches(small_plan());
    const std::size_t looped = write(dialect, plan).size();
    const std::size_t unrolled = write(dialect, plan, {.unrolled = true}).size();
    EXPECT_EQ(looped < unrolled, dialect.has_loops) << cycle_name(cycle);
  }
}

TEST_P(EveryDialect, KeepsTextOfPeopleInItsComments) {
  const Dialect& dialect = *GetParam();
  Plan plan = small_plan();
  plan.machine.clear();
  const auto bare = run_program(dialect.id, write(dialect, plan)).visits.size();
  for (const char* nasty :
       {"X) M30 (", "a\nG0 Z-500\n", "; M3 S9999", "\")\nM6", "%\nO9999", "µ ° ß Ä 機械 \xff\xc3", "(MSG, hello)",
        "#1=99", "[[]]", "\r\n\t\x01\x7f", "a very long name that goes on and on and on and on and on and on"}) {
    plan.machine = plan.title = plan.date = plan.clause = nasty;
    const std::string program = write(dialect, plan);
    for (char c : program) ASSERT_TRUE(c == '\r' || c == '\n' || (c >= ' ' && c < '\x7f')) << program;
    Trace trace;
    ASSERT_NO_THROW(trace = run_program(dialect.id, program)) << program;
    EXPECT_EQ(trace.visits.size(), bare) << program;
    EXPECT_EQ(trace.axis, "X") << program;
  }
}

TEST_P(EveryDialect, WritesShortLinesWithoutNegativeZero) {
  const Dialect& dialect = *GetParam();
  Plan plan = small_plan();
  plan.targets.front() = Position::native(-1e-9);
  for (bool unrolled : {false, true}) {
    const std::string program = write(dialect, plan, {.unrolled = unrolled, .trigger_m_code = 8, .decimals = 0});
    ASSERT_TRUE(program.ends_with('\n'));
    for (std::string_view line : testing_support::lines_of(program)) EXPECT_LE(line.size(), 79u) << line;
    EXPECT_FALSE(std::regex_search(program, std::regex("-0\\.0*[^0-9]"))) << program;
  }
}

TEST_P(EveryDialect, NumbersItsBlocksUpwards) {
  const Dialect& dialect = *GetParam();
  Plan plan = small_plan();
  for (const std::size_t runs : {std::size_t{5}, std::size_t{500}, testing_support::as_many(10'000)}) {
    plan.runs = runs;
    const std::string program = write(dialect, plan, {.unrolled = true});
    long last = -1;
    for (std::string_view line : testing_support::lines_of(program)) {
      if (dialect.id != "heidenhain" && !line.starts_with('N')) continue;
      const long number = std::stol(std::string(line.substr(line.starts_with('N'))));
      ASSERT_GT(number, last);
      last = number;
    }
    if (dialect.id == "okuma" || dialect.id == "fagor") {
      EXPECT_LE(last, 9999);
    }
  }
}

TEST_P(EveryDialect, ExplainsItself) {
  const Dialect& dialect = *GetParam();
  EXPECT_EQ(find_dialect(dialect.id), &dialect);
  EXPECT_TRUE(dialect.manual.starts_with("# "));
  EXPECT_NE(dialect.manual.find("single block"), std::string_view::npos);
  EXPECT_TRUE(dialect.extension.starts_with('.'));
}

INSTANTIATE_TEST_SUITE_P(Nc, EveryDialect, testing::ValuesIn(dialect_table().begin(), dialect_table().end()),
                         [](const auto& dialect) {
                           std::string name(dialect.param->id);
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

TEST(Dialects, AreThoseOfTheManual) {
  EXPECT_EQ(dialect_table().size(), 11u);
  EXPECT_EQ(find_dialect("Siemens_840D"), find_dialect("siemens-840d"));
  EXPECT_EQ(find_dialect("nonsense"), nullptr);
}

TEST(Dialects, NameOnlyAxesThatTheirControlsHave) {
  Plan plan = small_plan();
  plan.axis.name = "Q";
  EXPECT_EQ(refusal("fanuc", plan), "found axis \"Q\", expected one of X Y Z U V W for a linear axis");
  plan.axis.name = "";
  EXPECT_EQ(refusal("fanuc", plan), "found axis \"\", expected one of X Y Z U V W for a linear axis");
  for (const char* name : {"C", "XY", "X 1", " ", "X1", "X1=5 Z"}) {
    plan.axis.name = name;
    EXPECT_NE(refusal("fanuc", plan), "") << name;
  }
  plan.axis.name = " x ";
  EXPECT_EQ(refusal("fanuc", plan), "");
  plan.axis.name = "U";
  EXPECT_EQ(refusal("grbl", plan), "found axis \"U\", expected one of X Y Z for a linear axis");
  plan.axis.name = "X1";
  EXPECT_NE(write(*find_dialect("siemens-840d"), plan).find(" X1=20.0000 "), std::string::npos);
  for (const char* name : {"X01", "X1234", "1X", "X1=5", "XX"}) {
    plan.axis.name = name;
    EXPECT_NE(refusal("siemens-840d", plan), "") << name;
  }
}

TEST(Dialects, RefuseOptionsThatTheirControlsDoNotHave) {
  const Plan plan = small_plan();
  EXPECT_EQ(refusal("linuxcnc", plan, {.number = 5}),
            "found program number 5, expected none: the file's name is the program's");
  EXPECT_EQ(refusal("fanuc", plan, {.number = 10'000}), "found program number 10000, expected 1 to 9999");
  EXPECT_EQ(refusal("haas", plan, {.number = 10'000}), "");
  EXPECT_EQ(refusal("fanuc", plan, {.trigger_m_code = 30}),
            "found M30 as trigger, which ends the program, expected one of M7…M8, M24…M28, M57, M150…M189");
  EXPECT_EQ(refusal("linuxcnc", plan, {.trigger_m_code = 62}),
            "found M62 as trigger, which may steer anything on this control, expected one of M7…M8, M100…M199");
  EXPECT_EQ(refusal("fanuc", plan, {.decimals = 7}), "found 7 decimals, expected 0 to 6");
  EXPECT_NE(refusal("heidenhain", plan, {.block_numbers = false}), "");
}

TEST(Dialects, RefusePlansBeyondTheirControls) {
  Plan plan = small_plan();
  plan.targets.back() = Position::native(200'000);
  EXPECT_EQ(refusal("fanuc", plan), "found a way to 200002 mm, expected positions within ±99999.999");
  plan = small_plan();
  plan.feed = 1e-5;
  EXPECT_EQ(refusal("fanuc", plan),
            "found a feed of 1e-05 mm/min, expected one that the control can be told, up to 240000");
  plan.feed = 1e6;
  EXPECT_NE(refusal("linuxcnc", plan), "");
  plan = small_plan();
  plan.dwell = Duration::s(1000);
  EXPECT_EQ(refusal("fagor", plan), "found a dwell of 1000 s, expected at most 999.99");
  EXPECT_EQ(refusal("fanuc", plan), "");
  plan = small_plan();
  plan.targets[1] = Position::native(1e-8);
  EXPECT_EQ(
      refusal("fanuc", plan),
      "found targets, or target and overrun, that are alike with 6 decimals, expected positions that the program can "
      "tell apart");
  plan = small_plan();
  plan.overrun = Position::native(1e-6);
  EXPECT_NE(refusal("fanuc", plan), "");
}

TEST(Dialects, WriteAsManyDecimalsAsTheTargetsNeedAndSaySo) {
  Plan plan = small_plan();
  plan.targets[1] = Position::native(10.12345);
  const std::string program = write(*find_dialect("fanuc"), plan, {.decimals = 3});
  EXPECT_NE(program.find("X10.12345 "), std::string::npos);
  EXPECT_NE(program.find("(COORDINATES WITH 5 DECIMALS, 3 WOULD MOVE TARGETS)"), std::string::npos);
  plan.targets[1] = Position::native(100.0 / 9.0);
  EXPECT_NE(write(*find_dialect("fanuc"), plan).find("ROUNDED BY UP TO 0.0001 UM"), std::string::npos);
  plan.targets = {Position::native(1), Position::native(2), Position::native(3)};
  plan.overrun = Position::native(0.5);
  EXPECT_NE(write(*find_dialect("fanuc"), plan, {.decimals = 0}).find(" X0.5 "), std::string::npos);
  plan.targets = {Position::native(0), Position::native(25.4), Position::native(50.8)};
  EXPECT_NE(write(*find_dialect("fanuc"), plan, {.unit = LengthUnit::inch}).find(" X2.0000 F39.3701 "),
            std::string::npos);
  EXPECT_NE(write(*find_dialect("fanuc"), plan, {.decimals = 0}).find(" X25.4 "), std::string::npos);
}

TEST(Dialects, SayThatACycleIsNotForAcceptance) {
  Plan plan = small_plan();
  plan.cycle = TestCycle::step;
  for (const Dialect* dialect : dialect_table())
    EXPECT_NE(write(*dialect, plan).find("NOT FOR ACCEPTANCE"), std::string::npos) << dialect->id;
}

TEST(Dialects, LoopAsOftenAsThePlanHasRuns) {
  const Plan plan = small_plan();
  const std::map<std::string, std::string> loops = {
      {"fanuc", "WHILE [#1 LE 5] DO1\n"}, {"siemens_840d", "FOR AXM_RUN = 1 TO 5\n"},
      {"heidenhain", " REP 4\r\n"},       {"linuxcnc", " repeat [5]\n"},
      {"okuma", "IF [VC1 LT 5] NR"},      {"fagor", ") N4\r\n"},
  };
  for (const auto& [id, text] : loops) {
    const std::string program = write(*find_dialect(id), plan);
    EXPECT_NE(program.find(text), std::string::npos) << program;
  }
}

}  // namespace
}  // namespace axiometry::nc
