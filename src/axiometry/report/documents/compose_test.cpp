// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/documents/compose.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

#include "axiometry/language/language.h"
#include "axiometry/model/fields.h"
#include "axiometry/standards/readings/reading_correction.h"
#include "tests/support/document_parts.h"
#include "tests/support/report_subject.h"
#include "tests/support/series.h"

namespace axiometry::report {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;
using testing_support::Reported;
using testing_support::reported;
using testing_support::reported_table2;
using testing_support::reported_without_metadata;
using testing_support::section;
using testing_support::section_ids;
using testing_support::tables;
using testing_support::tolerance;

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

std::vector<std::string> row_text(const std::vector<TableCell>& row) {
  std::vector<std::string> cells;
  for (const TableCell& cell : row) cells.push_back(plain_text(cell.text));
  return cells;
}

/// "name: value" of every fact.
std::vector<std::string> facts(const Section& section) {
  std::vector<std::string> all;
  for (const Block& block : section.blocks)
    if (const auto* facts = std::get_if<Facts>(&block))
      for (const Fact& fact : facts->facts) all.push_back(plain_text(fact.name) + ": " + plain_text(fact.value.text));
  return all;
}

Document composed(const Reported& reported) { return compose(reported.subject(), reported.options); }

TEST(Compose, PutsTheResultFirstAndTheSignaturesLast) {
  EXPECT_THAT(section_ids(composed(reported_table2())),
              ElementsAre("parameters", "figures", "claims", "findings", "identification", "positions", "uncertainty",
                          "information", "provenance", "release"));
}

TEST(Compose, GivesNoVerdictWithoutATolerance) {
  const Document document = composed(reported_table2());
  EXPECT_EQ(document.status.size(), 1u);
  const Table table = tables(section(document, "parameters")).at(0);
  for (const Column& column : table.columns) EXPECT_NE(plain_text(column.head), "Verdict");
}

TEST(Compose, CallsATestThatKeepsAndStatesEverythingOneOfTheStandard) {
  const Document document = composed(reported_table2());
  ASSERT_EQ(document.status.size(), 1u);
  EXPECT_EQ(document.status[0].tone, Tone::normal) << "green is for what conforms to its tolerance";
  EXPECT_EQ(plain_text(document.status[0].heading), "Tested in accordance with ISO 230-2:2014");
}

TEST(Compose, CallsBareNumbersComputedAndNoMore) {
  const Document document = composed(testing_support::reported_without_metadata());
  EXPECT_EQ(document.status[0].tone, Tone::caution) << "nothing known contradicts, much is not stated";
  EXPECT_EQ(plain_text(document.status[0].heading),
            "Computed after clause 3 of ISO 230-2:2014; not a test in accordance with it");
  EXPECT_EQ(document.edition, "Computed after clause 3 of ISO 230-2:2014");
  const Table claims = tables(section(document, "claims")).at(0);
  EXPECT_THAT(row_text(claims.rows[0]), ElementsAre("Computed after clause 3 of ISO 230-2:2014", "Yes", "–", "–"));
  EXPECT_EQ(row_text(claims.rows[1])[1], "No");
}

TEST(Compose, SaysAtTheTopThatADepartingResultIsNone) {
  Reported table2 = reported_table2();
  table2.assessment.findings.insert(table2.assessment.findings.begin(),
                                    {"number-of-approaches", "5.3.2", iso230_2::Severity::departure, "found 4 runs"});
  const Document document = composed(table2);
  EXPECT_EQ(document.status[0].tone, Tone::bad);
  EXPECT_THAT(plain_text(document.status[0].heading), HasSubstr("not a test in accordance with it"));
  EXPECT_EQ(plain_text(document.status[0].lines[0]), "Found 4 runs (5.3.2).");
  EXPECT_EQ(document.running_status, "Computed after clause 3 of ISO 230-2:2014");
}

TEST(Compose, RepeatsTheLabelWhereverResultsStand) {
  Reported table2 = reported_table2();
  table2.assessment.label = "step cycle (Annex B), not for acceptance";
  const Document document = composed(table2);
  EXPECT_EQ(document.label, table2.assessment.label);
  EXPECT_THAT(document.running_status, HasSubstr(table2.assessment.label));
  for (std::string_view id : {"parameters", "figures", "positions", "uncertainty", "information"})
    EXPECT_TRUE(section(document, id).shows_results) << id;
}

TEST(Compose, KeepsWhatRunsOnEveryPageToALine) {
  Reported table2 = reported_table2();
  for (int k = 0; k < 500; ++k) table2.test.metadata.machine.name += "立";
  table2.test.metadata.conditions.report_number = std::string(500, '9');
  const Document document = composed(table2);
  EXPECT_EQ(document.running_head.size(), std::string_view("Axis X · Mill 5").size() + 57 * 3 + 3);
  EXPECT_THAT(document.running_head, ::testing::EndsWith("立…"));
  EXPECT_LT(document.running_number.size(), 40u);
}

TEST(ParameterSection, ListsTheTwelveWithSymbolsOfBothStandards) {
  const auto table = tables(section(composed(reported_table2()), "parameters")).at(0);
  ASSERT_EQ(table.rows.size(), std::size(iso230_2::parameters));
  EXPECT_THAT(row_text(table.rows[1]),
              ElementsAre("A↑\u2009*)", "EXX,A↑", "Unidirectional positioning error", "6.1", "4.3", "µm", "3.26"));
  EXPECT_EQ(row_text(table.rows[4]).front(), "E↑");
}

TEST(ParameterSection, LeavesTheSecondSymbolOutForAnAxisWithoutALetter) {
  Reported table2 = reported_table2();
  table2.test.metadata.axis.name = "the long one";
  EXPECT_EQ(tables(section(composed(table2), "parameters")).at(0).columns.size(), 6u);
}

TEST(Verdict, NamesTheRuleAndWhatDoesNotConform) {
  Reported table2 = reported_table2();
  table2.judge({tolerance("A", 10), tolerance("B", 4)});
  const Document document = composed(table2);
  const Notice& notice = document.status.at(0);
  EXPECT_EQ(notice.tone, Tone::bad);
  EXPECT_EQ(plain_text(notice.heading), "Does not conform: B");
  EXPECT_EQ(plain_text(notice.lines.at(0)), "B = (4.12 ± 0.92)\u00a0µm (Annex A); tolerance 4\u00a0µm");
  EXPECT_EQ(plain_text(notice.lines.at(1)), "Conforms: A.");
  EXPECT_EQ(plain_text(notice.lines.at(2)), "Decision rule: simple acceptance.");
  EXPECT_THAT(plain_text(document.status.at(1).heading), HasSubstr("Tested in accordance with"));
  const Table table = tables(section(document, "parameters")).at(0);
  EXPECT_THAT(row_text(table.rows[10]), ElementsAre("B\u2009*)", "EXX,B", "Reversal error", "4.12", "0.92", "4", "µm",
                                                    "does not conform", "3.16"));
  EXPECT_THAT(row_text(table.rows[3]), Contains(""));  // no tolerance of E
  EXPECT_THAT(plain_text(table.notes.back()), HasSubstr("simple acceptance"));
}

TEST(Verdict, StandsBelowTheStatementThatTheResultIsNoneOfTheStandard) {
  Reported table2 = reported_table2();
  table2.assessment.findings.insert(table2.assessment.findings.begin(),
                                    {"number-of-approaches", "5.3.2", iso230_2::Severity::departure, "found 4 runs"});
  table2.judge({tolerance("A", 10)});
  const Document document = composed(table2);
  EXPECT_THAT(plain_text(document.status.at(0).heading), HasSubstr("not a test in accordance with it"));
  EXPECT_EQ(plain_text(document.status.at(1).heading), "Conforms: A");
}

TEST(Verdict, NamesTheValuesOfThreeAtMost) {
  Reported table2 = reported_table2();
  table2.judge({tolerance("A", 10), tolerance("E", 10), tolerance("R", 10), tolerance("M", 10), tolerance("B", 10)});
  const auto lines = composed(table2).status.at(0).lines;
  ASSERT_EQ(lines.size(), 5u);
  EXPECT_EQ(plain_text(lines.at(3)), "… and 2 more.");
}

TEST(TitlePage, NamesCustomerInspectorAndInstrumentWhereTheyWereGiven) {
  Reported table2 = reported_table2();
  table2.test.metadata.conditions.customer = "Miller";
  table2.test.metadata.conditions.inspector = "Smith";
  table2.test.metadata.equipment = {{"Laser", "Maker", "LI-1", "1234"}};
  std::vector<std::string> facts_there;
  for (const Fact& fact : composed(table2).identity)
    facts_there.push_back(plain_text(fact.name) + ": " + plain_text(fact.value.text));
  EXPECT_THAT(facts_there, AllOf(Contains("Customer: Miller"), Contains("Inspector: Smith"),
                                 Contains("Instrument: Maker, LI-1, 1234")));
  EXPECT_EQ(composed(reported({{}, testing_support::make_series({0, 100}, {{1, 2}}, {{2, 3}}), {}})).identity.size(),
            5u);
}

TEST(ReleaseSection, HasTheInspectorsNameAndRoomForSignatures) {
  Reported table2 = reported_table2();
  table2.test.metadata.conditions.inspector = "Smith";
  EXPECT_THAT(facts(section(composed(table2), "release")),
              AllOf(Contains("Name: Smith"), Contains("Signature: __________________"),
                    Contains("Date of issue: __________________")));
}

TEST(Verdict, IsNotGivenOnWhatDoesNotExist) {
  Reported single = reported({{}, testing_support::make_series({0, 100, 200}, {{1, 2, 3}}, {{2, 3, 4}}), {}});
  single.judge({tolerance("R", 5)});
  const Document document = composed(single);
  EXPECT_EQ(plain_text(document.status.back().heading), "No verdict");
  const auto R = row_text(tables(section(document, "parameters")).at(0).rows[7]);
  EXPECT_THAT(R, AllOf(Contains("R"), Contains("not applicable"), Contains("no verdict")));
  const auto decision = row_text(tables(section(document, "conformity")).at(0).rows.at(0));
  EXPECT_THAT(decision, ElementsAre("R", "–", "5", "no verdict"));
}

TEST(Verdict, IsUndecidedAsACautionWhereTheUncertaintyReachesOverTheLimit) {
  Reported table2 = reported_table2();
  table2.judge({tolerance("A", 10), tolerance("E", 20)}, {uncertainty::DecisionRule::Kind::iso_14253_1});
  const Notice notice = composed(table2).status.at(0);
  EXPECT_EQ(notice.tone, Tone::caution);
  EXPECT_EQ(plain_text(notice.heading), "Undecided: A");
  EXPECT_EQ(plain_text(notice.lines.at(2)), "Decision rule: ISO 14253-1.");
}

// u(A) = 2.1353 µm and u(B) = 0.4592 µm by Annex A; Φ from tables.
TEST(ConformitySection, ShowsLimitsProbabilityAndRiskOfEveryDecision) {
  Reported table2 = reported_table2();
  table2.judge({tolerance("A", 10), tolerance("B", 3)}, {uncertainty::DecisionRule::Kind::iso_14253_1});
  const Section conformity = section(composed(table2), "conformity");
  const Table table = tables(conformity).at(0);
  EXPECT_THAT(row_text(table.rows.at(0)),
              ElementsAre("A", "9.6", "2.1", "10", "6.48", "13.52", "57.7\u00a0%", "–", "undecided"));
  EXPECT_THAT(row_text(table.rows.at(1)), ElementsAre("B", "4.12", "0.46", "3", "2.245", "3.755", "0.73\u00a0%",
                                                      "0.73\u00a0%\u00a0producer’s", "does not conform"));
  EXPECT_THAT(plain_text(table.notes.at(0)),
              AllOf(HasSubstr("Decision rule: ISO 14253-1."), HasSubstr("with a probability of 95 % or more"),
                    HasSubstr("u = U/2 by Annex A.")));
  EXPECT_EQ(plain_text(table.notes.at(1)), "Limits: A, B from the command line.");
  EXPECT_TRUE(std::holds_alternative<Figure>(conformity.blocks.at(1)));
}

TEST(ConformitySection, SaysWhereEachLimitComesFrom) {
  Reported table2 = reported_table2();
  iso230_2::Tolerance of_table = tolerance("A", 10);
  of_table.source = iso230_2::ToleranceSource::table;
  of_table.origin = "Grinder, up to 2000 mm, in limits.csv";
  iso230_2::Tolerance of_test = tolerance("E", 8);
  of_test.source = iso230_2::ToleranceSource::test;
  table2.judge({of_table, of_test, tolerance("B", 5)});
  EXPECT_EQ(plain_text(tables(section(composed(table2), "conformity")).at(0).notes.at(1)),
            "Limits: A from the tolerance table Grinder, up to 2000 mm, in limits.csv; E from the file of the test; B "
            "from the command line.");
}

TEST(ConformitySection, SaysWhereNoValueCouldBeAccepted) {
  Reported table2 = reported_table2();
  table2.judge({tolerance("A", 2)}, {uncertainty::DecisionRule::Kind::iso_14253_1});
  const Table table = tables(section(composed(table2), "conformity")).at(0);
  EXPECT_EQ(row_text(table.rows.at(0)).at(4), "none");
  EXPECT_THAT(plain_text(table.notes.at(2)), HasSubstr("g is larger than T"));
}

std::vector<std::string> notes_on_decisions(const Reported& test) {
  const Table table = tables(section(composed(test), "conformity")).at(0);
  std::vector<std::string> notes;
  for (const RichText& note : table.notes) notes.push_back(plain_text(note));
  return notes;
}

TEST(ConformitySection, SaysThatNothingIsDecidedWithoutAnUncertainty) {
  Reported bare = reported_without_metadata();
  bare.judge({tolerance("A", 1)}, {uncertainty::DecisionRule::Kind::guard_band, 2.0});
  EXPECT_THAT(notes_on_decisions(bare), Contains(HasSubstr("no u is known, so that nothing is decided")));
}

/// Whatever the trials know, nobody said anything of the contributors that the standard asks for.
TEST(ConformitySection, SaysWhatLacksWhereAnnexAStatesNothing) {
  Reported bare = reported_without_metadata();
  iso230_2::MonteCarlo trials;
  auto& A = trials.distributions[0].emplace();
  A.summary.sd = 0.1;
  A.summary.distribution = uncertainty::SampledDistribution({{9.0, 10.0, 0, 1000}});
  A.by_hypothesis = {A.summary};
  A.low = 9.0;
  A.high = 10.0;
  bare.assessment.monte_carlo = trials;
  bare.judge({tolerance("A", 30)}, {uncertainty::DecisionRule::Kind::iso_14253_1});
  EXPECT_THAT(notes_on_decisions(bare), Contains(HasSubstr("hold only as far as what lacks is negligible: no "
                                                           "uncertainty is stated after Annex A")));
}

TEST(ConformitySection, SaysThatEquipmentWasOutOfCalibrationBesideWhatItsUncertaintyDecides) {
  Reported table2 = reported_table2();
  table2.judge({tolerance("A", 30)}, {uncertainty::DecisionRule::Kind::iso_14253_1});
  const std::string_view words = "only as far as the equipment measured as when it was calibrated: found a test";
  EXPECT_THAT(notes_on_decisions(table2), Not(Contains(HasSubstr(words))));
  table2.assessment.findings.push_back(
      {"equipment-calibrated", "8.2.1", iso230_2::Severity::note,
       "found a test on 2026-05-15, when its equipment was out of calibration: laser"});
  EXPECT_THAT(notes_on_decisions(table2), Contains(HasSubstr(words)));
}

TEST(ParameterSection, CallsNothingABasisForAcceptanceOfATestThatDeparts) {
  Reported table2 = reported_table2();
  const auto first_note = [&] {
    return plain_text(tables(section(composed(table2), "parameters")).front().notes.front());
  };
  EXPECT_THAT(first_note(), HasSubstr("May serve as a basis"));
  table2.assessment.findings.push_back(
      {"number-of-targets", "5.3.2", iso230_2::Severity::departure, "found 3 targets, expected 5"});
  EXPECT_THAT(first_note(), HasSubstr("departs from the standard"));
}

TEST(ConformitySection, LeavesUndecidedWhereAllThatIsDrawnLiesBelowALimitThatTheValueExceeds) {
  Reported table2 = reported_table2();
  iso230_2::MonteCarlo trials;
  auto& R_up = trials.distributions[8].emplace();  // all below what was measured, 2.99 µm
  R_up.summary.sd = 0.1;
  R_up.summary.distribution = uncertainty::SampledDistribution({{1.8, 2.2, 0, 1000}});
  R_up.by_hypothesis = {R_up.summary};
  R_up.low = 1.8;
  R_up.high = 2.2;
  table2.assessment.monte_carlo = trials;
  table2.judge({tolerance("R_up", 2.5), tolerance("A", 30)}, {uncertainty::DecisionRule::Kind::iso_14253_1});
  const Table table = tables(section(composed(table2), "conformity")).at(0);
  EXPECT_EQ(row_text(table.rows.at(0)).back(), "undecided");
  EXPECT_EQ(row_text(table.rows.at(1)).back(), "undecided");  // the method of record says nothing of A
  EXPECT_THAT(plain_text(table.notes.at(0)), HasSubstr("u by Monte Carlo, for this test."));
}

TEST(ConformitySection, IsAbsentWithoutATolerance) {
  EXPECT_THAT(section_ids(composed(reported_table2())), Not(Contains("conformity")));
}

TEST(IdentificationSection, ShowsEveryWantedFieldGivenOrNot) {
  const Section identification = section(composed(reported_without_metadata()), "identification");
  const auto all = facts(identification);
  for (const Field& field : metadata_fields())
    if (field.wanted == Field::Wanted::always) {
      EXPECT_THAT(all, Contains(std::string(field.title) + ": not stated")) << field.key;
    }
  EXPECT_THAT(all, Contains("Number of approaches n: 5 from each direction"));
  EXPECT_THAT(all, Contains("Air temperature: not stated"));
}

TEST(IdentificationSection, CountsApproachesAndNotTheNumbersOfTheRuns) {
  const testing_support::RunDeviations left_out(2, testing_support::none);
  const std::vector<testing_support::RunDeviations> up = {{1, 2}, left_out, {2, 2}};
  const std::vector<testing_support::RunDeviations> down = {left_out, {3, 4}, left_out, {4, 4}};
  const Reported test = reported({{}, testing_support::make_series({0, 100}, up, down), {}});
  EXPECT_THAT(facts(section(composed(test), "identification")),
              Contains("Number of approaches n: 2 from each direction"));
}

TEST(IdentificationSection, CallsReadingsOfOneDirectionNoStandardCycle) {
  const auto cycle = [](std::optional<TestCycle> stated, const std::vector<testing_support::RunDeviations>& down) {
    Metadata metadata;
    metadata.conditions.cycle = stated;
    return facts(section(composed(reported({metadata, testing_support::make_series({0, 100}, {{1, 2}}, down), {}})),
                         "identification"));
  };
  const auto says = [&](const auto& facts_of_test, const std::string& row) {
    EXPECT_THAT(facts_of_test, Contains("Test cycle: " + row));
    for (const language::Language language : language::languages()) EXPECT_TRUE(language::is_known(row, language));
  };
  const std::string label = "one direction of approach only, not for acceptance";
  says(cycle(TestCycle::standard, {{2, 3}}), "standard");
  says(cycle(TestCycle::standard, {}), "none but the standard one is given; " + label);
  says(cycle({}, {{2, 3}}), "not stated, taken to be the standard one");
  says(cycle({}, {}), "not stated; " + label);
}

TEST(IdentificationSection, ShowsEveryGivenFieldButThoseOfTheBudget) {
  const Reported table2 = reported_table2();
  const Section identification = section(composed(table2), "identification");
  std::string everything;
  for (const std::string& fact : facts(identification)) everything += fact + "\n";
  for (const Table& table : tables(identification)) {
    everything += plain_text(table.caption) + "\n";
    for (const auto& row : table.rows)
      for (const std::string& cell : row_text(row)) everything += cell + "\n";
  }
  for (const Field& field : metadata_fields()) {
    const bool given = !std::holds_alternative<std::monostate>(field.get(table2.test.metadata));
    const std::string stem(field.title.substr(0, std::min(field.title.find(", "), field.title.find(" at the "))));
    if (given && !field.key.starts_with("uncertainty.")) {
      EXPECT_THAT(everything, HasSubstr(stem)) << field.key;
    }
  }
  EXPECT_THAT(
      everything,
      HasSubstr("Air temperature: 20.6\u00a0°C\u00a0at\u00a0the\u00a0start, 20.9\u00a0°C\u00a0at\u00a0the\u00a0end"));
  EXPECT_THAT(everything, HasSubstr("Offset to tool reference X/Y/Z: 0 / 0 / 120\u00a0mm"));
  EXPECT_THAT(everything, HasSubstr("table, centre"));
}

TEST(IdentificationSection, ShowsTheReadingsOfASensorToTheSameDecimals) {
  Reported table2 = reported_table2();
  table2.test.metadata.environment.sensors = {
      {.role = "machine", .location = "table", .start = Temperature::celsius(20.4), .end = Temperature::celsius(21.0)},
      {.role = "air", .location = "beside", .start = Temperature::celsius(20.45), .end = Temperature::celsius(20.5)}};
  const auto all = tables(section(composed(table2), "identification"));
  EXPECT_THAT(row_text(all.back().rows[0]), ElementsAre("machine", "table", "20.40", "21.0"));
}

TEST(IdentificationSection, PutsTheRolesOfSensorsThatItKnowsIntoTheReadersLanguage) {
  Reported table2 = reported_table2();
  table2.test.metadata.environment.sensors = {{.role = "machine", .location = "air"}, {.role = "bed", .location = "x"}};
  const auto all = tables(section(composed(table2), "identification"));
  EXPECT_FALSE(all.back().rows[0][0].text.front().verbatim);
  EXPECT_TRUE(all.back().rows[0][1].text.front().verbatim) << "where it stands is the user's text";
  EXPECT_TRUE(all.back().rows[1][0].text.front().verbatim);
}

TEST(IdentificationSection, SetsLongTextsApartFromTheColumns) {
  Reported table2 = reported_table2();
  table2.test.metadata.conditions.comment = std::string(500, 'x');
  const Section identification = section(composed(table2), "identification");
  const auto* last = std::get_if<Facts>(&identification.blocks.back());
  ASSERT_TRUE(last);
  EXPECT_EQ(last->title, "Further particulars");
}

TEST(IdentificationSection, HonoursTheDecimalComma) {
  Reported table2 = reported_table2();
  table2.options.numbers = {','};
  EXPECT_THAT(
      facts(section(composed(table2), "identification")),
      Contains("Air temperature: 20,6\u00a0°C\u00a0at\u00a0the\u00a0start, 20,9\u00a0°C\u00a0at\u00a0the\u00a0end"));
}

Reported corrected_table2() {
  Test test = testing_support::table2::complete_test();
  test.metadata.instrument.gain = 1.000001;
  return reported(correct_readings(std::move(test), {.gain = true, .drift = true}).value());
}

TEST(Corrections, StandOnTheFirstPageAndInProvenance) {
  const Document document = composed(corrected_table2());
  EXPECT_EQ(plain_text(document.status.at(1).heading), "Readings corrected by this program: gain of the sensor, drift");
  const Section provenance = section(document, "provenance");
  EXPECT_THAT(facts(provenance), AllOf(Contains("Gain: 1.000001"), Contains("Datum: 6.711 mm"),
                                       Contains("Readings: applied by this program to the readings of the source, 0.00 "
                                                "to 1.74\u00a0µm each")));
  EXPECT_EQ(std::get<Facts>(provenance.blocks.at(2)).title, "Correction 2: Drift");
}

TEST(Corrections, HonourTheDecimalComma) {
  Reported table2 = corrected_table2();
  table2.options.numbers = {','};
  EXPECT_THAT(facts(section(composed(table2), "provenance")), Contains("Gain: 1,000001"));
}

TEST(Corrections, LeaveTheReadingsAsMeasuredInTheReport) {
  const auto all = tables(section(composed(corrected_table2()), "positions"));
  ASSERT_EQ(all.size(), 3u);
  EXPECT_THAT(plain_text(all[0].caption), HasSubstr("corrected"));
  EXPECT_THAT(plain_text(all[2].caption), HasSubstr("as measured"));
  EXPECT_THAT(row_text(all[2].rows[10]), ElementsAre("11", "1750.920", "−3.6", "−4.0", "−4.5", "−3.2", "−4.5", "−0.1",
                                                     "−0.6", "−1.2", "0.4", "−0.9"));
  EXPECT_EQ(row_text(all[0].rows[10])[2], "−1.8") << "1.74 µm of gain and 0.03 µm of drift";
}

TEST(InformationSection, StatesTheDriftOfTheReadings) {
  EXPECT_THAT(
      facts(section(composed(reported_table2()), "information")),
      Contains("Drift: −0.00258\u00a0µm per reading, standard uncertainty 0.00743\u00a0µm per reading, that is "
               "−0.3\u00a0µm over the test (least-squares line in time with a constant per target and direction; "
               "readings equally far apart in the order of the standard cycle). Information only: nothing was "
               "removed."));
  EXPECT_THAT(facts(section(composed(corrected_table2()), "information")),
              Contains("Drift: taken out by the correction for drift, see Provenance"));
  const Reported single = reported({{}, testing_support::make_series({0, 100}, {{1, 2}}, {{2, 3}}), {}});
  EXPECT_THAT(facts(section(composed(single), "information")),
              Contains("Drift: not applicable: one approach from each direction"));
  const Reported one_way = reported({{}, testing_support::make_series({0, 100}, {{1, 2}}, {}), {}});
  EXPECT_THAT(facts(section(composed(one_way), "information")),
              Contains("Drift: not applicable: one approach from one direction"));
}

TEST(FindingSection, ShowsRemarksOfTheReaderWithoutAClauseOfTheStandard) {
  auto test = testing_support::table2::complete_test();
  test.provenance.remarks = {{true, "found averages only"}};
  const Document document = composed(reported(std::move(test)));
  EXPECT_EQ(plain_text(document.status[0].lines[0]), "Found averages only (source).");
  EXPECT_THAT(row_text(tables(section(document, "findings")).at(0).rows.at(0)),
              ElementsAre("Departure", "source", "Found averages only."));
}

TEST(PositionSection, PutsBothDirectionsSideBySideWhileTheyFit) {
  const auto all = tables(section(composed(reported_table2()), "positions"));
  ASSERT_EQ(all.size(), 2u);
  EXPECT_THAT(row_text(all[0].rows[0]),
              ElementsAre("1", "6.711", "−1.2", "−1.7", "−1.9", "−1.3", "−1.9", "2.3", "2.1", "1.9", "2.8", "2.2"));
  EXPECT_THAT(row_text(all[1].rows[0]), ElementsAre("1", "6.711", "−1.6", "0.3", "0.7", "−2.3", "−0.9", "1.3", "2.3",
                                                    "0.3", "0.7", "1.6", "2.9", "1.3", "0.3", "−3.9", "5.2"));
}

TEST(PositionSection, PartsManyRunsSoThatTheyFitAPage) {
  std::vector<testing_support::RunDeviations> runs(20, {1, 2, 3, 4, 5});
  const auto all = tables(
      section(composed(reported({{}, testing_support::make_series({0, 1, 2, 3, 4}, runs, runs), {}})), "positions"));
  ASSERT_EQ(all.size(), 5u);
  for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(all[k].columns.size(), 12u) << k;
}

TEST(PositionSection, HasNoColumnsForWhatASingleApproachCannotTell) {
  const auto all = tables(
      section(composed(reported({{}, testing_support::make_series({0, 1}, {{1, 2}}, {{2, 3}}), {}})), "positions"));
  EXPECT_EQ(all[1].columns.size(), 6u);  // number, target, both means, their mean and the reversal
}

TEST(PositionSection, ShowsAMissingReadingAsADash) {
  const auto all = tables(section(
      composed(reported({{}, testing_support::make_series({0, 1}, {{1, 2}, {missing, 2}}, {}), {}})), "positions"));
  EXPECT_THAT(row_text(all[0].rows[0]), ElementsAre("1", "0", "1.0", "–"));
  EXPECT_EQ(all[1].groups.size(), 2u);  // target and ↑: nothing is said of ↓ or of both
}

TEST(UncertaintySection, ShowsAllContributorsWithTheirInputs) {
  const auto all = tables(section(composed(reported_table2()), "uncertainty"));
  ASSERT_EQ(all.size(), 5u);  // with the means of the targets and the inputs as resolved
  EXPECT_EQ(all[0].rows.size(), 7u);
  EXPECT_THAT(row_text(all[0].rows[0]), Contains(HasSubstr("1\u00a0µm/m")));
  EXPECT_EQ(all[2].rows.size(), 11u);  // composed of the contributors
  EXPECT_THAT(row_text(all[3].rows[0]),
              ElementsAre("R", "Bidirectional positioning repeatability", "6.6", "5.6", "µm"));
  EXPECT_EQ(all[4].rows.size(), 11u);
  EXPECT_THAT(row_text(all[4].rows[0]), Contains("floored"));
}

TEST(UncertaintySection, SaysInTheRowWhatAMissingContributorMeans) {
  Reported table2 = reported_table2();
  table2.assessment.annex_a->budget.at(1).U.reset();
  const auto budget = tables(section(composed(table2), "uncertainty")).at(0);
  EXPECT_THAT(row_text(budget.rows[1]), Contains("not given; left out"));
  EXPECT_THAT(row_text(budget.rows[3]), Contains("part of the device’s statement"));
}

TEST(UncertaintySection, SaysThatNoneWasEstimated) {
  const Section uncertainty = section(composed(reported_without_metadata()), "uncertainty");
  EXPECT_THAT(plain_text(std::get<Paragraph>(uncertainty.blocks.at(0)).text), StartsWith("Not estimated"));
}

TEST(InformationSection, GivesTheSlopeAndSaysThatItWasNotRemoved) {
  const auto series = testing_support::make_series({0, 500, 1000}, {{0, 5, 10}, {0, 5, 10}}, {{1, 6, 11}, {1, 6, 11}});
  const auto all = facts(section(composed(reported({{}, series, {}})), "information"));
  ASSERT_EQ(all.size(), 2u);
  EXPECT_THAT(all[0], HasSubstr("10.00\u00a0µm/m, that is 10.0\u00a0µm over the measured travel"));
  EXPECT_THAT(all[0], HasSubstr("nothing was removed"));
}

TEST(ProvenanceSection, LeadsBackToTheSource) {
  Reported table2 = reported_table2();
  table2.test.provenance = {"-", "abc", "csv-long"};
  const auto all = facts(section(composed(table2), "provenance"));
  EXPECT_THAT(all, Contains("Source file: standard input"));
  table2.test.provenance.file = "/home/someone/tests/x.csv";
  EXPECT_THAT(facts(section(composed(table2), "provenance")), Contains("Source file: x.csv"));
  EXPECT_THAT(all, Contains("SHA-256 of the source: abc"));
  EXPECT_THAT(all, Contains(HasSubstr("Amendment 1:2016 has not been taken into account")));
}

TEST(ProvenanceSection, SaysWhereTheTrailOfTheArchiveEndedBeforeItWasIssued) {
  const Reported table2 = reported_table2();
  EXPECT_THAT(facts(section(composed(table2), "provenance")), Not(Contains(HasSubstr("Audit trail"))));
  const Document issued = compose({table2.test, table2.assessment, table2.judgements, {}, "17:3f2a9c0b1d2e4f56"}, {});
  EXPECT_THAT(facts(section(issued, "provenance")), Contains("Audit trail before issue: 17:3f2a9c0b1d2e4f56"));
}

TEST(Compose, GivesEverySectionAnIdOfItsOwn) {
  const auto ids = section_ids(composed(reported_table2()));
  EXPECT_EQ(std::set<std::string>(ids.begin(), ids.end()).size(), ids.size());
}

TEST(Compose, ShowsSomeOfVeryManyTargetsAndTellsWhereTheOthersAre) {
  std::vector<double> targets;
  testing_support::RunDeviations first, second;
  for (std::size_t i = 0; i < 1500; ++i) {
    targets.push_back(double(i));
    first.push_back(0.01 * double(i * i % 313));
    second.push_back(0.01 * double(i * i % 311) + 0.001 * double(i));
  }
  axiometry::Test test{{}, testing_support::make_series(targets, {first, second}, {second, first}), {}};
  test.metadata.uncertainty.environmental_variation = Deviation::native(0.1);
  const Document document = composed(reported(std::move(test)));
  std::size_t of_targets = 0;
  for (const std::string_view id : {"positions", "uncertainty"})
    for (const Table& table : tables(section(document, id))) {
      if (table.groups.empty() || plain_text(table.groups.front().head) != "Target") continue;
      ++of_targets;
      EXPECT_GT(table.rows.size(), 490u);
      EXPECT_LT(table.rows.size(), 530u);
      EXPECT_EQ(plain_text(table.rows.front()[0].text), "1");
      EXPECT_EQ(plain_text(table.rows[1][0].text), "4");
      EXPECT_EQ(plain_text(table.rows[1][1].text), "3");  // its position
      EXPECT_EQ(plain_text(table.rows.back()[0].text), "1500");
      ASSERT_FALSE(table.notes.empty());
      EXPECT_THAT(plain_text(table.notes.back()), StartsWith("One target in 3 of 1500 stands here, "));
    }
  EXPECT_EQ(of_targets, 4u) << "readings, results, means with their U, corrected repeatability";
}

}  // namespace
}  // namespace axiometry::report
