// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <deque>
#include <string>

#include "axiometry/report/documents/compose.h"
#include "axiometry/report/drawing/svg.h"
#include "axiometry/report/figures/figure_rules_test_support.h"
#include "axiometry/report/figures/tracking/lines_overview.h"
#include "axiometry/report/tracking.h"
#include "axiometry/report/writer.h"
#include "tests/support/document_parts.h"
#include "tests/support/report_subject.h"

namespace axiometry::report {
namespace {

using testing::all_words;
using ::testing::Contains;
using testing::fault_of;
using ::testing::HasSubstr;
using ::testing::Not;
using testing_support::section;
using testing_support::section_ids;
using testing_support::tables;

/// Scatter without a random number: −1 to 1, the same on every machine.
double scatter(std::size_t k) { return (static_cast<double>((k * 7919 + 31) % 101) - 50.0) / 50.0; }

/// A machine whose seven lines were measured: everything that the report points into.
struct Measured {
  TrackingPlan plan;
  tracking::LinesEvaluation evaluation;
  std::deque<iso230_2::Assessment> assessments;
  std::vector<std::vector<iso230_2::Judgement>> judgements;
  iso230_6::DiagonalSummary diagonals;
  std::vector<AssessedLine> lines;

  LinesSubject subject() const {
    return {plan, evaluation, lines, diagonals, "/home/someone/lengths.csv", std::string(64, 'a')};
  }
};

tracking::EvaluatedLine evaluated_line(const std::string& id, Vector3 station, std::size_t number) {
  Vector3 direction;
  for (char c : id) direction[static_cast<std::size_t>(c - 'x')] = 1.0;
  const SpatialLine place{station, unit(direction)};
  constexpr std::size_t count = 6, runs = 5;
  std::vector<Position> targets;
  std::vector<Reading> readings;
  std::vector<double> distances;
  std::vector<Length> bounds;
  for (std::size_t i = 0; i < count; ++i) {
    const double d = 210.0 + 85.3 * static_cast<double>(i) + 3.0 * scatter(i + 7 * number);
    targets.push_back(Position::native(d));
    distances.push_back(d);
    bounds.push_back(Length::um(0.002 * (700.0 / d - 1.0)));
    for (Direction direction_of : {Direction::up, Direction::down})
      for (std::size_t j = 0; j < runs; ++j)
        readings.push_back(
            {i, direction_of, j,
             Deviation::native(-0.004 * static_cast<double>(number) * (d - 210.0) +
                               (direction_of == Direction::up ? 0.4 : -0.4) + 0.3 * scatter(i * 10 + j + number))});
  }
  Metadata metadata;
  metadata.axis.name = id;
  set_spatial_line(metadata.axis, place);
  metadata.machine.name = "Mill 7";
  metadata.conditions.date = "2026-11-20";
  return {.id = id,
          .test = {metadata, Series::make(targets, readings).value(), {}},
          .distances_mm = distances,
          .offset = {.larger_mm = 0.003, .smaller_mm = 0.001},
          .length_difference_bounds = bounds,
          .negligible_from_mm = number % 2 == 0 ? 90.0 : 250.0,
          .slope_um_per_m = -4.0 * static_cast<double>(number),
          .slope_uncertainty_um_per_m = 0.21,
          .breaks = {}};
}

Measured measured(const std::vector<std::string>& ids = {"x", "y", "z", "xy", "xz", "yz", "xyz"}) {
  Measured m;
  m.plan.title = "Seven lines";
  m.plan.setup = {.travel = {{0, 0, 0}, {1000, 800, 700}},
                  .tool_offset_mm = {0, 0, -120},
                  .station = {{150, 120, -60}, Matrix3{{{1e-6, 0, 0}, {0, 2e-6, 0}, {0, 0, 9e-6}}}},
                  .limits = {},
                  .ranging = {},
                  .obstacles = {}};
  for (const std::string& id : ids)
    m.evaluation.lines.push_back(evaluated_line(id, {150, 120, 60}, m.evaluation.lines.size()));
  for (const auto& line : m.evaluation.lines) {
    Plan plan;
    plan.axis = line.test.metadata.axis;
    plan.targets.assign(line.test.series.targets().begin(), line.test.series.targets().end());
    m.plan.lines.push_back({line.id, plan});
    m.assessments.push_back(iso230_2::assess(line.test));
    m.judgements.emplace_back();
  }
  tracking::ScalesAndSquareness squareness;
  const char* terms[] = {"e_x", "e_y", "e_z", "C0Y", "B0Z", "A0Z"};
  for (std::size_t k = 0; k < 6; ++k) squareness.terms[k] = {terms[k], 1.5 * static_cast<double>(k), 0.25};
  squareness.terms[5] = {"A0Z", std::nullopt, std::nullopt};
  squareness.residuals_um_per_m.assign(ids.size(), 0.05);
  squareness.degrees_of_freedom = 1;
  squareness.notes = {"the axes are taken for straight"};
  m.evaluation.squareness = squareness;
  std::vector<iso230_6::NamedEvaluation> diagonals;
  for (std::size_t k = 0; k < ids.size(); ++k) {
    m.lines.push_back({m.evaluation.lines[k], m.assessments[k], m.judgements[k]});
    if (ids[k].size() > 1) diagonals.push_back({ids[k], m.assessments[k].evaluation});
  }
  m.diagonals = iso230_6::summarise(diagonals);
  return m;
}

std::string words_of(const Document& document) {
  std::string all = document.title + document.edition;
  for (const Notice& notice : document.status) {
    all += plain_text(notice.heading);
    for (const RichText& line : notice.lines) all += plain_text(line);
  }
  return all;
}

TEST(LinesDocument, HasASectionForEveryLineAndForWhatTheyTellTogether) {
  const Measured m = measured();
  const Document document = compose(m.subject(), {});
  using ::testing::IsSupersetOf;
  EXPECT_THAT(section_ids(document),
              IsSupersetOf({"overview", "diagonals", "squareness", "length-difference", "line-x", "line-xyz",
                            "findings", "setup", "identification", "readings-yz", "provenance"}));
  const Table overview = tables(section(document, "overview")).front();
  ASSERT_EQ(overview.rows.size(), 7u);
  for (const auto& row : overview.rows) EXPECT_EQ(row.size(), overview.columns.size());
  EXPECT_EQ(plain_text(overview.rows[0][1].text), "ISO 230-2");
  EXPECT_EQ(plain_text(overview.rows[6][1].text), "ISO 230-6");
  EXPECT_EQ(plain_text(overview.rows[6][2].text), "+X +Y +Z");
}

TEST(LinesDocument, ClaimsBothStandardsOnlyWhereBothKindsWereMeasured) {
  EXPECT_THAT(words_of(compose(measured().subject(), {})), HasSubstr("ISO 230-2:2014 and ISO 230-6:2002"));
  const Measured axes = measured({"x", "y"});
  const Document document = compose(axes.subject(), {});
  EXPECT_THAT(words_of(document), Not(HasSubstr("230-6")));
  EXPECT_THAT(section_ids(document), Not(Contains("diagonals")));
  EXPECT_THAT(words_of(compose(measured({"xyz"}).subject(), {})),
              HasSubstr("ISO 230-6:2002, parameters as in ISO 230-2:2014"));
}

TEST(LinesDocument, TellsOnTheFirstPageWhatWasLostAndWhatIsInDoubt) {
  Measured m = measured();
  m.plan.lost = {{"xz", "the station is 12 mm outside the travel of Y"}};
  m.evaluation.findings = {{"lines-beam-broken", true, "the beam was broken 3 times"}};
  const std::string words = words_of(compose(m.subject(), {}));
  EXPECT_THAT(words, HasSubstr("12 mm outside the travel of Y"));
  EXPECT_THAT(words, HasSubstr("The beam was broken 3 times."));
}

TEST(LinesDocument, SaysWhatTheLinesCannotTell) {
  const Table table = tables(section(compose(measured().subject(), {}), "squareness")).front();
  EXPECT_EQ(plain_text(table.rows[5][2].text), "cannot be told");
  EXPECT_EQ(plain_text(table.rows[4][3].text), "0.50");
}

TEST(LinesDocument, TellsFromWhichDistanceTheStationMayBeNeglected) {
  const Table table = tables(section(compose(measured().subject(), {}), "length-difference")).front();
  EXPECT_EQ(plain_text(table.rows[0].back().text), "negligible");
  EXPECT_EQ(plain_text(table.rows[1].back().text), "in the budget");
  EXPECT_EQ(plain_text(table.rows[1][6].text), "250");
}

TEST(LinesDocument, TellsAFindingOfAllLinesOnce) {
  const Document document = compose(measured().subject(), {});
  std::size_t of_all = 0;
  for (const Table& table : tables(section(document, "findings")))
    for (const auto& row : table.rows) of_all += plain_text(row[2].text) == "x, y, z, xy, xz, yz, xyz" ? 1 : 0;
  EXPECT_GE(of_all, 2u);
}

TEST(LinesDocument, ShowsUncertaintiesVerdictsAndDeparturesOfEachLine) {
  const std::vector<iso230_2::Tolerance> limits = {testing_support::tolerance("E", 6.0)};
  Measured m = measured();
  for (std::size_t k = 0; k < m.lines.size(); ++k) {
    m.evaluation.lines[k].test.metadata.uncertainty.device_calibration =
        Deviation::native(0.4 + 0.1 * static_cast<double>(k));
    if (k == 2) m.evaluation.lines[k].test.metadata.conditions.cycle = TestCycle::step;
    if (k == 3) m.evaluation.lines[k].breaks = {{"xy", 17, -0.4321}};
    m.assessments[k] = iso230_2::assess(m.evaluation.lines[k].test);
    m.judgements[k] = iso230_2::judge(m.assessments[k].evaluation.parameters, limits, {},
                                      {iso230_2::uncertainties_of_record(m.assessments[k]), {}, {}});
    m.lines[k].judgements = m.judgements[k];
  }
  m.plan.lost = {{"xz", "the station is 12 mm outside the travel of Y"}};
  Options options;
  options.numbers.decimal_mark = ',';
  const Document document = compose(m.subject(), options);
  const std::string words = words_of(document);
  EXPECT_THAT(words, HasSubstr("Not every line may be called tested in accordance with its standard"));
  EXPECT_THAT(words, HasSubstr("Line x conforms: E"));
  EXPECT_THAT(words, HasSubstr("Tolerances: 3 lines do not conform, 4 conform"));
  EXPECT_THAT(document.label, HasSubstr("not for acceptance"));
  const Table overview = tables(section(document, "overview")).front();
  EXPECT_EQ(plain_text(overview.columns[5].head), "U");
  EXPECT_THAT(plain_text(overview.rows[0][5].text), HasSubstr(","));
  const auto of_line = tables(section(document, "line-xy"));
  EXPECT_THAT(plain_text(of_line[of_line.size() - 2].caption), HasSubstr("Inputs as resolved"));
  EXPECT_THAT(plain_text(of_line.back().caption), HasSubstr("Expanded uncertainty of the mean deviations"));
}

std::string facts_of(const Section& section) {
  std::string all;
  for (const Block& block : section.blocks)
    if (const auto* facts = std::get_if<Facts>(&block)) {
      EXPECT_FALSE(facts->facts.empty()) << facts->title;
      for (const Fact& fact : facts->facts) all += plain_text(fact.name) + ": " + plain_text(fact.value.text) + "\n";
    }
  return all;
}

TEST(LinesDocument, StatesOnceWhatHoldsForAllLinesAndWithALineWhatIsItsOwn) {
  Measured m = measured({"x", "y"});
  for (tracking::EvaluatedLine& line : m.evaluation.lines)
    line.test.metadata.tracking.station_position = Position::native(150.0);
  m.evaluation.lines[0].test.metadata.conditions.axes_not_under_test = "Y = 120 mm; Z = 60 mm";
  m.evaluation.lines[1].test.metadata.conditions.axes_not_under_test = "X = 150 mm; Z = 60 mm";
  const Document document = compose(m.subject(), {});
  const std::string common = facts_of(section(document, "identification"));
  EXPECT_THAT(common, HasSubstr("Mill 7"));
  EXPECT_THAT(common, Not(HasSubstr("120 mm; Z")));
  EXPECT_THAT(facts_of(section(document, "line-x")), HasSubstr("Y = 120 mm; Z = 60 mm"));
  EXPECT_THAT(facts_of(section(document, "line-y")), HasSubstr("X = 150 mm; Z = 60 mm"));
}

TEST(LinesDocument, NamesNoFolder) {
  const Document document = compose(measured().subject(), {});
  const auto* facts = std::get_if<Facts>(&section(document, "provenance").blocks.front());
  ASSERT_NE(facts, nullptr);
  EXPECT_EQ(plain_text(facts->facts.front().value.text), "lengths.csv");
}

TEST(LinesDocument, CanBeWrittenWithoutALine) {
  Measured m = measured({});
  m.evaluation.squareness.reset();
  EXPECT_NO_THROW(compose(m.subject(), {}));
}

TEST(LinesDocument, CanBeSetAsEveryKindOfDocument) {
  const Measured m = measured();
  const Document document = compose(m.subject(), {});
  for (const char* extension : {"html", "pdf", "svg"}) {
    const Writer* writer = find_writer(extension);
    ASSERT_NE(writer, nullptr);
    EXPECT_TRUE(writer->set(document, {})) << extension;
  }
}

TEST(LinesOverview, IsTheGoldenOne) {
  const Measured m = measured();
  const Figure figure = lines_overview_figure(m.subject(), {});
  EXPECT_EQ(fault_of(figure), "");
  testing::expect_golden(figure, "lines_overview");
}

TEST(LinesOverview, KeepsItsBoxForAnything) {
  Measured m = measured();
  for (auto& line : m.evaluation.lines) line.id += std::string(300, 'W');
  m.evaluation.lines[0].distances_mm.clear();
  m.evaluation.lines[1].slope_um_per_m = std::nan("");
  m.evaluation.lines[2].distances_mm[1] = std::nan("");
  m.evaluation.lines[3].slope_um_per_m = 1e12;
  EXPECT_EQ(fault_of(lines_overview_figure(m.subject(), {})), "");
  EXPECT_EQ(fault_of(lines_overview_figure(measured({}).subject(), {})), "");
}

TEST(LayoutOfAPlan, ShiftsTheTravelsByTheToolAndPointsLostLinesIntoThem) {
  Measured m = measured();
  m.plan.lost = {{"xz", "no room"}, {"PPP-NNN", "no room"}};
  const Layout layout = layout_of(m.plan, true);
  EXPECT_EQ(layout.box->lowest_mm, (Vector3{0, 0, -120}));
  ASSERT_EQ(layout.lines.size(), 8u);
  const Layout::Item& lost = layout.lines.back();
  EXPECT_TRUE(lost.lost);
  EXPECT_EQ(lost.begin_mm, (Vector3{150, 120, -60}));
  EXPECT_NEAR(distance(lost.begin_mm, lost.end_mm), 640.0 * std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(distance(layout.lines[6].begin_mm, {150, 120, -60}), layout_of(m.plan).lines.size() > 6 ? 210.0 : 0,
              20.0);
  EXPECT_EQ(fault_of(layout_figure(layout, {})), "");
}

TEST(DiagonalReport, NeverClaimsToBeOfIso2302Alone) {
  const Measured m = measured({"xy"});
  const Subject subject{m.evaluation.lines[0].test, m.assessments[0], {}};
  const Document document = compose(subject, {});
  EXPECT_EQ(document.title, "Diagonal displacement test of a machine tool");
  EXPECT_THAT(document.edition, HasSubstr("ISO 230-6:2002, parameters as in ISO 230-2:2014"));
  EXPECT_THAT(words_of(document), Not(HasSubstr("an ISO 230-2 result")));
  EXPECT_EQ(section(document, "parameters").title, "Parameters of the diagonal");
  EXPECT_THAT(find_writer("csv")->write(subject, {}).value(), HasSubstr("ISO 230-6:2002"));
  const std::string svg = find_writer("svg")->write(subject, {}).value();
  EXPECT_THAT(svg, HasSubstr("Diagonal xy"));
  EXPECT_THAT(svg, HasSubstr("Position along the diagonal xy"));
  EXPECT_THAT(svg, Not(HasSubstr("an ISO 230-2 result")));
}

}  // namespace
}  // namespace axiometry::report
