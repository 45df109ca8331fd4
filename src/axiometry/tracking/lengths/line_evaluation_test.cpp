// SPDX-License-Identifier: Apache-2.0
//
// Truths come from the simulated machine of line_test_support.h, not from the program.
#include "axiometry/tracking/lengths/line_evaluation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "axiometry/standards/iso230_2/parameters.h"
#include "axiometry/tracking/lines/line_test_support.h"

namespace axiometry::tracking {
namespace {

using namespace testing_support;
using ::testing::HasSubstr;

iso230_2::AxisParameters parameters(const EvaluatedLine& line) {
  return iso230_2::evaluate(line.test.series).parameters;
}

LinesEvaluation evaluated(const TrackingPlan& plan, const std::vector<LengthReading>& readings,
                          const LineEvaluationOptions& options = {}) {
  auto result = evaluate_lines(plan, readings, options);
  if (!result) throw std::logic_error(result.error().message);
  return *std::move(result);
}

std::string message_of(const TrackingPlan& plan, const std::vector<LengthReading>& readings,
                       const LineEvaluationOptions& options = {}) {
  const auto result = evaluate_lines(plan, readings, options);
  return result ? "" : result.error().message;
}

TEST(LineEvaluation, FindsTheDeviationsOfTheMachineUpToAShift) {
  const TrackingPlan plan = two_lines();
  Machine machine;
  machine.noise_mm = 0.0;
  const LinesEvaluation result = evaluated(plan, measured(plan, machine));
  ASSERT_EQ(result.lines.size(), 2u);
  for (std::size_t k = 0; k < 2; ++k) {
    const Series& series = result.lines[k].test.series;
    const auto at = [&](std::size_t i, Direction d) {
      return 1000.0 * deviation_mm(machine, plan.lines[k].plan.targets[i].in_native(), d);
    };
    const double zero = 0.5 * (at(0, Direction::up) + at(0, Direction::down));
    for (std::size_t i = 0; i < series.target_count(); ++i)
      for (const Direction d : {Direction::up, Direction::down})
        for (std::size_t run = 0; run < 5; ++run)
          EXPECT_NEAR(series.reading(i, d, run)->in_native(), at(i, d) - zero, 1e-6);
    EXPECT_TRUE(result.lines[k].breaks.empty());
    EXPECT_NEAR(result.lines[k].distances_mm[2], distances()[2], 1e-9);
    EXPECT_NEAR(parameters(result.lines[k]).B->in_native(), 4.0, 1e-6);
  }
}

TEST(LineEvaluation, StandsOnEitherSideOfTheStation) {
  // The machine's deviation at a target is the same, whichever side the station looks from.
  TrackingPlan plan = two_lines();
  const Machine machine;
  const auto low = evaluated(plan, measured(plan, machine));
  TrackingPlan far = plan;
  far.lines.pop_back();
  far.setup.station.position_mm.x += 700.0;
  const auto high = evaluated(far, measured(far, machine));
  const auto a = parameters(low.lines[0]), b = parameters(high.lines[0]);
  EXPECT_NEAR(a.E->in_native(), b.E->in_native(), 1e-6);
  EXPECT_NEAR(a.R->in_native(), b.R->in_native(), 1e-6);
  EXPECT_NEAR(a.B_mean->in_native(), b.B_mean->in_native(), 1e-6);
  EXPECT_NEAR(low.lines[0].slope_um_per_m, high.lines[0].slope_um_per_m, 1e-5);
}

TEST(LineEvaluation, DoesNotDependOnWhereTheInstrumentWasSetToZero) {
  const TrackingPlan plan = two_lines();
  const auto one = evaluated(plan, measured(plan, {}));
  const auto two = evaluated(plan, measured(plan, {}, {[](const std::string&, std::size_t) { return 1234.5; }}));
  for (std::size_t k = 0; k < 2; ++k)
    for (std::size_t i = 0; i < 7; ++i)
      EXPECT_NEAR(one.lines[k].test.series.reading(i, Direction::down, 3)->in_native(),
                  two.lines[k].test.series.reading(i, Direction::down, 3)->in_native(), 1e-6);
}

TEST(LineEvaluation, KeepsTheSlopeAndStatesItsUncertainty) {
  const TrackingPlan plan = two_lines();
  Machine machine;
  machine.wave_mm = 0.0;
  double squares = 0.0;
  constexpr unsigned trials = 200;
  for (machine.seed = 1; machine.seed <= trials; ++machine.seed) {
    const auto result = evaluated(plan, measured(plan, machine));
    const EvaluatedLine& line = result.lines[1];
    const double z = (line.slope_um_per_m - 25.0) / line.slope_uncertainty_um_per_m;
    squares += z * z;
    EXPECT_NEAR(line.slope_um_per_m, 25.0, 5.0);
  }
  // Student's t of some freedoms or less: its variance is above 1, and the larger of two estimates is taken.
  EXPECT_GT(squares / trials, 0.3);
  EXPECT_LT(squares / trials, 1.8);
}

TEST(LineEvaluation, TiesTheLengthsAgainAfterABreakOfTheBeam) {
  const TrackingPlan plan = two_lines();
  const Machine machine;
  const auto whole = evaluated(plan, measured(plan, machine));
  for (const double jump : {-0.06, 0.5, -11.7, 300.0})
    for (const std::size_t before : {5u, 7u, 20u, 35u, 42u, 60u}) {
      const auto broken = evaluated(plan, measured(plan, machine, {[&](const std::string& id, std::size_t k) {
                                                     return id == "x" && k >= before ? -212.7 + jump : -212.7;
                                                   }}));
      const EvaluatedLine& line = broken.lines[0];
      ASSERT_EQ(line.breaks.size(), 1u) << jump << " before " << before;
      EXPECT_EQ(line.breaks[0].before_reading, before);
      EXPECT_NEAR(line.breaks[0].jump_mm, jump, 0.003);
      ASSERT_EQ(line.dead_paths.size(), 2u);
      const double shift = line.dead_paths[1].dead_path_mm - line.dead_paths[0].dead_path_mm;
      EXPECT_NEAR(shift, jump, 5.0 * line.dead_paths[1].uncertainty_mm);
      EXPECT_LT(line.dead_paths[1].uncertainty_mm, 0.0004);
      EXPECT_NEAR(parameters(line).E->in_native(), parameters(whole.lines[0]).E->in_native(), 0.5);
      EXPECT_NEAR(parameters(line).B->in_native(), parameters(whole.lines[0]).B->in_native(), 0.8);
      ASSERT_TRUE(line.test.as_measured);
      EXPECT_GT(iso230_2::evaluate(*line.test.as_measured).parameters.A->in_native(), 20.0);
      EXPECT_EQ(line.test.provenance.corrections.at(0).id, "beam-breaks");
      EXPECT_TRUE(broken.lines[1].breaks.empty());
    }
}

TEST(LineEvaluation, TakesNoReversalErrorForABreak) {
  TrackingPlan plan = two_lines();
  for (const TestCycle cycle : {TestCycle::standard, TestCycle::step, TestCycle::pilgrim})
    for (const std::size_t runs : {1u, 2u, 5u}) {
      plan = two_lines(runs, cycle);
      Machine machine;
      machine.reversal_mm = 0.15;
      machine.scale = 400e-6;
      const auto result = evaluated(plan, measured(plan, machine));
      for (const EvaluatedLine& line : result.lines) {
        EXPECT_TRUE(line.breaks.empty()) << cycle_name(cycle) << runs;
        EXPECT_NEAR(std::abs(parameters(line).B_mean->in_native()), 150.0, 1.0);
      }
      EXPECT_TRUE(result.findings.empty()) << result.findings.front().message;
    }
}

TEST(LineEvaluation, KeepsASingleReadingThatLiesApart) {
  const TrackingPlan plan = two_lines();
  auto readings = measured(plan, {});
  readings[30].length_difference_mm += 0.7;
  const auto result = evaluated(plan, readings);
  EXPECT_TRUE(result.lines[0].breaks.empty());
  EXPECT_EQ(result.lines[0].dead_paths.size(), 1u);
  EXPECT_GT(parameters(result.lines[0]).R->in_native(), 1000.0);
  ASSERT_EQ(result.findings.size(), 1u);
  EXPECT_TRUE(result.findings[0].serious);
  EXPECT_EQ(result.findings[0].id, "lines-outlier");
  EXPECT_THAT(result.findings[0].message, HasSubstr("reading 31"));
}

TEST(LineEvaluation, TakesAFarReadingAtAnEndForOneBehindABreak) {
  const TrackingPlan plan = two_lines();
  const auto whole = evaluated(plan, measured(plan, {}));
  for (const std::size_t before : {1u, 69u}) {
    const auto broken = evaluated(plan, measured(plan, {}, {[&](const std::string& id, std::size_t k) {
                                                   return id == "x" && k >= before ? -472.7 : -212.7;
                                                 }}));
    const EvaluatedLine& line = broken.lines[0];
    ASSERT_EQ(line.breaks.size(), 1u) << before;
    EXPECT_EQ(line.breaks[0].before_reading, before);
    EXPECT_NEAR(line.breaks[0].jump_mm, -260.0, 0.005);
    EXPECT_THAT(broken.findings.back().message, HasSubstr("alone has a dead path of its own"));
    EXPECT_EQ(broken.findings.back().id, "lines-lone-reading");
    EXPECT_EQ(broken.findings.front().id, "lines-beam-broken");
    EXPECT_TRUE(broken.findings.back().serious);
    EXPECT_NEAR(parameters(line).E->in_native(), parameters(whole.lines[0]).E->in_native(), 0.5);
    EXPECT_NEAR(parameters(line).R->in_native(), parameters(whole.lines[0]).R->in_native(), 1.0);
  }
  // Nearer it may be a bad reading as well: kept, and told.
  auto readings = measured(plan, {});
  readings[69].length_difference_mm += 0.7;
  const auto apart = evaluated(plan, readings);
  EXPECT_TRUE(apart.lines[0].breaks.empty());
  EXPECT_GT(parameters(apart.lines[0]).R->in_native(), 500.0);
  EXPECT_TRUE(apart.findings.at(0).serious);
}

TEST(LineEvaluation, TellsTwoBreaksInARowFromABadReading) {
  const TrackingPlan plan = two_lines();
  const auto whole = evaluated(plan, measured(plan, {}));
  const auto broken = evaluated(plan, measured(plan, {}, {[](const std::string& id, std::size_t k) {
                                                 return id != "x" || k < 30 ? 0.0 : k == 30 ? 0.9 : 0.25;
                                               }}));
  const EvaluatedLine& line = broken.lines[0];
  ASSERT_EQ(line.breaks.size(), 2u);
  EXPECT_NEAR(line.breaks[0].jump_mm, 0.9, 0.005);
  EXPECT_NEAR(line.breaks[1].jump_mm, -0.65, 0.005);
  EXPECT_NEAR(parameters(line).E->in_native(), parameters(whole.lines[0]).E->in_native(), 0.5);
  EXPECT_NEAR(parameters(line).R->in_native(), parameters(whole.lines[0]).R->in_native(), 1.0);
}

TEST(LineEvaluation, SaysWhereALineIsSplit) {
  // One way only, once: nothing ties the two parts.
  const TrackingPlan plan = two_lines(1, TestCycle::unidirectional);
  const auto result = evaluated(
      plan, measured(plan, {}, {[](const std::string& id, std::size_t k) { return id == "x" && k >= 3 ? 5.0 : 0.0; }}));
  ASSERT_EQ(result.lines[0].dead_paths.size(), 2u);
  EXPECT_FALSE(result.lines[0].dead_paths[1].tied);
  EXPECT_TRUE(result.findings.at(0).serious || result.findings.at(1).serious);
  EXPECT_TRUE(result.lines[0].test.provenance.remarks.back().departs);
}

TEST(LineEvaluation, TakesStatedSegmentsAsTheyAre) {
  const TrackingPlan plan = two_lines();
  auto readings = measured(plan, {}, {[](const std::string&, std::size_t k) { return k < 26 ? 0.0 : 0.004; }});
  for (std::size_t k = 26; k < 70; ++k) readings[k].segment = 1;
  const auto result = evaluated(plan, readings);
  EXPECT_TRUE(result.lines[0].breaks.empty());
  ASSERT_EQ(result.lines[0].dead_paths.size(), 2u);
  EXPECT_NEAR(result.lines[0].dead_paths[1].dead_path_mm - result.lines[0].dead_paths[0].dead_path_mm, 0.004, 0.0008);
  EXPECT_EQ(result.lines[0].dead_paths[1].first_reading, 26u);
}

TEST(LineEvaluation, CountsDistancesFromTheStationAsItWasLocated) {
  // A station 0.8 mm beside the planned one bends the lengths near it; the located one straightens them.
  TrackingPlan plan = two_lines();
  Machine machine;
  machine.noise_mm = machine.wave_mm = 0.0;
  TrackingPlan actual = plan;
  actual.setup.station.position_mm += Vector3{0.1, 0.8, -0.3};
  const auto readings = measured(actual, machine);
  EXPECT_GT(evaluated(plan, readings).lines[0].slope_uncertainty_um_per_m, 0.1);
  const auto located = evaluated(actual, readings);
  EXPECT_NEAR(located.lines[0].slope_um_per_m, 25.0, 1e-3);
}

TEST(LineEvaluation, DescribesTheTestOfEveryLine) {
  const TrackingPlan plan = two_lines();
  const auto result = evaluated(plan, measured(plan, {}));
  const Metadata& m = result.lines[1].test.metadata;
  EXPECT_EQ(m.axis.name, "XZ");
  EXPECT_TRUE(is_diagonal(m.axis));
  EXPECT_EQ(m.machine.name, "Mill 5");
  EXPECT_EQ(m.conditions.tool_offset_mm, (std::vector<double>{0.0, 12.0, -120.0}));
  EXPECT_EQ(m.conditions.feed, 1000.0);
  EXPECT_TRUE(m.machine.axes_travel.starts_with("X ")) << m.machine.axes_travel;
  EXPECT_TRUE(m.conditions.axes_not_under_test.starts_with("Y = ")) << m.conditions.axes_not_under_test;
  EXPECT_NEAR(m.tracking.station_position->in_native(), 0.0, 1e-9);
  ASSERT_EQ(m.tracking.station_uncertainty_mm.size(), 2u);
  EXPECT_NEAR(m.tracking.station_uncertainty_mm[0], std::sqrt((4e-6 + 25e-6) / 2.0), 1e-9);
  EXPECT_NEAR(m.tracking.station_uncertainty_mm[1], 0.003, 1e-9);
  EXPECT_NEAR(m.uncertainty.device_calibration->in_native(), 0.2 + 0.3 * 0.2561, 1e-9);
  EXPECT_NEAR(result.lines[0].test.metadata.tracking.station_position->in_native(), 480.0, 1e-9);
  LineEvaluationOptions options;
  options.metadata.uncertainty.device_error_range = RelativeLength::um_per_m(2.0);
  EXPECT_FALSE(evaluated(plan, measured(plan, {}), options).lines[0].test.metadata.uncertainty.device_calibration);
}

TEST(LineEvaluation, EstimatesSquarenessFromTheSlopes) {
  const TrackingPlan plan = two_lines();
  Machine machine;
  machine.noise_mm = machine.wave_mm = machine.reversal_mm = 0.0;
  const auto result = evaluated(plan, measured(plan, machine));
  ASSERT_TRUE(result.squareness);
  EXPECT_NEAR(*result.squareness->terms[0].value_um_per_m, 25.0, 1e-4);
  EXPECT_FALSE(result.squareness->terms[1].value_um_per_m);
}

TEST(LineEvaluation, RefusesLengthsThatNoPositionExplains) {
  const TrackingPlan plan = two_lines();
  const auto good = measured(plan, {});
  const auto changed = [&](double factor) {
    auto readings = good;
    for (LengthReading& r : readings) r.length_difference_mm *= factor;
    return readings;
  };
  EXPECT_THAT(message_of(plan, changed(1000.0)), HasSubstr("µm read as mm"));
  EXPECT_THAT(message_of(plan, changed(0.001)), HasSubstr("lengths in m"));
  EXPECT_THAT(message_of(plan, changed(1.3)), HasSubstr("another plan"));
  EXPECT_THAT(message_of(plan, changed(0.0)), HasSubstr("0 times"));
  EXPECT_THAT(message_of(plan, changed(-1.0)), HasSubstr("the instrument counts the other way"));
  LineEvaluationOptions reversed;
  reversed.reversed = true;
  EXPECT_EQ(message_of(plan, changed(-1.0), reversed), "");
  EXPECT_NEAR(parameters(evaluated(plan, changed(-1.0), reversed).lines[0]).E->in_native(),
              parameters(evaluated(plan, good).lines[0]).E->in_native(), 1e-9);
}

TEST(LineEvaluation, RefusesLengthsInDisorderThatHideEachOther) {
  // All scatter so much that nothing of it is a break, and none is so far off that it is at another target.
  const TrackingPlan plan = two_lines();
  auto readings = measured(plan, {});
  std::mt19937 random(5);
  for (std::size_t k = 0; k < 70; ++k)
    readings[k].length_difference_mm += 3.0 * static_cast<double>(random()) / 4294967295.0 - 1.5;
  EXPECT_THAT(message_of(plan, readings), HasSubstr("no machine exceeds"));
  LineEvaluationOptions as_it_is;
  as_it_is.find_breaks = false;
  EXPECT_EQ(message_of(plan, readings, as_it_is), "");
}

TEST(LineEvaluation, RefusesWhatIsNoReadingOfThePlan) {
  const TrackingPlan plan = two_lines();
  const auto good = measured(plan, {});
  auto readings = good;
  readings[3].line = "yz";
  EXPECT_THAT(message_of(plan, readings), HasSubstr("expected one of the plan's: x, xz"));
  readings = good;
  readings[3].approach.target = 7;
  EXPECT_THAT(message_of(plan, readings), HasSubstr("target 8"));
  readings = good;
  readings[3].approach = readings[2].approach;
  EXPECT_THAT(message_of(plan, readings), HasSubstr("twice"));
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(), 1e7}) {
    readings = good;
    readings[3].length_difference_mm = bad;
    EXPECT_THAT(message_of(plan, readings), HasSubstr("expected one up to 1e6 mm"));
  }
  EXPECT_THAT(message_of(plan, {}), HasSubstr("found no lengths"));
  EXPECT_THAT(message_of(plan, {good[0]}), HasSubstr("at least two"));
  EXPECT_EQ(message_of(plan, {good[0], good[1]}), "");
  TrackingPlan past = plan;
  past.setup.station.position_mm.x += 300.0;
  EXPECT_THAT(message_of(past, good), HasSubstr("past the station"));
}

TEST(LineEvaluation, LeavesOutTargetsWithoutReadingsAndSaysSo) {
  const TrackingPlan plan = two_lines();
  auto readings = measured(plan, {});
  std::erase_if(readings, [](const LengthReading& r) { return r.line == "x" && r.approach.target == 2; });
  const auto result = evaluated(plan, readings);
  EXPECT_EQ(result.lines[0].test.series.target_count(), 6u);
  EXPECT_EQ(result.lines[0].distances_mm.size(), 6u);
  EXPECT_TRUE(result.lines[0].test.provenance.remarks.back().departs);
}

}  // namespace
}  // namespace axiometry::tracking
