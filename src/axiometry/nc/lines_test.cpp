// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <regex>
#include <set>

#include "axiometry/nc/dialect.h"
#include "tests/support/nc_controls.h"

/// Programs of lines in space: several axes, ways between the lines, several plans in one program.
namespace axiometry::nc {
namespace {

using testing_support::run_program;
using testing_support::Trace;
using testing_support::Visit;

/// Sets of lines as a tracking interferometer needs them, and stranger ones.
class AnyLines {
 public:
  explicit AnyLines(unsigned seed) : random_(seed) {}

  std::vector<Plan> make() {
    std::vector<Plan> plans;
    for (std::size_t k = 1 + below(4); k > 0; --k) plans.push_back(make_line());
    return plans;
  }

  std::size_t below(std::size_t n) { return random_() % n; }

 private:
  Plan make_line() {
    constexpr std::array<std::pair<const char*, Vector3>, 9> lines = {{{"x", {1, 0, 0}},
                                                                       {"y", {0, -1, 0}},
                                                                       {"z", {0, 0, 1}},
                                                                       {"xy", {1, -1, 0}},
                                                                       {"xz", {3, 0, 4}},
                                                                       {"yz", {0, 1, 1}},
                                                                       {"xyz", {1, 1, 1}},
                                                                       {"NNN-PPP", {1000, 600, 500}},
                                                                       {"steep", {0.001, 0.02, -1}}}};
    const auto& [name, direction] = lines[below(lines.size())];
    Plan plan;
    plan.standard = "ISO 230-6:2002";
    plan.axis.name = name;
    set_spatial_line(plan.axis, {point(), direction});
    plan.cycle = below(3) == 0 ? TestCycle::step : TestCycle::standard;
    double position = static_cast<double>(below(900'000)) / 1000.0 - 400.0;
    for (std::size_t i = 0, m = 1 + below(6); i < m; ++i) {
      plan.targets.push_back(Position::native(position));
      position += 0.25 + 0.001 * static_cast<double>(below(200'000));
    }
    plan.runs = 1 + below(5);
    plan.overrun = Position::native(0.5 + 0.25 * static_cast<double>(below(20)));
    plan.feed = 50.0 + static_cast<double>(below(20'000));
    plan.dwell = Duration::s(std::array{0.0, 0.25, 3.0, 4.37}[below(4)]);
    plan.warm_up_runs = below(3);
    for (std::size_t k = below(4); k > 0; --k) plan.way_in_mm.push_back(point());
    for (std::size_t k = below(3); k > 0; --k) plan.way_out_mm.push_back(point());
    return plan;
  }

  Vector3 point() { return {coordinate(), coordinate(), coordinate()}; }
  double coordinate() { return static_cast<double>(below(2'000'000)) / 1000.0 - 1000.0; }

  std::mt19937 random_;
};

/// What the plans ask for, found without the writer.
struct Wanted {
  Vector3 at;
  std::string named;
  const Plan* plan = nullptr;
  std::optional<Approach> approach = {};
  Vector3 way = {};     ///< direction in which an approach must come
  bool begins = false;  ///< the first move on its line
};

std::vector<Wanted> wanted_of(std::span<const Plan> plans) {
  std::vector<Wanted> list;
  for (const Plan& plan : plans) {
    const SpatialLine line = *spatial_line(plan.axis);
    std::string moving;
    for (std::size_t k = 0; k < 3; ++k)
      if (std::abs(line.direction[k]) > 1e-9) moving += "XYZ"[k];
    for (Vector3 point : plan.way_in_mm) list.push_back({point, "XYZ", &plan});
    bool first = true;
    for (const PlannedMove& move : moves(plan)) {
      const bool up = move.approach && move.approach->direction == Direction::up;
      list.push_back({line.at(move.to), first ? "XYZ" : moving, &plan, move.approach,
                      (up ? 1.0 : -1.0) * line.direction, std::exchange(first, false)});
    }
    for (Vector3 point : plan.way_out_mm) list.push_back({point, "XYZ", &plan});
  }
  return list;
}

Vector3 place(const Visit& visit) { return {visit.at.at("X"), visit.at.at("Y"), visit.at.at("Z")}; }

void expect_driven(const Trace& trace, std::span<const Plan> plans, const ProgramOptions& options, double step_s) {
  const std::vector<Wanted> wanted = wanted_of(plans);
  ASSERT_EQ(trace.visits.size(), wanted.size());
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    const Visit& visit = trace.visits[k];
    const Wanted& here = wanted[k];
    ASSERT_EQ(visit.named, here.named) << "move " << k;
    const Vector3 error = place(visit) - here.at;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      ASSERT_LE(std::abs(error[axis]), 0.5 * visit.resolution + 1e-9) << "move " << k;
      if (here.approach) {
        ASSERT_LE(std::abs(error[axis]), 0.5e-4 + 1e-8) << "target moved, " << k;
      }
    }
    ASSERT_NEAR(visit.feed, here.plan->feed, 1e-4 * here.plan->feed);
    const bool stops = here.begins && (options.stop_at_lines || (options.stop_at_start && here.plan == &plans[0]));
    ASSERT_EQ(visit.stops, stops ? 1u : 0u) << "move " << k;
    if (!here.approach) {
      ASSERT_EQ(visit.dwells, 0u) << "move " << k << " dwells on its way";
      ASSERT_TRUE(visit.m_codes.empty());
      continue;
    }
    const Vector3 way = place(visit) - place(trace.visits[k - 1]);
    ASSERT_GT(dot(way, here.way), 0.0) << "move " << k << " comes from the wrong side";
    ASSERT_GE(visit.dwell_s, here.plan->dwell.in_s() - 1e-9);
    ASSERT_LE(visit.dwell_s, here.plan->dwell.in_s() + step_s);
    ASSERT_EQ(visit.m_codes.size(), options.trigger_m_code ? 2u : 0u);  // on and off
    if (options.trigger_m_code) {
      ASSERT_NEAR(visit.dwell_before_m_code_s[0], visit.dwell_s / 2, step_s);
      ASSERT_EQ(visit.dwell_before_m_code_s[1], visit.dwell_s);
    }
  }
}

Plan diagonal() {
  Plan plan;
  plan.standard = "ISO 230-6:2002";
  plan.axis.name = "xy";
  set_spatial_line(plan.axis, {{100, 200, 300}, {1, 1, 0}});
  for (double x : {0.0, 10.0, 20.0}) plan.targets.push_back(Position::native(x));
  plan.overrun = Position::native(2);
  plan.feed = 1000;
  plan.dwell = Duration::s(3);
  return plan;
}

std::string refusal(std::span<const Plan> plans, const ProgramOptions& options = {}) {
  const auto program = find_dialect("fanuc")->write(plans, options);
  return program ? "" : program.error().message;
}

/// Validation: the programs' text is run by interpreters that share no code with the writers.
class LinesInEveryDialect : public testing::TestWithParam<const Dialect*> {};

TEST_P(LinesInEveryDialect, DriveWaysOverrunsAndTargetsInOrderAndDirection) {
  const Dialect& dialect = *GetParam();
  const double step_s = dialect.id == "fagor" ? 0.01 : 0.001;
  unsigned seed = 0;
  for (LengthUnit unit : {LengthUnit::mm, LengthUnit::inch})
    for (bool unrolled : {false, true})
      for (bool trigger : {false, true})
        for (int repeat = 0; repeat < 12; ++repeat) {
          AnyLines any(++seed);
          const std::vector<Plan> plans = any.make();
          ProgramOptions options{.unit = unit, .unrolled = unrolled, .decimals = repeat % 7};
          if (trigger) options.trigger_m_code = 8;
          options.stop_at_start = any.below(2) == 0;
          options.stop_at_lines = any.below(3) == 0;
          options.block_numbers = any.below(2) == 0 || dialect.id == "heidenhain";
          options.title = "Lines (seven)";
          const auto program = dialect.write(plans, options);
          ASSERT_TRUE(program) << program.error().message;
          Trace trace;
          ASSERT_NO_THROW(trace = run_program(dialect.id, *program)) << *program;
          ASSERT_NO_FATAL_FAILURE(expect_driven(trace, plans, options, step_s)) << *program;
          for (std::string_view line : testing_support::lines_of(*program)) ASSERT_LE(line.size(), 79u) << line;
          EXPECT_FALSE(std::regex_search(*program, std::regex("-0\\.0*[^0-9]"))) << *program;
        }
}

TEST_P(LinesInEveryDialect, GoToTheVerySameCoordinatesOnTheWayUpAndDown) {
  const Dialect& dialect = *GetParam();
  Plan plan = diagonal();
  set_spatial_line(plan.axis, {{0.1, 0.2, 0.3}, {3, -2, 7}});
  const auto program = dialect.write({&plan, 1}, {});
  ASSERT_TRUE(program);
  std::set<std::array<double, 3>> places;
  for (const Visit& visit : run_program(dialect.id, *program).visits)
    if (visit.dwells > 0) places.insert({visit.at.at("X"), visit.at.at("Y"), visit.at.at("Z")});
  EXPECT_EQ(places.size(), plan.targets.size());
}

TEST_P(LinesInEveryDialect, KeepTextOfPeopleInTheirComments) {
  const Dialect& dialect = *GetParam();
  std::vector<Plan> plans = {diagonal(), diagonal()};
  plans[1].way_in_mm = {{0, 0, 0}};
  const std::size_t bare = run_program(dialect.id, *dialect.write(plans, {})).visits.size();
  for (const char* nasty : {"X) M30 (", "a\nG0 Z-500\n", "; M3 S9999", "\")\nM6", "%\nO9999", "\r\n\t\x01\x7f",
                            "a very long name that goes on and on and on and on and on and on and on"}) {
    for (Plan& plan : plans) plan.machine = plan.title = plan.date = plan.axis.name = nasty;
    const auto program = dialect.write(plans, {.title = nasty});
    ASSERT_TRUE(program) << program.error().message;
    for (char c : *program) ASSERT_TRUE(c == '\r' || c == '\n' || (c >= ' ' && c < '\x7f')) << *program;
    for (std::string_view line : testing_support::lines_of(*program)) ASSERT_LE(line.size(), 79u) << line;
    Trace trace;
    ASSERT_NO_THROW(trace = run_program(dialect.id, *program)) << *program;
    EXPECT_EQ(trace.visits.size(), bare) << *program;
  }
}

INSTANTIATE_TEST_SUITE_P(Nc, LinesInEveryDialect, testing::ValuesIn(dialect_table().begin(), dialect_table().end()),
                         [](const auto& dialect) {
                           std::string name(dialect.param->id);
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

TEST(Lines, SayWhatTheyAreAndWhereTheyGo) {
  std::vector<Plan> plans = {diagonal(), diagonal()};
  plans[1].axis.name = "z";
  set_spatial_line(plans[1].axis, {{-5.5, 0, 0}, {0, 0, 1}});
  plans[1].standard = "ISO 230-2:2014";
  plans[1].way_in_mm = {{100, 200, 450}};
  const auto program = find_dialect("fanuc")->write(plans, {.title = "Seven lines"});
  ASSERT_TRUE(program);
  for (const char* text :
       {"(TITLE SEVEN LINES)", "(2 LINES, XY, Z)", "(X MOVES FROM -5.5 TO 115.556349 MM)",
        "(Z MOVES FROM -2 TO 450 MM)", "(THE FIRST FROM WHERE THE AXES STAND TO X 98.585786 Y 198.585786 Z 300)",
        "(1 OF 2, LINE XY)", "(TEST ISO 230-6-2002)", "(DIRECTION X 0.707107 Y 0.707107 Z 0)", "(TEST ISO 230-2-2014)",
        "(FEED 1000 MM/MIN ALONG THE PATH, DWELL 3 S)", "G1 X98.5858 Y198.5858 Z300.0000 F1000. (TO LINE XY)\n",
        "G1 X107.0711 Y207.0711 F1000. (TARGET 2 UP)\n", "G1 X100.0000 Y200.0000 Z450.0000 F1000. (WAY IN)\n",
        "G1 X-5.5000 Y0.0000 Z-2.0000 F1000. (TO LINE Z)\n", " G1 Z10.0000 F1000. (TARGET 2 UP)\n",
        "ROUNDED BY UP TO 0.0"})
    EXPECT_NE(program->find(text), std::string::npos) << text << "\n" << *program;
}

TEST(Lines, HaveAsManyDecimalsAsTheirTargetsNeed) {
  const auto words = [](const Plan& plan, int decimals) {
    const auto program = find_dialect("fanuc")->write({&plan, 1}, {.decimals = decimals});
    std::smatch found;
    EXPECT_TRUE(std::regex_search(*program, found, std::regex("\\(COORDINATES[^)]*\\)"))) << *program;
    return found.str();
  };
  Plan plan = diagonal();
  EXPECT_EQ(words(plan, 3), "(COORDINATES WITH 4 DECIMALS, 3 WOULD MOVE TARGETS, ROUNDED BY UP TO 0.0504 UM)");
  for (double x : {0.0, 10.0, 20.0}) {
    const auto i = static_cast<std::size_t>(x / 10.0);
    plan.targets[i] = Position::native(x * std::sqrt(2.0));
  }
  EXPECT_EQ(words(plan, 3), "(COORDINATES WITH 3 DECIMALS)") << "they are on the grid";
  EXPECT_EQ(words(plan, 0), "(COORDINATES WITH 3 DECIMALS, 0 WOULD MOVE WAYS)") << "the overruns are not";
  // Of one axis alone the target is given, not found on a slant: it is exact.
  set_spatial_line(plan.axis, {{0, 1.0 / 3.0, 0}, {1, 0, 0}});
  plan.targets = {Position::native(0), Position::native(10.12345)};
  EXPECT_EQ(words(plan, 3), "(COORDINATES WITH 5 DECIMALS, 3 WOULD MOVE TARGETS, ROUNDED BY UP TO 0.0033 UM)");
}

TEST(Lines, KeepWaysWithinTheTravelsAtFewDecimals) {
  Plan plan;
  set_spatial_line(plan.axis, {{0, 100, -200}, {1, 0, 0}});
  plan.targets = {Position::native(300), Position::native(400)};
  plan.overrun = Position::native(5);
  plan.runs = 2;
  plan.feed = 1000;
  plan.way_in_mm = {{295, 100, -14.21}};  // the upper end of Z
  for (const LengthUnit unit : {LengthUnit::mm, LengthUnit::inch}) {
    const auto program = find_dialect("fanuc")->write({&plan, 1}, {.unit = unit, .decimals = 0});
    ASSERT_TRUE(program) << program.error().message;
    const Trace trace = run_program("fanuc", *program);
    EXPECT_NEAR(trace.visits.front().at.at("Z"), -14.21, 1.28e-3) << *program;
  }
  plan.way_in_mm = {{295, 100, -14}};
  EXPECT_NE(find_dialect("fanuc")->write({&plan, 1}, {.decimals = 0})->find("Z-14. F1000"), std::string::npos);
}

TEST(Lines, AreRefusedWhereTheyCannotBeDriven) {
  EXPECT_EQ(refusal({}), "found no plan, expected at least one");
  Plan plan = diagonal();
  set_spatial_line(plan.axis, {{0, 99'990, 0}, {0, 1, 1}});
  EXPECT_EQ(refusal({&plan, 1}), "found a way to Y 100005.55634918611 mm, expected positions within ±99999.999");
  plan = diagonal();
  plan.way_out_mm = {{0, 0, -1e6}};
  EXPECT_EQ(refusal({&plan, 1}), "found a way to Z -1e+06 mm, expected positions within ±99999.999");
  plan = diagonal();
  plan.targets[1] = Position::native(1e-8);
  EXPECT_EQ(refusal({&plan, 1}),
            "found targets, or target and overrun, that are alike with 6 decimals, expected positions that the "
            "program can tell apart");
  std::vector<Plan> several = {diagonal(), diagonal()};
  several[1].feed = 1e6;
  EXPECT_EQ(refusal(several),
            "found a feed of 1e+06 mm/min, expected one that the control can be told, up to 240000 (plan 2, LINE xy)");
  several[1] = diagonal();
  several[1].axis.line_origin_mm.clear();
  several[1].axis.line_direction.clear();
  several[1].axis.name = "X";
  EXPECT_EQ(refusal(several),
            "found plan 2, LINE X without a line in space among several, expected one for each plan of a program");
}

TEST(Lines, ShareTheLoopsThatAControlHas) {
  std::vector<Plan> plans(300, diagonal());
  const auto program = find_dialect("heidenhain")->write(plans, {});
  ASSERT_TRUE(program);
  EXPECT_NE(program->find(" LBL 254\r\n"), std::string::npos);
  EXPECT_EQ(program->find(" LBL 255\r\n"), std::string::npos);
  const std::string_view told = "AT MOST 254 LOOPS";
  const std::size_t at = program->find(told);
  ASSERT_NE(at, std::string::npos);
  EXPECT_EQ(program->find(told, at + 1), std::string::npos) << "told twice";
  EXPECT_EQ(run_program("heidenhain", *program).visits.size(), wanted_of(plans).size());
}

}  // namespace
}  // namespace axiometry::nc
