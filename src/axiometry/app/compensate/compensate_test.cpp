// SPDX-License-Identifier: Apache-2.0
//
// What a table does with an older one, with the periodic part, with a number beside it and with a turned sign.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "axiometry/app/compensate/compensate.h"
#include "axiometry/app/compensate/compensate_options.h"
#include "axiometry/base/json/json.h"
#include "axiometry/language/language.h"
#include "tests/support/document_parts.h"
#include "tests/support/series.h"

namespace axiometry::app {
namespace {

using compensation::Periodic;
using ReadingRuns = std::vector<testing_support::RunDeviations>;

/// 21 targets over 500 mm, three runs; ↓ lies `reversal` above ↑.
NamedTest axis_of(double slope, double periodic, double reversal) {
  std::vector<double> targets;
  for (int i = 0; i < 21; ++i) targets.push_back(23.0 * i + 10.0 * std::fmod(i * std::numbers::phi, 1.0));
  ReadingRuns up, down;
  for (int j = 0; j < 3; ++j) {
    testing_support::RunDeviations run_up, run_down;
    for (std::size_t i = 0; i < targets.size(); ++i) {
      const double value = slope * targets[i] + periodic * std::sin(2.0 * std::numbers::pi * targets[i] / 10.0);
      run_up.push_back(value + 0.02 * static_cast<double>((3 * i + 2 * static_cast<std::size_t>(j)) % 5));
      run_down.push_back(value + reversal + 0.02 * static_cast<double>((2 * i + static_cast<std::size_t>(j)) % 5));
    }
    up.push_back(run_up);
    down.push_back(run_down);
  }
  axiometry::Test test{{}, testing_support::make_series(targets, up, down), {}};
  test.metadata.axis.name = "X";
  return {"x.csv", std::move(test)};
}

bool has_finding(const CompensatedAxis& made, std::string_view id) {
  return std::ranges::find(made.findings, id, &NamedFinding::id) != made.findings.end();
}

TEST(Compensate, AnOlderTableIsReadInTheUnitThatIsSaid) {
  CompensateRequest in_mm{.control = "linuxcnc"}, in_inch = in_mm;
  in_inch.table.in_inch = true;
  const auto old_mm = compensate({axis_of(0.05, 0, 4)}, in_mm), old_inch = compensate({axis_of(0.05, 0, 4)}, in_inch);
  ASSERT_TRUE(old_mm && old_inch);
  const auto with = [](const std::string& old_table, CompensateRequest request, std::optional<bool> unit) {
    request.existing_in_inch = unit;
    return compensate({axis_of(0.02, 0, 2), NamedTable{"old.comp", old_table}}, request);
  };
  const auto of_mm = with(old_mm->text, in_mm, {}), of_inch = with(old_inch->text, in_mm, true);
  ASSERT_TRUE(of_mm) << of_mm.error().message;
  ASSERT_TRUE(of_inch) << of_inch.error().message;
  ASSERT_EQ(of_mm->applied.positions().size(), of_inch->applied.positions().size());
  for (std::size_t k = 0; k < 21; ++k)
    EXPECT_NEAR(of_mm->applied.values(Direction::down)[k], of_inch->applied.values(Direction::down)[k], 2e-3);
  EXPECT_NEAR(of_mm->applied.at(400.0, Direction::up), -(0.05 + 0.02) * 400.0, 3.5) << "old and change, less the zero";
  EXPECT_FALSE(with(old_inch->text, in_mm, {}));
  EXPECT_FALSE(with(old_mm->text, in_inch, {}));
  in_mm.grid.step = 50.0;
  EXPECT_FALSE(with(old_inch->text, in_mm, {})) << "not even where its positions are not taken";
}

/// Every 50 mm over 500 mm.
NamedTest evenly_measured(double slope, double bow) {
  std::vector<double> targets;
  ReadingRuns up(3), down(3);
  for (int i = 0; i <= 10; ++i) {
    const double p = 50.0 * i;
    targets.push_back(p);
    for (std::size_t j = 0; j < 3; ++j) {
      const double x = slope * p + bow * std::sin(p / 80.0) + 0.05 * static_cast<double>((3 * i + 2 * j) % 5);
      up[j].push_back(x);
      down[j].push_back(x + 1.0);  // as play leaves it: Ix86 of PMAC has no other sign
    }
  }
  axiometry::Test test{{}, testing_support::make_series(targets, up, down), {}};
  test.metadata.axis.name = "X";
  return {"x.csv", std::move(test)};
}

/// A control whose points lead on to its reference point reads its own table as it was asked for.
TEST(Compensate, TheJsonSaysOfWhichFileAndByWhichProgram) {
  NamedTest measured = axis_of(0.05, 0, 4), retest = axis_of(0.001, 0, 0.1);
  measured.test.provenance.file = "before.csv";
  retest.test.provenance.file = "after.csv";
  const auto made = compensate({std::move(measured), {}, std::move(retest)}, {.control = "linuxcnc"});
  ASSERT_TRUE(made) << made.error().to_string();
  const json::Value result = present(*made, {}).json;
  EXPECT_EQ(result.find("source")->find("file")->text(), "before.csv");
  EXPECT_EQ(result.find("retest")->find("source")->find("file")->text(), "after.csv");
  EXPECT_EQ(result.find("program")->find("name")->text(), "axiometry");
}

TEST(Compensate, AnOlderTableLeadsOnToAReferenceBeyondItsTargets) {
  for (const char* control : {"fanuc", "fanuc-bidirectional", "pmac"})
    for (const double reference : {500.0, 600.0, 0.0, -100.0}) {
      SCOPED_TRACE(std::string(control) + ' ' + std::to_string(reference));
      CompensateRequest request{.control = control, .resolution_said = true};
      request.table.reference = reference;
      request.table.resolution = 0.1;
      if (request.control != "pmac") request.table.largest = 127;
      const auto first = compensate({evenly_measured(0.02, 3.0)}, request);
      ASSERT_TRUE(first) << first.error().message;
      const auto next = compensate({evenly_measured(0.01, 0.5), NamedTable{"old.txt", first->text}}, request);
      ASSERT_TRUE(next) << next.error().message;
      EXPECT_EQ(next->existing->positions().front(), 0.0);
      EXPECT_EQ(next->existing->positions().back(), 500.0);
      EXPECT_FALSE(has_finding(*next, "compensation-existing-cut"));
      EXPECT_FALSE(has_finding(*next, "compensation-ends-held"));
    }
}

/// Beyond its last entry PMAC goes on to its first: where targets lie there the table holds its ends itself.
TEST(Compensate, ATableThatRollsOverHoldsItsEndsOverAllTargets) {
  CompensateRequest request{.control = "pmac", .grid = {.start = 100.0, .end = 400.0, .step = 100.0}};
  request.table.resolution = 0.1;
  request.resolution_said = true;
  const auto first = compensate({evenly_measured(0.02, 3.0)}, request);
  ASSERT_TRUE(first) << first.error().message;
  EXPECT_EQ(first->applied.positions().front(), 0.0);
  EXPECT_EQ(first->applied.positions().back(), 500.0);
  for (const Direction direction : {Direction::up, Direction::down}) {
    EXPECT_EQ(first->applied.at(0.0, direction), first->applied.at(100.0, direction));
    EXPECT_EQ(first->applied.at(500.0, direction), first->applied.at(400.0, direction));
  }
  const auto found = std::ranges::find(first->findings, "compensation-rolls-over", &NamedFinding::id);
  ASSERT_NE(found, first->findings.end());
  EXPECT_TRUE(language::is_known(found->message, language::Language::german)) << found->message;
  const report::Document shown = present(*first, {}).document;
  const report::Table table = testing_support::tables(testing_support::section(shown, "table")).front();
  EXPECT_TRUE(plain_text(table.notes.front()).ends_with("beyond the ends it does not hold the last value."));
  request.grid = {};
  const auto next = compensate({evenly_measured(0.01, 0.5), NamedTable{"old.pmc", first->text}}, request);
  ASSERT_TRUE(next) << next.error().message;
  EXPECT_EQ(next->existing->positions().back(), 500.0);
  EXPECT_FALSE(has_finding(*next, "compensation-existing-cut"));
  const std::string short_of_targets = "; range 0 to 400\n#1 DEFINE COMP 5,500000\n16\n32\n48\n64\n0\nI51=1\n";
  const auto rolled = compensate({evenly_measured(0.01, 0.5), NamedTable{"old.pmc", short_of_targets}},
                                 {.control = "pmac", .curves = TableCurves::both_ways});
  ASSERT_FALSE(rolled) << "what it did at 500 mm was the value at 0";
  EXPECT_NE(rolled.error().message.find("goes on to that of the other end"), std::string::npos);
  EXPECT_TRUE(language::is_known(rolled.error().message, language::Language::german)) << rolled.error().message;
}

/// Every 30° over a turn.
NamedTest turned() {
  std::vector<double> targets;
  ReadingRuns up(3), down(3);
  for (int i = 0; i <= 12; ++i) {
    targets.push_back(30.0 * i);
    for (std::size_t j = 0; j < 3; ++j) {
      const double x = 9.0 * std::sin(i * std::numbers::pi / 6.0) + 0.05 * static_cast<double>((3 * i + 2 * j) % 5);
      up[j].push_back(x);
      down[j].push_back(x + 1.0);
    }
  }
  axiometry::Test test{{}, testing_support::make_series(targets, up, down), {}};
  test.metadata.axis.name = "C";
  test.metadata.axis.kind = AxisKind::rotary;
  return {"c.csv", std::move(test)};
}

/// It would meet its other end before the targets end: 330° and 360° had the values at 0° and 30°, and were foretold
/// those of 300°.
TEST(Compensate, ATableThatRollsOverWithinATurnClosesIt) {
  CompensateRequest request{.control = "pmac", .grid = {.start = 30.0, .end = 300.0, .step = 30.0}};
  request.table.resolution = 0.1;
  request.resolution_said = true;
  const auto made = compensate({turned()}, request);
  ASSERT_TRUE(made) << made.error().message;
  EXPECT_NEAR(made->applied.positions().front(), 0.0, 1e-9);
  EXPECT_NEAR(made->applied.positions().back(), 360.0, 1e-9);
  for (const Direction direction : {Direction::up, Direction::down}) {
    EXPECT_EQ(made->applied.at(0.0, direction), made->applied.at(30.0, direction));
    EXPECT_EQ(made->applied.at(330.0, direction), made->applied.at(300.0, direction));
    EXPECT_EQ(made->applied.at(360.0, direction), made->applied.at(0.0, direction));
  }
  EXPECT_FALSE(has_finding(*made, "compensation-rolls-over"));
  request.grid = {.start = 100.0, .end = 300.0, .step = 100.0};
  const auto untold = compensate({turned()}, request);
  ASSERT_FALSE(untold) << "of steps of 100° there are 3.6 in a turn";
  EXPECT_NE(untold.error().message.find("steps that divide a turn"), std::string::npos) << untold.error().message;
  EXPECT_TRUE(language::is_known(untold.error().message, language::Language::german)) << untold.error().message;
}

TEST(Compensate, AScaleThatIsLeftOutIsTold) {
  CompensateRequest request{.control = "marlin"};
  const auto untold = compensate({evenly_measured(0.02, 3.0)}, request);
  ASSERT_TRUE(untold) << untold.error().message;
  const auto found = std::ranges::find(untold->findings, "compensation-scale-left-out", &NamedFinding::id);
  ASSERT_NE(found, untold->findings.end());
  EXPECT_TRUE(language::is_known(found->message, language::Language::german)) << found->message;
  request.table.steps_per_unit = 200.0;
  const auto told = compensate({evenly_measured(0.02, 3.0)}, request);
  ASSERT_TRUE(told) << told.error().message;
  EXPECT_FALSE(has_finding(*told, "compensation-scale-left-out"));
}

TEST(Compensate, ATableOfAnotherCountIsRefused) {
  for (const char* control : {"fanuc", "pmac"}) {
    CompensateRequest request{.control = control, .resolution_said = true};
    request.table.resolution = 0.1;
    if (request.control != "pmac") request.table.largest = 127;
    const auto first = compensate({evenly_measured(0.02, 3.0)}, request);
    ASSERT_TRUE(first) << first.error().message;
    CompensateRequest forgotten{.control = control};
    forgotten.table.largest = request.table.largest;
    const auto next = compensate({evenly_measured(0.004, 0.0), NamedTable{"old.txt", first->text}}, forgotten);
    ASSERT_FALSE(next) << control;
    EXPECT_NE(next.error().message.find("counts of"), std::string::npos) << next.error().message;
    EXPECT_TRUE(language::is_known(next.error().message, language::Language::german)) << next.error().message;
  }
}

TEST(Compensate, ACountThatNobodySaysIsSeriousWhereATableWasReadWithIt) {
  CompensateRequest request{.control = "pmac"};
  const auto first = compensate({evenly_measured(0.02, 3.0)}, request);
  ASSERT_TRUE(first) << first.error().message;
  const auto next = compensate({evenly_measured(0.01, 0.5), NamedTable{"old.txt", first->text}}, request);
  ASSERT_TRUE(next) << next.error().message;
  const auto found = std::ranges::find(next->findings, "compensation-count-assumed", &NamedFinding::id);
  ASSERT_NE(found, next->findings.end());
  EXPECT_TRUE(found->serious);
  EXPECT_TRUE(language::is_known(found->message, language::Language::german)) << found->message;
  request.resolution_said = true;
  const auto said = compensate({evenly_measured(0.01, 0.5), NamedTable{"old.txt", first->text}}, request);
  ASSERT_TRUE(said) << said.error().message;
  EXPECT_FALSE(has_finding(*said, "compensation-count-assumed"));
}

TEST(Compensate, ALongTableIsNotTakenForOneInInches) {
  // 2 m of table, and a test of its first 480 mm: nothing speaks for another unit.
  const auto made = compensate({axis_of(0.02, 0, 2), NamedTable{"old.comp", "0 0 0\n2000 2000.01 2000.01\n"}},
                               {.control = "linuxcnc", .hold_ends = true});
  ASSERT_TRUE(made) << made.error().message;
  EXPECT_NEAR(made->applied.positions().back(), 2000.0, 1e-9);
}

TEST(Compensate, ThePeriodicPartIsLeftOrKeptAsIsSaid) {
  CompensateRequest request{.control = "siemens-cec", .grid = {.start = 20.0, .end = 460.0, .step = 20.0}};
  const auto kept = compensate({axis_of(0.05, 2.0, 4)}, request);
  ASSERT_TRUE(kept) << kept.error().message;
  EXPECT_FALSE(kept->periodic) << "nobody says a period";
  request.period = 10.0;
  const auto told = compensate({axis_of(0.05, 2.0, 4)}, request);
  ASSERT_TRUE(told);
  EXPECT_EQ(told->text, kept->text);
  EXPECT_TRUE(has_finding(*told, "compensation-periodic-aliased"));
  request.periodic = Periodic::leave;
  const auto left = compensate({axis_of(0.05, 2.0, 4)}, request);
  ASSERT_TRUE(left) << left.error().message;
  EXPECT_TRUE(has_finding(*left, "compensation-periodic-left"));
  EXPECT_FALSE(has_finding(*left, "compensation-periodic-aliased"));
  // The table without it is that of the straight axis, and the prediction has it: its range is twice the amplitude.
  double off_straight_left = 0.0, off_straight_kept = 0.0;
  for (std::size_t k = 0; k < left->applied.positions().size(); ++k) {
    const double straight = -0.05 * left->applied.positions()[k];
    const auto off = [&](const CompensatedAxis& made) {
      return std::abs(made.applied.values(Direction::up)[k] - made.applied.values(Direction::up)[0] - straight - 1.0);
    };
    off_straight_left = std::max(off_straight_left, off(*left));
    off_straight_kept = std::max(off_straight_kept, off(*told));
  }
  EXPECT_LT(off_straight_left, 0.2);
  EXPECT_GT(off_straight_kept, 0.8);
  EXPECT_NEAR(left->predicted.parameters.E->in_native(), 4.0, 0.4);
}

TEST(Compensate, TheTestItselfSaysThePeriod) {
  NamedTest axis = axis_of(0.05, 2.0, 4);
  axis.test.metadata.axis.expected_period = Position::native(10.0);
  const auto made = compensate({std::move(axis)}, {.control = "linuxcnc", .periodic = Periodic::leave});
  ASSERT_TRUE(made) << made.error().message;
  ASSERT_TRUE(made->periodic);
  EXPECT_NEAR(made->periodic->directions[0]->amplitude, 2.0, 0.1);
  const json::Value json = present(*made, {}).json;
  EXPECT_EQ(json.find("periodic")->find("choice")->text(), "leave");
  EXPECT_TRUE(json.find("periodic")->find("up")->find("significant")->boolean());
}

TEST(Compensate, ANumberBesideTheTableIsPredictedWithIt) {
  const auto one = compensate({axis_of(0.05, 0, 4)}, {.control = "siemens-lec"});
  const auto both = compensate({axis_of(0.05, 0, 4)}, {.control = "siemens-lec", .curves = TableCurves::with_backlash});
  ASSERT_TRUE(one && both);
  EXPECT_NEAR(std::abs(one->predicted.parameters.B->in_native()), 4.0, 0.1);
  EXPECT_LT(std::abs(both->predicted.parameters.B->in_native()), 0.1);
  EXPECT_EQ(one->text.find("MD32450"), std::string::npos);
  EXPECT_NE(both->text.find("; MD32450 = its value while the axis was measured + 0.00"), std::string::npos)
      << both->text;
  EXPECT_TRUE(has_finding(*both, "compensation-number-beside"));
  // The next table's number counts from what the control had during its test, whether or not a comment tells that.
  const auto next = compensate({axis_of(0.01, 0, 1.0), NamedTable{"old.ini", both->text}},
                               {.control = "siemens-lec", .curves = TableCurves::with_backlash});
  ASSERT_TRUE(next) << next.error().message;
  EXPECT_NEAR(next->applied.at(100.0, Direction::up) - next->applied.at(100.0, Direction::down), 1.0, 0.1);
  const auto of_control = compensate({axis_of(0.01, 0, 1.0), NamedTable{"old.ini", one->text}},
                                     {.control = "siemens-lec", .curves = TableCurves::with_backlash});
  ASSERT_TRUE(of_control) << of_control.error().message;
  EXPECT_NEAR(of_control->applied.at(100.0, Direction::up) - of_control->applied.at(100.0, Direction::down), 1.0, 0.1);
  const auto taken_back = compensate({axis_of(0.01, 0, -4.0), NamedTable{"old.ini", both->text}},
                                     {.control = "siemens-lec", .curves = TableCurves::with_backlash});
  ASSERT_TRUE(taken_back) << taken_back.error().message;
  EXPECT_TRUE(has_finding(*taken_back, "compensation-number-beside"));
  EXPECT_NE(taken_back->text.find("while the axis was measured + -0.00"), std::string::npos) << taken_back->text;
}

/// The finding about what one count stands for; nothing where there is none.
std::optional<NamedFinding> finding_of_counts(const NamedTest& measured, const CompensateRequest& request) {
  const auto made = compensate({measured}, request);
  EXPECT_TRUE(made) << made.error().message;
  if (!made) return {};
  const auto found = std::ranges::find(made->findings, "compensation-count-assumed", &NamedFinding::id);
  return found == made->findings.end() ? std::nullopt : std::optional(*found);
}

TEST(Compensate, WhatOneCountIsTakenForIsToldUnlessItIsSaid) {
  NamedTest linear = axis_of(0.02, 0, 2);
  CompensateRequest request{.control = "mitsubishi", .grid = {.start = 0.0, .end = 450.0, .step = 50.0}};
  const auto in_mm = finding_of_counts(linear, request);
  ASSERT_TRUE(in_mm);
  EXPECT_FALSE(in_mm->serious) << "1 µm is usual";
  request.table.in_inch = true;
  const auto in_inch = finding_of_counts(linear, request);
  ASSERT_TRUE(in_inch);
  EXPECT_TRUE(in_inch->serious);
  EXPECT_NE(in_inch->message.find("2.54 µm"), std::string::npos);
  request.table.resolution = 2.54;
  EXPECT_FALSE(finding_of_counts(linear, request));
  EXPECT_FALSE(finding_of_counts(linear, {.control = "linuxcnc"})) << "it does not count";

  NamedTest rotary = axis_of(0.02, 0, 2);
  rotary.test.metadata.axis.kind = AxisKind::rotary;
  CompensateRequest turning{.control = "mitsubishi", .grid = {.start = 0.0, .end = 300.0, .step = 30.0}};
  const auto in_degrees = finding_of_counts(rotary, turning);
  ASSERT_TRUE(in_degrees);
  EXPECT_TRUE(in_degrees->serious) << "0.001° is usual: 3.6 times as much as the table was made for";
  EXPECT_NE(in_degrees->message.find("3.6 ″"), std::string::npos);
  turning.resolution_said = true;
  EXPECT_FALSE(finding_of_counts(rotary, turning)) << "1 ″ was stated";
  turning.resolution_said = false;
  turning.table.resolution = 3.6;
  EXPECT_FALSE(finding_of_counts(rotary, turning));
  for (const auto& finding : {*in_mm, *in_inch, *in_degrees})
    EXPECT_TRUE(language::is_known(finding.message, language::Language::german)) << finding.message;
}

/// Scatter of ±1 µm in five runs at 11 targets over 500 mm; ↓ lies `reversal` above ↑ at the first `reversed` of them,
/// and that is all.
NamedTest scattered_axis(double reversal, int reversed = 11) {
  std::vector<double> targets;
  for (int i = 0; i < 11; ++i) targets.push_back(50.0 * i);
  std::minstd_rand random(1);
  const auto run_at = [&](double shift) {
    testing_support::RunDeviations run;
    for (int i = 0; i < 11; ++i)
      run.push_back((i < reversed ? shift : 0.0) + 2.0 * static_cast<double>(random()) / 2147483647.0 - 1.0);
    return run;
  };
  ReadingRuns up, down;
  for (int j = 0; j < 5; ++j) {
    up.push_back(run_at(0.0));
    down.push_back(run_at(reversal));
  }
  return {"x.csv", axiometry::Test{{}, testing_support::make_series(targets, up, down), {}}};
}

/// One curve for both directions has nothing to correct where the reversal is all that there is.
TEST(Compensate, AReversalIsNotCalledScatter) {
  for (const int reversed : {11, 4}) {
    const auto refused = compensate({scattered_axis(10.0, reversed)}, {.control = "siemens-lec"});
    if (reversed == 4 && refused) continue;  // the mean of both has a step, of which a table may take something
    ASSERT_FALSE(refused);
    const std::string& message = refused.error().message;
    EXPECT_NE(message.find("one curve for both directions leaves the reversal error"), std::string::npos) << message;
    EXPECT_EQ(message.find("scatter"), std::string::npos) << message;
    EXPECT_TRUE(language::is_known(message, language::Language::german)) << message;
  }
  const auto scatter = compensate({scattered_axis(0.0)}, {.control = "siemens-lec"});
  ASSERT_FALSE(scatter);
  EXPECT_NE(scatter.error().message.find("what scatter makes of them"), std::string::npos) << scatter.error().message;
  EXPECT_EQ(scatter.error().message.find("reversal"), std::string::npos) << scatter.error().message;
}

/// What stands side by side is one parameter: of one direction there is no E.
TEST(Compensate, AReTestOfOneDirectionShowsWhatBothTestsHave) {
  const auto outcome = [](NamedTest before, NamedTest again, std::optional<TableCurves> curves = {}) {
    const auto made = compensate({std::move(before), {}, std::move(again)}, {.control = "linuxcnc", .curves = curves});
    EXPECT_TRUE(made) << made.error().message;
    if (!made) return std::string();
    const report::Document document = present(*made, {}).document;
    return plain_text(document.status.front().heading) + "\n" + plain_text(document.status.front().lines.front());
  };
  const auto without = [](NamedTest named, Direction direction) {
    const Series& all = named.test.series;
    const std::vector<Position> targets(all.targets().begin(), all.targets().end());
    ReadingRuns rest(all.run_count());
    for (std::size_t i = 0; i < targets.size(); ++i) {
      const auto cell = all.cell(i, direction == Direction::up ? Direction::down : Direction::up);
      for (std::size_t j = 0; j < rest.size(); ++j) rest[j].push_back(cell[j]);
    }
    std::vector<double> at;
    for (const Position& target : targets) at.push_back(target.in_native());
    named.test.series = direction == Direction::up ? testing_support::make_series(at, {}, rest)
                                                   : testing_support::make_series(at, rest, {});
    return named;
  };
  const NamedTest before = axis_of(0.05, 0, 4), again = axis_of(0.001, 0, 0.1);
  EXPECT_THAT(outcome(before, again), testing::MatchesRegex("E from [^E]*\nE of the re-test: .*"));
  EXPECT_THAT(outcome(before, without(again, Direction::down)),
              testing::MatchesRegex("E↑ from [^E]*\nE↑ of the re-test: .*"));
  EXPECT_THAT(outcome(without(before, Direction::up), again, TableCurves::both_ways),
              testing::MatchesRegex("E↓ from [^E]*\nE↓ of the re-test: .*"));
}

TEST(Compensate, ScatterOfSingleApproachesIsNotKnown) {
  const auto once = [](std::size_t runs) {
    const ReadingRuns all{{0, 4, 8, 12, 16}, {0.1, 4, 8.2, 12, 16.1}};
    const ReadingRuns some(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(runs));
    const auto made =
        compensate({{"x.csv", {{}, testing_support::make_series({0, 110, 190, 310, 400}, some, some), {}}}},
                   {.control = "linuxcnc", .axis = "X"});
    EXPECT_TRUE(made) << made.error().message;
    return made ? present(*made, {}).json : json::Value();
  };
  const json::Value single = once(1), twice = once(2);
  ASSERT_NE(single.find("scatter"), nullptr);
  EXPECT_TRUE(single.find("scatter")->find("E")->is(json::Kind::null));
  EXPECT_TRUE(single.find("predicted")->find("E")->is(json::Kind::number));
  EXPECT_TRUE(twice.find("scatter")->find("E")->is(json::Kind::number));
}

TEST(Compensate, AFormatOfOneUnitAsksForNoOther) {
  const auto made =
      compensate({axis_of(0.05, 0, 4), NamedTable{"old.dat", "unit = mm\n[X]\n0, 0, 0\n15, 0.001, 0.001\n"}},
                 {.control = "axeserr", .grid = {.start = 0.0, .end = 450.0, .step = 50.0}});
  EXPECT_TRUE(made) << made.error().message;
}

TEST(Compensate, ATurnedSignTurnsTheFileAndNotWhatIsPredicted) {
  CompensateRequest request{.control = "heidenhain"};
  const auto plain = compensate({axis_of(0.05, 0, 4)}, request);
  request.table.turned_sign = true;
  const auto turned = compensate({axis_of(0.05, 0, 4)}, request);
  ASSERT_TRUE(plain && turned);
  EXPECT_NE(plain->text, turned->text);
  EXPECT_NEAR(plain->predicted.parameters.E->in_native(), turned->predicted.parameters.E->in_native(), 1e-9);
  const json::Value json = present(*turned, {}).json;
  EXPECT_TRUE(json.find("turned_sign")->boolean());
  EXPECT_NE(json.find("sign")->text().find("turned against"), std::string::npos);
}

TEST(Compensate, OptionsAreReadAsTheyAreWritten) {
  CompensateRequest request{.control = "siemens-lec", .curves = TableCurves::with_backlash};
  request.periodic = Periodic::leave;
  request.period = 10.0;
  request.existing_in_inch = false;
  const auto again = compensate_request_from(to_json(request));
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_EQ(json::dump(to_json(*again)), json::dump(to_json(request)));
  EXPECT_EQ(again->periodic, Periodic::leave);
  EXPECT_EQ(again->period, 10.0);
  EXPECT_EQ(again->existing_in_inch, false);
  CompensateRequest turned{.control = "mach4"};
  turned.table.turned_sign = true;
  EXPECT_TRUE(compensate_request_from(to_json(turned))->table.turned_sign);
}

}  // namespace
}  // namespace axiometry::app
