// SPDX-License-Identifier: Apache-2.0
//
// Every rule once where it speaks and once where it must not. tests/conformance/iso230_2 has more.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "axiometry/model/fields.h"
#include "axiometry/standards/iso230_2/assessment/assessment.h"
#include "tests/support/series.h"

namespace axiometry::iso230_2 {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsSupersetOf;
using testing_support::make_series;
using testing_support::RunDeviations;
namespace table2 = testing_support::table2;

using testing_support::none;

Assessment assessed(const Series& series, const Metadata& metadata = {}) { return assess({metadata, series, {}}); }

Metadata with_kind(AxisKind kind) {
  Metadata metadata;
  metadata.axis.kind = kind;
  return metadata;
}

/// "departure: found …" of the first finding of a clause that contains the text; "" when there is none.
std::string finding(const Assessment& a, std::string_view clause, std::string_view part = "") {
  for (const Finding& f : a.findings)
    if (f.clause == clause && f.message.find(part) != std::string::npos)
      return std::string(severity_name(f.severity)) + ": " + f.message;
  return "";
}

/// n equal-looking but not monotonic runs over the targets.
std::vector<RunDeviations> runs(std::size_t n, std::size_t targets) {
  constexpr double pattern[] = {0.2, -0.1, 0.3, 0.0, 0.1};
  std::vector<RunDeviations> result;
  for (std::size_t j = 0; j < n; ++j) {
    RunDeviations run;
    for (std::size_t i = 0; i < targets; ++i)
      run.push_back(pattern[(i + j) % 5] + static_cast<double>(i * i % 7) * 0.4);
    result.push_back(run);
  }
  return result;
}

Series proper(const std::vector<double>& targets, std::size_t n = 5) {
  return make_series(targets, runs(n, targets.size()), runs(n, targets.size()));
}

const std::vector<double> half_metre = {0, 110, 240, 390, 500};

TEST(Findings, AreNotesOnlyForAProperAndCompleteTest) {
  for (const Finding& f : assess(table2::complete_test()).findings) EXPECT_EQ(f.severity, Severity::note) << f.message;
}

TEST(Findings, StandWithDeparturesFirstThenWhatIsMissing) {
  Metadata m;
  m.conditions.cycle = TestCycle::step;
  const Assessment a = assessed(make_series({0, 100, 200}, {{0, 1, 0}}, {{0, 1, 0}}), m);
  for (std::size_t k = 1; k < a.findings.size(); ++k) EXPECT_LE(a.findings[k - 1].severity, a.findings[k].severity);
  EXPECT_EQ(a.findings.front().clause, "5.3.2");
  EXPECT_FALSE(a.conforming());
}

TEST(Findings, NameTheFieldsThatWouldAnswerThem) {
  Metadata m;
  m.conditions.date = "0000-00-00";
  m.gum.drift_interval = Duration::s(60.0);
  const Assessment a = assessed(proper(half_metre), m);
  const auto fields_of = [&](std::string_view id) {
    const auto found = std::ranges::find(a.findings, id, &Finding::id);
    return found == a.findings.end() ? std::vector<std::string_view>{"no such finding"} : found->fields;
  };
  EXPECT_THAT(fields_of("items-of-identification"), IsSupersetOf({"machine.name", "axis.name", "test.feed"}));
  EXPECT_THAT(fields_of("uncertainty-stated"),
              IsSupersetOf({"uncertainty.device_calibration", "uncertainty.environmental_variation"}));
  EXPECT_THAT(fields_of("impossible-date"), ElementsAre("test.date"));
  EXPECT_THAT(fields_of("uncertainty-input"), ElementsAre("uncertainty.drift_interval_s"));
  EXPECT_THAT(fields_of("number-of-approaches"), ElementsAre("no such finding"));
  for (const Finding& f : a.findings)
    for (const std::string_view key : f.fields) EXPECT_NE(find_field(key), nullptr) << f.id << ": " << key;
}

TEST(Findings, CountTargetsAsTheLengthDemands) {
  EXPECT_EQ(finding(assessed(proper({0, 110, 240, 390})), "5.3.2", "targets"),
            "departure: found 4 targets over 390 mm, expected at least 5 (at any length)");
  EXPECT_EQ(finding(assessed(proper(half_metre)), "5.3.2"), "");
  EXPECT_THAT(finding(assessed(proper({0, 300, 700, 1200, 1500})), "5.3.2"),
              HasSubstr("expected at least 8 (5 per metre)"));
  EXPECT_EQ(finding(assessed(proper({0, 210, 390, 610, 1000})), "5.3.2"), "")
      << "five per metre are five over one metre";
}

TEST(Findings, HaveTheIdsOfTheirRules) {
  const auto id_of = [](const Assessment& a, std::string_view clause, std::string_view part) {
    const auto f = std::ranges::find_if(
        a.findings, [&](const Finding& one) { return one.clause == clause && one.message.contains(part); });
    return f == a.findings.end() ? "" : f->id;
  };
  Metadata m;
  m.conditions.cycle = TestCycle::step;
  const Assessment few = assessed(proper({0, 110, 240, 390}, 3), m);
  EXPECT_EQ(id_of(few, "5.3.2", "targets"), "number-of-targets");
  EXPECT_EQ(id_of(few, "5.3.2", "approaches"), "number-of-approaches");
  EXPECT_EQ(id_of(few, "Annex B", "step cycle"), "step-cycle");
  EXPECT_EQ(id_of(few, "8.1", "not given"), "items-of-identification");
  EXPECT_EQ(id_of(few, "8.2.1", "no uncertainty"), "uncertainty-stated");
  axiometry::Test averages{{}, proper(half_metre), {}};
  averages.provenance.remarks.push_back({true, "found averages"});
  EXPECT_EQ(id_of(assess(averages), source_clause, "averages"), "source-remark");
  for (const Finding& f : few.findings) EXPECT_NE(f.id, "") << f.message;
}

TEST(Findings, WantFiveApproachesUpToTwoMetresAndOneAbove) {
  EXPECT_THAT(finding(assessed(proper(half_metre, 3)), "5.3.2"),
              HasSubstr("found 3 approaches in each direction over 500 mm"));
  EXPECT_THAT(finding(assessed(proper(half_metre, 10)), "5.3.2"), HasSubstr("found 10 approaches"));
  const std::vector<double> long_axis = {0, 260, 490, 760, 1010, 1240, 1500, 1770, 1990, 2260, 2500};
  EXPECT_TRUE(assessed(proper(long_axis, 1)).conforming());
  EXPECT_THAT(finding(assessed(proper(long_axis, 5)), "5.3.3", "approaches"),
              HasSubstr("expected 1 in each direction; R and A"));
  EXPECT_THAT(finding(assessed(proper(long_axis, 1)), "6.2"), HasSubstr("one approach from each direction"));
  EXPECT_THAT(finding(assessed(make_series(long_axis, runs(1, long_axis.size()), {})), "6.2"),
              HasSubstr("one approach from one direction"));
  EXPECT_THAT(finding(assessed(proper(long_axis, 1)), "5.3.3"),
              HasSubstr("note: the test with five approaches over 2 000 mm"));
}

TEST(Findings, NameTheRunsThatAreUneven) {
  const Series series = make_series(half_metre, runs(5, 5), runs(4, 5));
  EXPECT_THAT(finding(assessed(series), "5.3.2"), HasSubstr("found 5 approaches ↑ and 4 ↓"));
  EXPECT_EQ(finding(assessed(series), "5.3.2", "no reading"), "") << "a run that was not made is not a missing reading";
}

TEST(Findings, TellDirectionsThatWereRunOneAfterTheOther) {
  auto up = runs(5, 5), down = runs(5, 5);
  for (RunDeviations& run : down)
    for (double& x : run) x += 6.0;
  up.insert(up.end(), 5, RunDeviations(5, none));
  down.insert(down.begin(), 5, RunDeviations(5, none));
  const auto assessment = assessed(make_series(half_metre, up, down));
  EXPECT_EQ(finding(assessment, "5.3.2"),
            "note: found by their numbers runs 1 to 5 all ↑ and runs 6 to 10 all ↓, expected both directions in turn "
            "(Figure 1): if they were made so, what drifted meanwhile stands in B");
  EXPECT_THAT(finding(assessment, "3.17"), HasSubstr("or from its compensation, or from a drift between the two"));
  EXPECT_THAT(finding(assessed(make_series(half_metre, down, up)), "5.3.2"),
              HasSubstr("runs 1 to 5 all ↓ and runs 6 to 10 all ↑"));
}

TEST(Findings, TellRunsThatWereLeftOut) {
  auto six = runs(6, 5);
  six[3].assign(5, none);
  EXPECT_EQ(finding(assessed(make_series(half_metre, six, six)), "5.3.2", "left out"),
            "note: found no reading of run 4, expected one of every run up to the last, run 6: nobody can tell whether "
            "it was made and left out");
  six[1].assign(5, none);
  EXPECT_THAT(finding(assessed(make_series(half_metre, six, six)), "5.3.2", "left out"),
              HasSubstr("found no reading of 2 runs, the first of them run 2, expected"));
  auto odd = runs(9, 5), even = runs(10, 5);
  for (std::size_t j = 0; j < 9; ++j) (j % 2 == 0 ? even : odd)[j].assign(5, none);
  EXPECT_EQ(finding(assessed(make_series(half_metre, odd, even)), "5.3.2"), "") << "one-way runs, each with its number";
}

TEST(Findings, NameTheReadingsThatAreMissing) {
  auto up = runs(5, 5);
  up[1][2] = none;
  EXPECT_EQ(finding(assessed(make_series(half_metre, up, runs(5, 5))), "5.3.2"),
            "departure: found no reading at target 3 (240 mm) ↑ run 2, expected one from every approach");
  for (std::size_t i = 0; i < 4; ++i) up[4][i] = none;
  for (std::size_t i = 1; i < 5; ++i) up[3][i] = none;
  EXPECT_THAT(finding(assessed(make_series(half_metre, up, runs(5, 5))), "5.3.2"), HasSubstr("and 4 more"));
}

TEST(Findings, WantBothEndsFromBothSides) {
  auto down = runs(5, 5);
  for (auto& run : down) run[4] = none;
  const Assessment a = assessed(make_series(half_metre, runs(5, 5), down));
  EXPECT_THAT(finding(a, "3.2"),
              HasSubstr("departure: found an end of the measurement travel approached from one side, "
                        "target 5 (500 mm) from ↑ only"));
}

TEST(Findings, WantRoomBeyondTheEndTargets) {
  Metadata m;
  m.axis.travel_begin = Position::native(0);
  m.axis.travel_end = Position::native(520);
  EXPECT_THAT(finding(assessed(proper(half_metre), m), "3.2"), HasSubstr("the first target at 0 mm at the end"));
  m.axis.travel_begin = Position::native(-10);
  EXPECT_EQ(finding(assessed(proper(half_metre), m), "3.2"), "");
  m.axis.travel_end = Position::native(1800);
  EXPECT_THAT(finding(assessed(proper(half_metre), m), "3.2"),
              HasSubstr("500 mm measured of an axis travel of 1810 mm"));
}

/// One approach from each side over the whole travel: over 2.5 m of 6 m it is a test of a part.
TEST(Findings, TellThatOnlyAPartOfALongAxisWasMeasured) {
  const std::vector<double> targets = {5, 260, 480, 740, 1010, 1230, 1510, 1740, 2000, 2260, 2505};
  Metadata m;
  m.axis.travel_begin = Position::native(0);
  m.axis.travel_end = Position::native(6000);
  EXPECT_THAT(finding(assessed(proper(targets, 1), m), "3.2"), HasSubstr("2500 mm measured of an axis travel of 6000"));
  m.axis.travel_end = Position::native(2600);
  EXPECT_EQ(finding(assessed(proper(targets, 1), m), "3.2"), "");
}

TEST(Findings, DepartWhereTargetsLieOutsideTheAxisTravel) {
  Metadata m;
  m.axis.travel_begin = Position::native(100);
  m.axis.travel_end = Position::native(400);
  EXPECT_EQ(finding(assessed(proper(half_metre), m), "3.2"),
            "departure: found the first target at 0 mm and the last target at 500 mm outside the axis travel, expected "
            "all targets within it");
  m.axis.travel_begin = Position::native(-500);
  m.axis.travel_end = Position::native(0);
  EXPECT_EQ(finding(assessed(proper(half_metre), m), "3.2"),
            "missing: found the last target at 500 mm outside the axis travel, expected all targets within it: do both "
            "count from one zero?");
  m.axis.travel_begin = Position::native(520);
  m.axis.travel_end = Position::native(-20);
  EXPECT_EQ(finding(assessed(proper(half_metre), m), "3.2"), "") << "ends are ends, whichever was stated first";
  m.axis.travel_begin = m.axis.travel_end = Position::native(100);
  EXPECT_THAT(finding(assessed(proper(half_metre), m), "3.2"), HasSubstr("departure: found the first target at 0 mm"));
}

TEST(Findings, RememberTheTestOverTheWholeTravel) {
  Metadata m;
  m.axis.travel_begin = Position::native(-10);
  m.axis.travel_end = Position::native(3000);
  EXPECT_THAT(finding(assessed(proper(half_metre), m), "5.3.3"), HasSubstr("the axis travels 3010 mm"));
  std::swap(m.axis.travel_begin, m.axis.travel_end);
  EXPECT_THAT(finding(assessed(proper(half_metre), m), "5.3.3"), HasSubstr("the axis travels 3010 mm"));
  m.axis.travel_begin = Position::native(-10), m.axis.travel_end = Position::native(1990.0000005);
  EXPECT_EQ(finding(assessed(proper(half_metre), m), "5.3.3"), "") << "2 000 mm in inches are not longer";
}

TEST(Findings, WantUnequalIntervals) {
  EXPECT_THAT(finding(assessed(proper({0, 100, 200, 300, 400})), "5.2"),
              HasSubstr("note: found 5 equally spaced targets (every 100 mm)"));
  EXPECT_EQ(finding(assessed(proper(half_metre)), "5.2"), "");
  EXPECT_THAT(finding(assessed(proper({0, 90, 210, 300, 410, 1000})), "5.2"),
              HasSubstr("found 590 mm between target 5"));
}

TEST(Findings, WantTargetsOffTheCompensation) {
  Metadata m;
  m.axis.compensation_points = {110.0004, 240.01, 700};
  EXPECT_EQ(finding(assessed(proper(half_metre), m), "5.2"),
            "departure: found 1 of 5 targets on sampling points of the compensation: target 2 (110 mm), expected other "
            "positions for acceptance or reverification");
  m.conditions.purpose = "Acceptance test";
  EXPECT_THAT(finding(assessed(proper(half_metre), m), "5.2"), HasSubstr("departure"));
  m.conditions.purpose = "compensation";
  EXPECT_THAT(finding(assessed(proper(half_metre), m), "5.2"), HasSubstr("note"));
}

TEST(Findings, FollowTableOneOnRotaryAxes) {
  const Metadata rotary = with_kind(AxisKind::rotary);
  EXPECT_THAT(finding(assessed(proper({0, 85}), rotary), "5.3.4"),
              HasSubstr("expected at least 3 (Table 1, up to 90°)"));
  EXPECT_THAT(finding(assessed(proper({0, 50, 90, 170}), rotary), "5.3.4"), HasSubstr("expected at least 5"));
  EXPECT_EQ(finding(assessed(proper({0, 43, 90, 137, 180, 222, 270, 316}), rotary), "5.3.4"), "");
  EXPECT_EQ(finding(assessed(proper({-90, -50, 0, 43, 90, 137, 180, 222}), rotary), "5.3.4"), "") << "−90° is 270°";
  EXPECT_THAT(finding(assessed(proper({0, 43, 91, 137, 180, 222, 271, 316}), rotary), "5.3.4"),
              HasSubstr("note: found no target at 90°, 270°"));
}

TEST(Findings, WantEightTargetsARevolutionOverManyTurns) {
  const Metadata rotary = with_kind(AxisKind::rotary);
  std::vector<double> two_turns, six_turns;
  for (int k = 0; k <= 16; ++k) two_turns.push_back(45 * k + (k % 3));
  for (int k = 0; k <= 48; ++k) six_turns.push_back(45 * k + (k % 3));
  EXPECT_TRUE(assessed(proper(two_turns, 1), rotary).conforming());
  EXPECT_THAT(finding(assessed(proper(two_turns, 1), rotary), "5.3.5"), HasSubstr("360°"));
  EXPECT_THAT(finding(assessed(proper(six_turns, 1), rotary), "5.3.5", "five revolutions"), HasSubstr("note"));
  EXPECT_THAT(finding(assessed(proper({0, 100, 200, 300, 400}, 1), rotary), "5.3.5"), HasSubstr("expected at least 9"));
}

TEST(Findings, TellTemperaturesThatWereNotCorrected) {
  Metadata m;
  m.environment.sensors = {{"machine", "bed", Temperature::celsius(20.05), Temperature::celsius(20.1)}};
  EXPECT_THAT(finding(assessed(proper(half_metre), m), "4.1"), HasSubstr("note: thermal expansion, about 0.6 µm"))
      << "20 °C within what a display resolves, which a verdict must know all the same";
  m.environment.sensors[0].end = Temperature::celsius(18.5);
  EXPECT_THAT(finding(assessed(proper(half_metre), m), "4.1"),
              HasSubstr("missing: found 18.5 °C at the machine sensor (bed)"));
  m.nde.applied = false;
  EXPECT_THAT(finding(assessed(proper(half_metre), m), "4.1"), HasSubstr("departure: found 18.5 °C"));
  EXPECT_THAT(finding(assessed(proper(half_metre), m), "4.1"), HasSubstr("about 9 µm over 500 mm at 12 µm/(m·°C)"));
  m.nde.applied = true;
  EXPECT_EQ(finding(assessed(proper(half_metre), m), "4.1", "correction"), "");
  EXPECT_THAT(finding(assessed(proper(half_metre), m), "4.1"),
              HasSubstr("note: found the machine sensor (bed) going from"));
}

TEST(Findings, TakeTheAirForTheMachineOnlyWithoutSensors) {
  Metadata m;
  m.nde.applied = false;
  m.environment.air_temperature_start = Temperature::celsius(23);
  EXPECT_THAT(finding(assessed(proper(half_metre), m), "4.1"), HasSubstr("found 23 °C at the air"));
  m.environment.sensors = {{"machine", "", Temperature::celsius(20), Temperature::celsius(20)}};
  EXPECT_EQ(finding(assessed(proper(half_metre), m), "4.1"), "");
}

TEST(Findings, DoubtAPressureThatIsNowhereWhereMachinesStand) {
  Metadata m;
  const auto told = [&](double kPa) {
    m.environment.air_pressure_start = Pressure::kPa(kPa);
    return finding(assessed(proper(half_metre), m), "8.1", "air pressure of");
  };
  EXPECT_EQ(told(29.92),
            "note: found an air pressure of 29.92 kPa, expected 50 to 110 kPa, as where people work: is it inHg?");
  EXPECT_THAT(told(120.0), HasSubstr("as where people work"));
  EXPECT_EQ(told(62.0), "") << "4000 m above the sea";
  EXPECT_EQ(told(105.0), "");
}

TEST(Findings, SeeAnOrderedProgressionFromRunToRun) {
  std::vector<RunDeviations> drifting = runs(5, 5);
  for (std::size_t j = 0; j < 5; ++j)
    for (double& x : drifting[j]) x -= 1.0 * static_cast<double>(j);
  EXPECT_THAT(
      finding(assessed(make_series(half_metre, drifting, drifting)), "4.3"),
      HasSubstr("note: found the readings falling from run to run, by 4 µm from the first run to the last, where "
                "they scatter by 0.177 µm about target and run (p < 0.0001): a sign that the machine was not "
                "thermally stable; without this drift R would be 0.632 µm instead of 6.72 µm"));
  EXPECT_EQ(finding(assessed(proper(half_metre)), "4.3"), "");
  EXPECT_EQ(finding(assessed(table2::series()), "4.3"), "");
}

TEST(Findings, MentionAReversalErrorThatIsTheSameEverywhere) {
  EXPECT_THAT(finding(assessed(table2::series()), "3.17"),
              HasSubstr("note: found nearly the same reversal error at every target, −3.71 µm on average, without "
                        "which R would be 2.99 µm instead of 6.55 µm;"));
  std::vector<RunDeviations> up = runs(1, 5);
  std::vector<RunDeviations> down = up;
  for (double& x : down[0]) x += 40.0;
  EXPECT_THAT(finding(assessed(make_series(half_metre, up, down)), "3.17"), HasSubstr("without which E would be"));
  down[0][2] -= 20.0;  // at one target only half of it
  EXPECT_EQ(finding(assessed(make_series(half_metre, up, down)), "3.17"), "");
  EXPECT_EQ(finding(assessed(proper(half_metre)), "3.17"), "");
  const std::vector<RunDeviations> exact(5, RunDeviations{1, 1, 1, 1, 1});  // no reversal error and no scatter
  EXPECT_EQ(finding(assessed(make_series(half_metre, exact, exact)), "3.17"), "");
}

std::string copied_finding(std::span<const RunDeviations> up, std::span<const RunDeviations> down) {
  return finding(assessed(make_series(table2::targets, {up.begin(), up.end()}, {down.begin(), down.end()})), "3.18",
                 "copied was not measured");
}

TEST(Findings, AskAboutRunsThatAreCopiesOfOthers) {
  EXPECT_EQ(copied_finding(table2::up, table2::down), "");
  EXPECT_EQ(copied_finding(table2::up, table2::up),
            "note: found 5 of 10 runs, each direction counted, equal to another at all 11 targets, such as run 1↓ to "
            "run 1↑; chance hardly makes that, and what was copied was not measured");
  auto down = table2::down;
  down[3] = down[1];
  EXPECT_THAT(copied_finding(table2::up, down), HasSubstr("found 1 of 10 runs, each direction counted, equal to "
                                                          "another at all 11 targets, such as run 4↓ to run 2↓;"));
  down = table2::up;
  for (auto& run : down)
    for (double& x : run) x = -x;
  EXPECT_THAT(copied_finding(table2::up, down), HasSubstr("such as run 1↓ to run 1↑ with the other sign;"));
}

/// Of a good axis to 1 µm, runs agree at most targets, and now and then at all of them.
TEST(Findings, TakeCoarseReadingsThatAgreeForHonest) {
  const RunDeviations most = {0, 1, 1, 2, 2, 3, 3, 2, 2, 1, 1};
  std::vector<RunDeviations> runs(5, most);
  for (std::size_t j = 2; j < runs.size(); ++j) runs[j][2 * j] += 1.0;  // two runs agree everywhere
  EXPECT_EQ(copied_finding(runs, table2::down), "");
}

TEST(Findings, MentionAStraightSlopeAndAStrangeLackOfScatter) {
  std::vector<RunDeviations> sloping = runs(5, 5);
  for (auto& run : sloping)
    for (std::size_t i = 0; i < 5; ++i) run[i] += 0.05 * half_metre[i];
  EXPECT_THAT(finding(assessed(make_series(half_metre, sloping, sloping)), "3.24"),
              HasSubstr("note: found a straight slope of"));
  EXPECT_THAT(finding(assessed(make_series(half_metre, {}, sloping)), "3.24"), HasSubstr("without which E↓ would be"));
  EXPECT_EQ(finding(assessed(table2::series()), "3.24"), "");
  EXPECT_EQ(finding(assessed(table2::series()), "3.18", "same reading"), "");
  for (std::size_t n : {3, 5, 10}) {  // 0.1 + 0.1 + 0.1 is not 0.3, but the readings are the same
    const std::vector<RunDeviations> copied(n, RunDeviations{0, 0.1, 2, 0.7, none});
    EXPECT_THAT(finding(assessed(make_series(half_metre, copied, runs(1, 5))), "3.18"),
                HasSubstr("same reading in every run"));
    EXPECT_THAT(finding(assessed(make_series(half_metre, runs(n, 5), copied)), "3.18", "same reading"),
                HasSubstr("same reading ↓ in every run at every target"));
  }
}

TEST(Findings, TellWhereReadingsScatterByLessThanTheirSteps) {
  std::vector<RunDeviations> coarse(5, RunDeviations{0, 2, 1, 3, 1}), fine = coarse;
  coarse[1][0] = 1;
  coarse[2][4] = 2;
  fine[1][0] = 0.1;
  fine[2][4] = 1.3;
  EXPECT_THAT(finding(assessed(make_series(half_metre, coarse, coarse)), "3.18", "steps"),
              HasSubstr("note: found readings in steps of 1 µm that scatter by 0.283 µm about their means"));
  EXPECT_EQ(finding(assessed(make_series(half_metre, fine, fine)), "3.18", "steps"), "");
  EXPECT_EQ(finding(assessed(table2::series()), "3.18", "steps"), "");
  std::vector<RunDeviations> corrected = coarse;
  for (RunDeviations& run : corrected)
    for (double& x : run) x *= 1.0000123;
  Metadata stated;
  stated.gum.instrument_resolution = Deviation::native(1.0);
  EXPECT_THAT(finding(assessed(make_series(half_metre, corrected, corrected), stated), "3.18", "steps"),
              HasSubstr("found readings that scatter by 0.283 µm about their means, no more than half of the "
                        "resolution of 1 µm that is stated"))
      << "they are in no steps";
  const std::vector<RunDeviations> copied(5, RunDeviations{0, 2, 1, 3, 1});
  EXPECT_EQ(finding(assessed(make_series(half_metre, copied, coarse)), "3.18", "steps"), "") << "told already";
}

TEST(Findings, ListWhatAReportWouldHaveToTell) {
  const Assessment bare = assessed(proper(half_metre));
  EXPECT_THAT(finding(bare, "8.1"),
              HasSubstr("missing: not given, but expected in the report – test: date of test, name of inspector,"));
  EXPECT_THAT(finding(bare, "8.1"), Not(HasSubstr("compensation routine"))) << "asked for with an NDE correction only";
  EXPECT_THAT(finding(bare, "8.2.1"),
              HasSubstr("missing: no uncertainty is stated after Annex A: nothing was given of"));
  axiometry::Test test = table2::complete_test();
  test.metadata.conditions.warm_up.clear();
  test.metadata.nde.routine.clear();
  test.metadata.uncertainty.misalignment.reset();
  const Assessment a = assess(test);
  EXPECT_EQ(finding(a, "8.1"),
            "missing: not given, but expected in the report – test: warm-up operation; NDE correction: compensation "
            "routine");
  EXPECT_THAT(finding(a, "8.2.1"), HasSubstr("incomplete and too small: nothing was given of misalignment (A.4)"));
  EXPECT_TRUE(a.conforming()) << "what is missing is no departure";
}

TEST(Findings, WantEquipmentAndSensorsIdentified) {
  axiometry::Test test = table2::complete_test();
  test.metadata.equipment.push_back({"", "Maker", "", ""});
  test.metadata.environment.sensors = {{"equipment", "", Temperature::celsius(20), {}},
                                       {"equipment", "laser head", Temperature::celsius(20), {}}};
  const Assessment a = assess(test);
  EXPECT_THAT(finding(a, "8.1", "test equipment"), HasSubstr("component 2 without type and serial number"));
  EXPECT_THAT(
      finding(a, "8.1", "NDE correction with"),
      HasSubstr("no sensor with the role machine, the sensor of the equipment without location, the sensor of the "
                "equipment without temperature at the end, the sensor of the equipment (laser head) without "
                "temperature at the end"));
}

TEST(Findings, TellEquipmentWhoseCalibrationDidNotHoldOnTheDayOfTheTest) {
  axiometry::Test test = table2::complete_test();
  test.metadata.conditions.date = "2026-03-05";
  test.metadata.equipment = {{"laser", "Maker", "L", "1", "C-1", "2025-03-05", "2026-03-05"}};
  EXPECT_EQ(finding(assess(test), "8.2.1", "out of calibration"), "") << "the last day counts";
  test.metadata.equipment.front().calibration_due = "04.03.2026";
  EXPECT_THAT(finding(assess(test), "8.2.1", "out of calibration"), HasSubstr("laser (2025-03-05 – 2026-03-04)"));
  test.metadata.equipment.front() = {"laser", "Maker", "L", "1", "C-2", "2026-03-06", "2027-03-06"};
  EXPECT_THAT(finding(assess(test), "8.2.1", "out of calibration"), HasSubstr("laser (2026-03-06 – 2027-03-06)"));
  test.metadata.equipment.front().calibration_due = "06/2013";
  test.metadata.equipment.front().calibrated_on = "";
  test.metadata.conditions.date = "2013-06-30";
  EXPECT_EQ(finding(assess(test), "8.2.1", "out of calibration"), "") << "the last day of the month counts";
  test.metadata.conditions.date = "20130701";
  EXPECT_THAT(finding(assess(test), "8.2.1", "out of calibration"), HasSubstr("2013-07-01"));
  test.metadata.conditions.date = "spring";
  EXPECT_EQ(finding(assess(test), "8.2.1", "out of calibration"), "") << "a day that nobody knows";
  EXPECT_THAT(finding(assess(test), "8.1", "date of the test"), HasSubstr("missing: found spring for the date"));
}

TEST(Findings, TellDatesThatCannotBeReadWhereTheyAreStated) {
  axiometry::Test test = table2::complete_test();
  for (const char* date : {"05/06/2014", "May 2014", "2014-05", "15.5.14", "yesterday"}) {
    test.metadata.conditions.date = date;
    EXPECT_THAT(finding(assess(test), "8.1", "date of the test"), HasSubstr(date));
  }
  for (const char* date : {"", "-", "unknown"}) {
    test.metadata.conditions.date = date;
    EXPECT_EQ(finding(assess(test), "8.1", "for the date of the test"), "") << "told as not given";
  }
  test = table2::complete_test();
  for (const char* due : {"2013-06-31", "Summer 2013", "expired"}) {
    test.metadata.equipment = {{"laser", "Maker", "L", "1", "C-1", "2024-03", due}};
    EXPECT_THAT(finding(assess(test), "8.2.1", "name no day"), HasSubstr(std::string("laser (") + due + ")"));
  }
  test.metadata.equipment = {{"laser", "Maker", "L", "1", "C-1", "2024-03", "–"}};
  EXPECT_EQ(finding(assess(test), "8.2.1", "name no day"), "");
}

TEST(Findings, TellCyclesThatAreNotTheStandardOne) {
  Metadata m;
  m.conditions.cycle = TestCycle::step;
  EXPECT_THAT(finding(assessed(proper(half_metre), m), "Annex B"), HasSubstr("departure: found the step cycle"));
  EXPECT_EQ(assessed(proper(half_metre), m).label, "step cycle (Annex B), not for acceptance");
  m.conditions.cycle = TestCycle::pilgrim;
  EXPECT_THAT(finding(assessed(proper(half_metre), m), "5.3.2"), HasSubstr("departure: found the pilgrim cycle"));
  EXPECT_EQ(assessed(proper(half_metre), m).label, "pilgrim cycle, not for acceptance");
  m.conditions.cycle = TestCycle::unidirectional;
  EXPECT_THAT(finding(assessed(proper(half_metre), m), "5.3.2"), HasSubstr("declared unidirectional"));
  const Series one_way = make_series(half_metre, {}, runs(5, 5));
  EXPECT_THAT(finding(assessed(one_way), "5.3.2"),
              HasSubstr("departure: found approaches from one direction only (↓)"));
  EXPECT_EQ(assessed(one_way).label, "one direction of approach only, not for acceptance");
}

TEST(Findings, OfDeparturesOnlyAreTheDeparturesOfAll) {
  std::vector<axiometry::Test> tests = {table2::complete_test()};
  Metadata warm;
  warm.nde.applied = false;
  warm.environment.sensors.push_back({"machine", "table", Temperature::celsius(24), Temperature::celsius(25)});
  Metadata stepped;
  stepped.conditions.cycle = TestCycle::step;
  stepped.axis.compensation_points = {0, 110};
  auto gap = runs(5, 5);
  gap[2][3] = none;
  for (const Metadata& m : {Metadata{}, warm, stepped, with_kind(AxisKind::rotary)}) {
    tests.push_back({m, proper(half_metre), {}});
    tests.push_back({m, proper({0, 10, 20}, 3), {}});
    tests.push_back({m, proper({0, 1500, 4100}), {}});
    tests.push_back({m, make_series(half_metre, gap, runs(5, 5)), {}});
    tests.push_back({m, make_series(half_metre, {}, runs(5, 5)), {}});
  }
  for (const axiometry::Test& test : tests) {
    std::vector<std::string> expected, found;
    for (const Finding& f : assess(test).findings)
      if (f.severity == Severity::departure) expected.push_back(f.clause + f.message);
    for (const Finding& f : assess(test, Depth::departures_only).findings) found.push_back(f.clause + f.message);
    EXPECT_EQ(found, expected);
  }
}

}  // namespace
}  // namespace axiometry::iso230_2
