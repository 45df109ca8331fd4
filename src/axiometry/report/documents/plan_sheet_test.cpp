// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/documents/plan_sheet.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "axiometry/report/writer.h"
#include "axiometry/standards/iso230_2/plan/plan.h"
#include "tests/support/document_parts.h"

namespace axiometry::report {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using testing_support::section;
using testing_support::section_ids;
using testing_support::tables;

iso230_2::PlanRequest request(double from, double to, AxisKind kind = AxisKind::linear) {
  iso230_2::PlanRequest r;
  r.axis.name = "X<1>";
  r.axis.kind = kind;
  r.axis.travel_begin = Position::native(from);
  r.axis.travel_end = Position::native(to);
  r.machine = "Mill & Co";
  r.seed = 7;
  return r;
}

Document sheet(const Plan& plan, const Options& options = {}) {
  const auto findings = iso230_2::plan_findings(plan);
  const Duration duration = iso230_2::estimated_duration(plan);
  return plan_sheet({plan, findings, duration, duration}, options);
}

std::vector<Figure> figures_of(const Document& document) {
  std::vector<Figure> all;
  for (const Section& s : document.sections)
    for (const Block& block : s.blocks)
      if (const auto* figure = std::get_if<Figure>(&block)) all.push_back(*figure);
  return all;
}

std::size_t discs(const Figure& figure) {
  return static_cast<std::size_t>(
      std::ranges::count_if(figure.operations, [](const Operation& o) { return std::holds_alternative<Disc>(o); }));
}

std::vector<std::string> texts(const Figure& figure) {
  std::vector<std::string> all;
  for (const Operation& o : figure.operations)
    if (const auto* text = std::get_if<Text>(&o)) all.push_back(plain_text(text->runs));
  return all;
}

std::vector<std::string> fact_names(const Section& s) {
  std::vector<std::string> names;
  for (const Block& block : s.blocks)
    if (const auto* facts = std::get_if<Facts>(&block))
      for (const Fact& fact : facts->facts) names.push_back(plain_text(fact.name));
  return names;
}

TEST(PlanSheet, IsATestPlanWithProgrammeTargetsFindingsAndWhatToNote) {
  const Document document = sheet(iso230_2::make_plan(request(0, 500)).value());
  EXPECT_EQ(document.kind, "Test plan");
  EXPECT_THAT(section_ids(document), ElementsAre("programme", "targets", "findings", "conditions"));
  EXPECT_EQ(document.status.front().tone, Tone::good);
  EXPECT_EQ(document.label, "");
  EXPECT_EQ(tables(section(document, "targets")).at(0).rows.size(), 5u);
}

TEST(PlanSheet, HasAFigureAndTargetsForEveryFurtherTest) {
  const Document document = sheet(iso230_2::make_plan(request(0, 6000)).value());
  EXPECT_THAT(section_ids(document),
              ElementsAre("programme", "targets", "programme-1", "targets-1", "findings", "conditions"));
  EXPECT_EQ(figures_of(document).size(), 2u);
}

TEST(PlanSheet, ASheetOfAnotherCycleCarriesItsLabelAndIsNoPlanOfTheStandard) {
  iso230_2::PlanRequest r = request(0, 500);
  r.cycle = TestCycle::step;
  const Document document = sheet(iso230_2::make_plan(r).value());
  EXPECT_EQ(document.label, "step cycle (Annex B), not for acceptance");
  EXPECT_EQ(plain_text(document.status.at(0).heading), "Label: " + document.label) << "first of all";
  EXPECT_EQ(document.status.at(1).tone, Tone::bad);
  EXPECT_THAT(document.running_status, HasSubstr("not for acceptance"));
  EXPECT_THAT(texts(figures_of(document).at(0)), Contains("step cycle (Annex B), not for acceptance"));
}

TEST(PlanSheet, IsNoPlanOfTheStandardWhereItsTestWouldNotBeInAccordance) {
  Plan plan = iso230_2::make_plan(request(0, 500)).value();
  plan.warm_up_runs = 0;
  const Document document = sheet(plan);
  EXPECT_EQ(document.status.front().tone, Tone::caution);
  EXPECT_EQ(document.edition, "Terms of ISO 230-2:2014");
}

TEST(PlanSheet, AsksOnlyForWhatThePlanDoesNotKnow) {
  Plan plan = iso230_2::make_plan(request(0, 500)).value();
  const auto asked = fact_names(section(sheet(plan), "conditions"));
  EXPECT_THAT(asked, Contains("Name of inspector"));
  EXPECT_THAT(asked, Contains("Air temperature at the start / °C"));
  EXPECT_THAT(asked, Not(Contains(HasSubstr("Feed speed"))));
  EXPECT_THAT(asked, Not(Contains("Axis under test")));
  EXPECT_THAT(asked, Not(Contains("Warm-up operation")));
  plan.warm_up_runs = 0;
  EXPECT_THAT(fact_names(section(sheet(plan), "conditions")), Contains("Warm-up operation"));
}

TEST(PlanSheet, DrawsOneDotForEachReadingAndNamesTheRuns) {
  for (TestCycle cycle : {TestCycle::standard, TestCycle::step, TestCycle::pilgrim, TestCycle::unidirectional}) {
    iso230_2::PlanRequest r = request(0, 500);
    r.cycle = cycle;
    const Plan plan = iso230_2::make_plan(r).value();
    const Figure figure = figures_of(sheet(plan)).at(0);
    const std::size_t in_legend = cycle == TestCycle::unidirectional ? 1 : 2;
    EXPECT_EQ(discs(figure), approaches(plan).size() + in_legend) << cycle_name(cycle);
  }
  const Figure figure = figures_of(sheet(iso230_2::make_plan(request(0, 500)).value())).at(0);
  for (std::string_view name : {"Warm-up", "Run 1", "Run 5"}) EXPECT_THAT(texts(figure), Contains(name));
}

TEST(PlanSheet, StaysInsideThePaperAndBelowItsLabelAtEveryCount) {
  for (std::size_t count : {2u, 5u, 60u, 900u}) {
    iso230_2::PlanRequest r = request(-300, 1500);
    r.count = count;
    r.cycle = TestCycle::pilgrim;
    const Figure figure = figures_of(sheet(iso230_2::make_plan(r).value())).at(0);
    for (const Operation& operation : figure.operations) {
      if (const auto* path = std::get_if<Path>(&operation)) {
        for (const Point& p : path->points)
          EXPECT_TRUE(p.x >= 0.0 && p.x <= figure.width && p.y >= 0.0 && p.y <= figure.height);
      }
      const auto* text = std::get_if<Text>(&operation);
      if (text == nullptr || text->anchor != Anchor::start || text->degrees != 0.0) continue;
      EXPECT_LE(text->at.x + text_width(text->runs, text->size), figure.width);
    }
  }
}

TEST(PlanSheet, EveryWriterSetsIt) {
  const Document document = sheet(iso230_2::make_plan(request(0, 500)).value());
  for (const Writer* writer : writer_table()) {
    const auto bytes = writer->set(document, {});
    ASSERT_TRUE(bytes) << writer->extension;
    EXPECT_GT(bytes->size(), 100u) << writer->extension;
  }
  const auto html = find_writer("html")->set(document, {});
  EXPECT_THAT(*html, HasSubstr("axis X&lt;1&gt;"));
  EXPECT_THAT(*html, Not(HasSubstr("X<1>")));
}

TEST(PlanSheet, TellsDurationsAsPeopleDo) {
  EXPECT_EQ(duration_text(Duration::s(0)), "1 s");
  EXPECT_EQ(duration_text(Duration::s(48.4)), "48 s");
  EXPECT_EQ(duration_text(Duration::s(840)), "14 min");
  EXPECT_EQ(duration_text(Duration::s(6300)), "1 h 45 min");
}

TEST(PlanSheet, FigureOfVeryManyTargetsHasNoMoreLinesThanPaperHasRoomFor) {
  Plan plan = iso230_2::make_plan(request(0, 500)).value();
  plan.cycle = TestCycle::user_defined;
  plan.targets.clear();
  plan.runs = 1;
  for (std::size_t i = 0; i < 50'000; ++i) {
    plan.targets.push_back(Position::native(10.0 + 0.009 * static_cast<double>(i)));
    plan.sequence.push_back({i, Direction::up, 0});
  }
  const auto figures = figures_of(sheet(plan));
  ASSERT_EQ(figures.size(), 1u);
  EXPECT_LT(figures[0].operations.size(), 5'000u);
  EXPECT_GT(figures[0].operations.size(), 1'000u);
}

}  // namespace
}  // namespace axiometry::report
