// SPDX-License-Identifier: Apache-2.0
//
// For each claim what makes it false.
#include "axiometry/standards/iso230_2/rules/claims.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "axiometry/language/language.h"
#include "axiometry/model/swapped_labels.h"
#include "axiometry/standards/environment/environment.h"
#include "tests/support/series.h"

namespace axiometry::iso230_2 {
namespace {

using testing_support::make_series;
using testing_support::none;
using testing_support::RunDeviations;
namespace table2 = testing_support::table2;

Claims claims(const axiometry::Test& test) { return claims_of(test, assess(test)); }

bool holds(const axiometry::Test& test, ClaimKind kind) { return claim(claims(test), kind).holds(); }

/// "departure 5.2: …" of each point.
std::string points(const axiometry::Test& test, ClaimKind kind) {
  std::string text;
  const Claims all = claims(test);
  for (const Finding& f : claim(all, kind).against)
    text += std::string(severity_name(f.severity)) + " " + f.clause + ": " + f.message + "\n";
  return text;
}

std::vector<std::string> ids_against(const axiometry::Test& test, ClaimKind kind) {
  std::vector<std::string> ids;
  const Claims all = claims(test);
  for (const Finding& f : claim(all, kind).against) ids.push_back(f.id);
  return ids;
}

/// Everything stated and kept.
axiometry::Test whole() { return table2::complete_test(); }

axiometry::Test bare() {
  const std::vector<RunDeviations> up = {
      {1, 2, 3, 2, 1}, {1, 3, 3, 2, 2}, {0, 2, 3, 3, 1}, {1, 2, 4, 2, 1}, {1, 2, 3, 1, 1}};
  const std::vector<RunDeviations> down = {
      {2, 3, 4, 3, 2}, {2, 4, 4, 3, 3}, {1, 3, 4, 4, 2}, {2, 3, 5, 3, 2}, {2, 3, 4, 2, 2}};
  return {{}, make_series({0, 110, 240, 390, 500}, up, down), {}};
}

TEST(Claims, HoldAllForATestThatStatesAndKeepsEverything) {
  for (ClaimKind kind : {ClaimKind::computed, ClaimKind::tested, ClaimKind::reported})
    EXPECT_EQ(points(whole(), kind), "") << claim_key(kind);
}

TEST(Claims, LeaveBareNumbersTheFirstOnly) {
  EXPECT_TRUE(holds(bare(), ClaimKind::computed));
  EXPECT_FALSE(holds(bare(), ClaimKind::tested));
  EXPECT_FALSE(holds(bare(), ClaimKind::reported));
  const Claim tested = claim(claims(bare()), ClaimKind::tested);
  for (const Finding& f : tested.against) EXPECT_EQ(f.severity, Severity::missing) << f.message;
  EXPECT_EQ(against_text(tested), "9 points open") << points(bare(), ClaimKind::tested);
}

TEST(Claims, OfTheTestStandWithoutCompensationWhateverItIsCalled) {
  for (const char* none : {"none", "nil", "keine", "ohne", "aucune", "off", "0"}) {
    axiometry::Test test = whole();
    test.metadata.axis.compensation = none;
    test.metadata.axis.compensation_points.clear();
    EXPECT_EQ(points(test, ClaimKind::tested), "") << none;
  }
}

using Change = std::function<void(axiometry::Test&)>;

TEST(Claims, OfTheTestFallWithAnythingThatIsNotStated) {
  const std::pair<const char*, Change> changes[] = {
      {"4.1", [](axiometry::Test& t) { t.metadata.environment = {}; }},
      {"4.2", [](axiometry::Test& t) { t.metadata.conditions.axes_not_under_test.clear(); }},
      {"4.2", [](axiometry::Test& t) { t.metadata.axis.compensation.clear(); }},
      {"1",
       [](axiometry::Test& t) {
         t.metadata.axis.line_direction = {1, 1, 0}, t.metadata.axis.line_origin_mm = {0, 0, 0};
       }},
      {"3.2", [](axiometry::Test& t) { t.metadata.axis.travel_begin = Position::native(6.711); }},
      {"4.3", [](axiometry::Test& t) { t.metadata.conditions.warm_up.clear(); }},
      {"5.1", [](axiometry::Test& t) { t.metadata.conditions.feed.reset(); }},
      {"5.1", [](axiometry::Test& t) { t.metadata.conditions.dwell.reset(); }},
      {"5.2", [](axiometry::Test& t) { t.metadata.axis.compensation_points.clear(); }},
      {"5.3.1", [](axiometry::Test& t) { t.metadata.equipment.clear(); }},
      {"5.3.1", [](axiometry::Test& t) { t.metadata.axis.measurement_line.clear(); }},
      {"5.3.1", [](axiometry::Test& t) { t.metadata.nde.routine.clear(); }},
      {"5.3.1", [](axiometry::Test& t) { t.metadata.nde.machine_expansion.reset(); }},
      {"5.3.1", [](axiometry::Test& t) { t.metadata.environment.sensors.clear(); }},
      {"8.1", [](axiometry::Test& t) { t.metadata.environment.sensors.front().location.clear(); }},
      {"4.1", [](axiometry::Test& t) { t.metadata.nde.applied.reset(); }},
      // Statements that say nothing, or that no test can be made with.
      {"5.3.1", [](axiometry::Test& t) { t.metadata.axis.measurement_line = "n/a"; }},
      {"4.3", [](axiometry::Test& t) { t.metadata.conditions.warm_up = "-"; }},
      {"5.3.1", [](axiometry::Test& t) { t.metadata.axis.measurement_line = "not stated"; }},
      {"5.3.1", [](axiometry::Test& t) { t.metadata.axis.measurement_line = "—"; }},
      {"5.3.1", [](axiometry::Test& t) { t.metadata.axis.measurement_line = "non indiqué"; }},
      {"5.3.1", [](axiometry::Test& t) { t.metadata.axis.measurement_line = "none"; }},
      {"5.3.1", [](axiometry::Test& t) { t.metadata.nde.routine = "k. A."; }},
      {"5.3.1",
       [](axiometry::Test& t) {
         t.metadata.equipment = {{"-", "-", "-", "-"}};
       }},
      {"8.1", [](axiometry::Test& t) { t.metadata.environment.sensors.front().location = "–"; }},
      {"4.3", [](axiometry::Test& t) { t.metadata.conditions.warm_up = "none"; }},
      {"4.3", [](axiometry::Test& t) { t.metadata.conditions.warm_up = "not made"; }},
      {"4.3", [](axiometry::Test& t) { t.metadata.conditions.warm_up = "kein Warmlauf"; }},
      {"4.3", [](axiometry::Test& t) { t.metadata.conditions.warm_up = "0 min"; }},
      {"5.1", [](axiometry::Test& t) { t.metadata.conditions.feed = 0.0; }},
      {"5.1", [](axiometry::Test& t) { t.metadata.conditions.dwell = Duration::s(0.0); }},
      {"1", [](axiometry::Test& t) { t.metadata.conditions.purpose = "Simulation"; }},
      {"1", [](axiometry::Test& t) { t.metadata.conditions.purpose = "simulated"; }},
      {"1", [](axiometry::Test& t) { t.metadata.conditions.purpose = "Simulierte Messung"; }},
      // Errors that are known and not corrected.
      {"4.1", [](axiometry::Test& t) { t.metadata.instrument.sign_reversed = true; }},
      {"4.1", [](axiometry::Test& t) { t.metadata.instrument.gain = 1.01; }},
      {"5.3.1", [](axiometry::Test& t) { t.provenance.corrections.push_back({"drift", "Drift", {}, {}, {}}); }},
  };
  for (const auto& [clause, change] : changes) {
    axiometry::Test test = whole();
    change(test);
    EXPECT_NE(points(test, ClaimKind::tested).find(std::string("missing ") + clause), std::string::npos)
        << clause << '\n'
        << points(test, ClaimKind::tested);
    EXPECT_TRUE(holds(test, ClaimKind::computed)) << clause;
  }
}

/// Each keeps the letter of the standard; only who tested knows whether it was a test.
TEST(Claims, OfTheTestFallWithReadingsAndDaysThatAskForAWord) {
  const auto on_runs = [](axiometry::Test& t, double rise) {
    std::vector<RunDeviations> runs;
    for (int j = 0; j < 5; ++j) runs.push_back({1 + j * rise, 2 + j * rise, 3 + j * rise, 2 + j * rise, 1 + j * rise});
    t.metadata.axis.travel_begin = Position::native(-10), t.metadata.axis.travel_end = Position::native(510);
    t.metadata.axis.compensation_points = {-5};
    t.series = make_series({0, 110, 240, 390, 500}, runs, runs);
  };
  const std::pair<const char*, Change> changes[] = {
      {"readings-repeat-exactly", [&](axiometry::Test& t) { on_runs(t, 0.0); }},
      {"readings-copied", [](axiometry::Test& t) { t.series = make_series(table2::targets, table2::up, table2::up); }},
      // One run, and readings in steps so wide that they agree by chance as well.
      {"readings-copied",
       [](axiometry::Test& t) {
         t.series = make_series({0, 110, 240, 390, 500}, {{1, 3, 2, 4, 5}}, {{1, 3, 2, 4, 5}});
       }},
      {"readings-copied",
       [](axiometry::Test& t) {
         const std::vector<RunDeviations> coarse = {{0, 0, 1, 1, 2}, {0, 0, 1, 1, 1}, {0, 0, 1, 1, 2}, {0, 0, 1, 1, 2}};
         t.series = make_series({0, 110, 240, 390, 500}, coarse, coarse);
       }},
      {"runs-left-out",
       [](axiometry::Test& t) {
         auto up = table2::up, down = table2::down;
         for (auto* runs : {&up, &down}) runs->insert(runs->begin() + 3, RunDeviations(table2::targets.size(), none));
         t.series = make_series(table2::targets, up, down);
       }},
      {"runs-in-blocks",
       [](axiometry::Test& t) {
         auto up = table2::up, down = table2::down;
         up.insert(up.end(), 5, RunDeviations(table2::targets.size(), none));
         down.insert(down.begin(), 5, RunDeviations(table2::targets.size(), none));
         t.series = make_series(table2::targets, up, down);
       }},
      {"source-remark", [](axiometry::Test& t) { t.provenance.remarks.push_back(swapped_labels_remark()); }},
      {"ordered-progression", [&](axiometry::Test& t) { on_runs(t, 30.0); }},
      {"air-pressure-unlikely",
       [](axiometry::Test& t) { t.metadata.environment.air_pressure_end = Pressure::kPa(29.92); }},
      {"impossible-date", [](axiometry::Test& t) { t.metadata.conditions.date = "2099-01-01"; }},
      {"impossible-date", [](axiometry::Test& t) { t.metadata.conditions.date = "0001-01-01"; }},
      {"temperature-change",
       [](axiometry::Test& t) { t.metadata.environment.sensors.front().end = Temperature::celsius(35); }},
      {"part-of-axis-travel",
       [](axiometry::Test& t) {
         t.metadata.axis.travel_begin = Position::native(0), t.metadata.axis.travel_end = Position::native(2900);
       }},
  };
  for (const auto& [id, change] : changes) {
    axiometry::Test test = whole();
    change(test);
    if (id == std::string("part-of-axis-travel"))
      test.series = make_series({100, 210, 340, 490, 600}, {{1, 2, 3, 2, 1}, {2, 2, 1, 2, 2}},
                                {{1, 2, 3, 2, 1}, {2, 2, 1, 2, 2}});
    EXPECT_EQ(std::ranges::count(ids_against(test, ClaimKind::tested), std::string(id)), 1)
        << id << '\n'
        << points(test, ClaimKind::tested);
    EXPECT_TRUE(holds(test, ClaimKind::computed)) << id;
  }
}

std::vector<std::string> ids_against_tested(const axiometry::Test& test, const Assessment& assessment) {
  std::vector<std::string> ids;
  const Claims all = claims_of(test, assessment);
  for (const Finding& f : claim(all, ClaimKind::tested).against) ids.push_back(f.id);
  return ids;
}

TEST(Claims, OfTheTestFallWithAgreedSurroundingsOfWhichNobodyKnows) {
  for (const char* id : {"environment-known-in-part", "environment-perhaps-exceeded", "environment-rate-not-measured",
                         "environment-other-day"}) {
    Assessment assessment = assess(whole());
    assessment.findings.push_back({id, "4.1", Severity::missing, "found something open"});
    EXPECT_EQ(ids_against_tested(whole(), assessment), std::vector<std::string>{id});
  }
  Assessment noted = assess(whole());
  noted.findings.push_back({"environment-gap", "4.1", Severity::note, "found a gap"});
  EXPECT_TRUE(ids_against_tested(whole(), noted).empty());
}

TEST(Claims, TakeInitialsForSomebody) {
  const auto reported = [](const char* inspector) {
    axiometry::Test test = whole();
    test.metadata.conditions.inspector = inspector;
    return holds(test, ClaimKind::reported);
  };
  EXPECT_TRUE(reported("K. A."));
  EXPECT_TRUE(reported("N.B."));
  for (const char* nobody : {"k. A.", "n. b.", "N/A", "K.A", ""}) EXPECT_FALSE(reported(nobody)) << nobody;
}

TEST(Claims, OfTheTestTakeTemperaturesFromALogToo) {
  axiometry::Test test = whole();
  test.metadata.environment = {};
  const auto asked = [&](bool recorded) {
    Assessment assessment = assess(test);
    assessment.temperatures_recorded = recorded;
    return std::ranges::count(ids_against_tested(test, assessment), std::string("temperatures-not-stated"));
  };
  EXPECT_EQ(asked(false), 1);
  EXPECT_EQ(asked(true), 0);
  test.metadata.nde.applied = false;
  EXPECT_EQ(asked(true), 1) << "nothing here holds the log's 26 °C against an axis that was not corrected";
  for (const bool recorded : {false, true}) {
    Assessment assessment = assess(test);
    assessment.temperatures_recorded = recorded;
    const Claims all = claims_of(test, assessment);
    const std::vector<Finding>& against = claim(all, ClaimKind::tested).against;
    const auto found = std::ranges::find(against, "temperatures-not-stated", &Finding::id);
    ASSERT_NE(found, against.end());
    EXPECT_EQ(found->message.contains("are in the log alone"), recorded);
    EXPECT_EQ(found->message.contains("are not stated"), !recorded);
  }
}

TEST(Claims, OfTheTestAreContradictedByWhatTheStandardForbids) {
  const std::pair<const char*, Change> changes[] = {
      {"4.1", [](axiometry::Test& t) { t.metadata.nde.applied = false; }},
      {"5.2", [](axiometry::Test& t) { t.metadata.axis.compensation_points.push_back(175.077); }},
      {"5.3.2", [](axiometry::Test& t) { t.metadata.conditions.cycle = TestCycle::pilgrim; }},
      {"Annex B", [](axiometry::Test& t) { t.metadata.conditions.cycle = TestCycle::step; }},
      {"source",
       [](axiometry::Test& t) {
         t.provenance.remarks.push_back({true, "found a guess"});
       }},
  };
  for (const auto& [clause, change] : changes) {
    axiometry::Test test = whole();
    change(test);
    EXPECT_NE(points(test, ClaimKind::tested).find(std::string("departure ") + clause + ":"), std::string::npos)
        << clause << '\n'
        << points(test, ClaimKind::tested);
  }
}

/// The complete test on other targets, with n runs.
axiometry::Test on(const std::vector<double>& targets, std::size_t n = 5) {
  std::vector<RunDeviations> up(n), down(n);
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = 0; i < targets.size(); ++i) {
      up[j].push_back(0.1 * static_cast<double>((i * 7 + j * 3) % 5));
      down[j].push_back(0.1 * static_cast<double>((i * 3 + j * 2) % 7));
    }
  axiometry::Test test = whole();
  test.metadata.axis.compensation_points = {-5};
  test.metadata.axis.travel_begin = Position::native(targets.front() - 10);
  test.metadata.axis.travel_end = Position::native(targets.back() + 10);
  test.series = make_series(targets, up, down);
  return test;
}

TEST(Claims, OfTheTestNeedTargetsAfterFormulaOne) {
  EXPECT_EQ(points(on({0, 110, 240, 390, 500}), ClaimKind::tested), "");
  EXPECT_NE(points(on({0, 100, 200, 300, 400}), ClaimKind::tested).find("missing 5.2: found 5 equally spaced"),
            std::string::npos);
  EXPECT_NE(points(on({0, 20, 40, 70, 90, 500}), ClaimKind::tested).find("missing 5.2"), std::string::npos);
  axiometry::Test gauge = on({0, 100, 200, 300, 400});  // a gauge has the steps it has
  gauge.metadata.artefact.type = "step gauge";
  gauge.metadata.artefact.calibrated_positions = {0, 100, 200, 300, 400};
  EXPECT_EQ(points(gauge, ClaimKind::tested).find("missing 5.2"), std::string::npos);
}

TEST(Claims, OfTheTestNeedNumberDirectionsAndRuns) {
  EXPECT_FALSE(holds(on({0, 160, 300}), ClaimKind::tested));
  EXPECT_FALSE(holds(on({0, 110, 240, 390, 500}, 3), ClaimKind::tested));
  axiometry::Test one_way = on({0, 110, 240, 390, 500});
  one_way.series = make_series({0, 110, 240, 390, 500}, {{0, 1, 0, 1, 0}, {1, 0, 1, 0, 1}}, {});
  EXPECT_FALSE(holds(one_way, ClaimKind::tested));
  EXPECT_FALSE(holds(one_way, ClaimKind::reported)) << "clause 8.2 lists parameters that do not exist";
  EXPECT_TRUE(holds(one_way, ClaimKind::computed));
}

TEST(Claims, OfALongAxisNeedTheOtherTestToo) {
  axiometry::Test test = on({0, 260, 490, 760, 1010, 1240, 1500, 1770, 1990, 2260, 2500}, 1);
  test.metadata.axis.travel_end = Position::native(2600);
  EXPECT_NE(points(test, ClaimKind::tested).find("missing 5.3.3"), std::string::npos);
  EXPECT_EQ(points(test, ClaimKind::reported).find("8.2.3"), std::string::npos) << "R and A are not applicable";
}

TEST(Claims, OfTheComputationFallWhereNoApproachWasMeasuredOrATermIsMissing) {
  axiometry::Test averages = whole();
  averages.provenance.remarks.push_back(
      {true, "found averages only, expected single approaches; R and A do not exist, and means stand for readings"});
  EXPECT_FALSE(holds(averages, ClaimKind::computed));

  axiometry::Test lower_bound = bare();
  std::vector<RunDeviations> up = {{1, 2, 3, 2, 1}, {1, none, 3, 2, 2}}, down = {{1, 2, 3, 2, 1}, {2, 2, 3, 3, 1}};
  lower_bound.series = make_series({0, 110, 240, 390, 500}, up, down);
  EXPECT_FALSE(holds(lower_bound, ClaimKind::computed));

  axiometry::Test step = whole();
  step.metadata.conditions.cycle = TestCycle::step;
  EXPECT_FALSE(holds(step, ClaimKind::computed));

  EXPECT_EQ(ids_against(averages, ClaimKind::computed), std::vector<std::string>{"source-remark"});
  EXPECT_EQ(ids_against(lower_bound, ClaimKind::computed), std::vector<std::string>{"zero-for-a-term"});
  EXPECT_EQ(ids_against(step, ClaimKind::computed), std::vector<std::string>{"step-cycle"}) << "as the rule's finding";
}

TEST(Claims, OfTheReportAskForNoDayOfASimulation) {
  axiometry::Test test = whole();
  test.metadata.conditions.date = "None: simulated";
  EXPECT_EQ(points(test, ClaimKind::reported), "");
  test.metadata.equipment.front().calibration_due = "2024-12-31";
  EXPECT_EQ(ids_against(test, ClaimKind::reported), std::vector<std::string>{"date-not-read"});
}

TEST(Claims, OfTheReportStandWithAMachineAtTwentyDegreesAndNoMisalignment) {
  axiometry::Test test = whole();
  test.metadata.uncertainty.machine_temperature_difference = TemperatureDifference::kelvin(0);
  test.metadata.uncertainty.misalignment = Length::mm(0);
  for (auto& sensor : test.metadata.environment.sensors) sensor.start = sensor.end = Temperature::celsius(20);
  EXPECT_EQ(points(test, ClaimKind::reported), "");
}

TEST(Claims, OfTheReportFallWithAnyItemOfClauseEight) {
  const std::pair<const char*, Change> changes[] = {
      {"8.1", [](axiometry::Test& t) { t.metadata.conditions.inspector.clear(); }},
      {"8.1", [](axiometry::Test& t) { t.metadata.conditions.inspector = "-"; }},
      {"8.1", [](axiometry::Test& t) { t.metadata.conditions.date = "2099-13-45"; }},
      {"8.1", [](axiometry::Test& t) { t.metadata.conditions.date = "05/06/2014"; }},
      {"8.2.1", [](axiometry::Test& t) { t.metadata.equipment.front().calibration_due = "expired"; }},
      {"8.2.1", [](axiometry::Test& t) { t.metadata.equipment.front().calibration_due = "2014-05-14"; }},
      {"8.1", [](axiometry::Test& t) { t.metadata.conditions.tool_offset_mm.clear(); }},
      {"8.1", [](axiometry::Test& t) { t.metadata.equipment.front().serial_number.clear(); }},
      {"8.1", [](axiometry::Test& t) { t.metadata.equipment.front().serial_number = "unbekannt"; }},
      {"8.1",
       [](axiometry::Test& t) {
         t.metadata.artefact.type = "step gauge";
         t.metadata.artefact.calibrated_positions = {0, 1};
       }},
      {"8.1", [](axiometry::Test& t) { t.metadata.conditions.inspector = "nicht angegeben"; }},
      {"8.2.1", [](axiometry::Test& t) { t.metadata.uncertainty = {}; }},
      {"8.2.1", [](axiometry::Test& t) { t.metadata.uncertainty.misalignment.reset(); }},
      {"8.2.1",
       [](axiometry::Test& t) { t.metadata.uncertainty.device_calibration_per_length = RelativeLength::um_per_m(0); }},
      {"8.2.1",
       [](axiometry::Test& t) { t.metadata.uncertainty.machine_temperature_range = TemperatureDifference::kelvin(0); }},
      {"8.2.1", [](axiometry::Test& t) { t.metadata.uncertainty.environmental_variation = Deviation::native(0); }},
  };
  for (const auto& [clause, change] : changes) {
    axiometry::Test test = whole();
    change(test);
    EXPECT_NE(points(test, ClaimKind::reported).find(std::string("missing ") + clause), std::string::npos) << clause;
    EXPECT_TRUE(holds(test, ClaimKind::tested) || std::string(clause) == "8.1") << points(test, ClaimKind::tested);
  }
}

TEST(Claims, OfTheTestAreContradictedWhereAFindingDepartsAndOnlyThere) {
  axiometry::Test diagonal = whole();
  diagonal.metadata.axis.line_origin_mm = {0, 0, 0};
  diagonal.metadata.axis.line_direction = {1, 1, 1};
  for (const axiometry::Test& test : {whole(), bare(), on({0, 100, 200, 300, 400}), on({0, 160, 300}), diagonal}) {
    const Claims all = claims(test);
    const bool contradicted = std::ranges::any_of(claim(all, ClaimKind::tested).against,
                                                  [](const Finding& f) { return f.severity == Severity::departure; });
    EXPECT_EQ(contradicted, !assess(test).conforming());
  }
}

TEST(Claims, AreTheSameAtEitherDepth) {
  axiometry::Test drifting = whole();
  std::vector<RunDeviations> runs;
  for (int j = 0; j < 5; ++j) runs.push_back({1 + 30.0 * j, 2 + 30.0 * j, 3 + 30.0 * j, 2 + 30.0 * j, 1 + 30.0 * j});
  drifting.series = make_series({0, 110, 240, 390, 500}, runs, runs);
  EXPECT_TRUE(assess(drifting, Depth::departures_only).progression);
  EXPECT_EQ(assess(drifting, Depth::departures_only).progression->message, assess(drifting).progression->message);
  for (const axiometry::Test& test : {whole(), bare(), on({0, 100, 200, 300, 400}), on({0, 160, 300}), drifting}) {
    const Claims shallow = claims_of(test, assess(test, Depth::departures_only)), deep = claims(test);
    for (std::size_t k = 0; k < deep.size(); ++k) EXPECT_EQ(shallow[k].against.size(), deep[k].against.size()) << k;
  }
}

TEST(Claims, NameTheStandardOfADiagonal) {
  axiometry::Test test = whole();
  test.metadata.axis.line_origin_mm = {0, 0, 0};
  test.metadata.axis.line_direction = {1, 1, 1};
  EXPECT_EQ(claim(claims(test), ClaimKind::tested).title, "Tested in accordance with ISO 230-6");
}

std::string word_of(const TestEnvironment* surroundings, bool both_directions, bool travel_stated) {
  using testing_support::RunDeviations;
  const std::vector<RunDeviations> runs = {{1.0, 2.0}, {1.5, 2.5}};
  Test test{{}, testing_support::make_series({0, 10}, runs, both_directions ? runs : std::vector<RunDeviations>()), {}};
  if (travel_stated) {
    test.metadata.axis.travel_begin = Position::native(0.0);
    test.metadata.axis.travel_end = Position::native(10.0);
  }
  return word_of_the_tester(test, surroundings);
}

TEST(Claims, RestOnTheWordOfTheTesterForTheGradientUnlessALogShowsItKept) {
  constexpr std::string_view on_his_word = "soaked and the gradient of the temperature within what was agreed";
  constexpr std::string_view by_the_log = "the log of temperatures shows their gradient";
  TestEnvironment logged;
  EnvironmentItem gradient{.key = "machine_gradient_C", .title = "", .unit = "°C", .clause = "4.1"};
  EnvironmentItem highest{.key = "highest_C", .title = "", .unit = "°C", .clause = "7"};
  highest.standing = EnvironmentStanding::kept;
  for (const auto standing :
       {EnvironmentStanding::kept, EnvironmentStanding::exceeded, EnvironmentStanding::not_measured,
        EnvironmentStanding::not_agreed, EnvironmentStanding::known_in_part}) {
    gradient.standing = standing;
    logged.items = {highest, gradient};
    const std::string word = word_of(&logged, true, true);
    const bool kept = standing == EnvironmentStanding::kept;
    EXPECT_EQ(word.find(by_the_log) != word.npos, kept) << standing_key(standing);
    EXPECT_EQ(word.find(on_his_word) != word.npos, !kept) << standing_key(standing);
  }
  EXPECT_NE(word_of(nullptr, true, true).find(on_his_word), std::string_view::npos);
  EXPECT_EQ(word_of(nullptr, true, true).find("axis travel"), std::string::npos);
  EXPECT_NE(word_of(nullptr, true, false).find("since the ends of the axis travel are not stated"), std::string::npos);
}

TEST(Claims, RestOnTheWordOfTheTesterForTheSoakingUnlessItsTimeIsStated) {
  constexpr std::string_view on_his_word = "machine and instrument were soaked", by_the_log = "the log of temperatures";
  EnvironmentItem gradient{.key = "machine_gradient_C", .title = "", .unit = "°C", .clause = "4.1"};
  for (const auto standing : {EnvironmentStanding::kept, EnvironmentStanding::not_measured})
    for (const bool stated : {true, false}) {
      gradient.standing = standing;
      gradient.stated = stated;
      TestEnvironment surroundings;
      surroundings.items = {gradient};
      const std::string without = word_of(&surroundings, true, true);
      EXPECT_NE(without.find(on_his_word), without.npos);
      EXPECT_EQ(without.find("is stated"), stated && standing == EnvironmentStanding::kept
                                               ? without.find("is stated, within what was agreed")
                                               : without.npos);
      surroundings.soaked_h = 12.0;
      const std::string with = word_of(&surroundings, true, true);
      EXPECT_NE(with.find("how long machine and instrument were soaked"), with.npos);
      EXPECT_EQ(with.find("other is given, machine and instrument were soaked"), with.npos);
      EXPECT_EQ(with.find(by_the_log) != with.npos, standing == EnvironmentStanding::kept && !stated);
      surroundings.soaked_h = 0.0;
      EXPECT_EQ(word_of(&surroundings, true, true), without) << "no time at all is no soaking";
    }
}

TEST(Claims, NameNoStandardCycleOfOneDirection) {
  EnvironmentItem gradient{.key = "machine_gradient_C", .title = "", .unit = "°C", .clause = "4.1"};
  for (const auto standing : {EnvironmentStanding::kept, EnvironmentStanding::not_measured})
    for (const bool stated : {true, false})
      for (const double soaked_h : {0.0, 12.0}) {
        gradient.standing = standing;
        gradient.stated = stated;
        TestEnvironment surroundings;
        surroundings.items = {gradient};
        surroundings.soaked_h = soaked_h;
        const std::string word = word_of(&surroundings, false, true);
        EXPECT_EQ(word.find("cycle"), word.npos) << word;
        EXPECT_THAT(word, testing::ContainsRegex("it: (machine and .* were|the machine was|the gradient .* was) "));
        for (const language::Language language : language::languages())
          EXPECT_TRUE(language::is_known(word, language)) << word;
      }
}

}  // namespace
}  // namespace axiometry::iso230_2
