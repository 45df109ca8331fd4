// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "axiometry/report/documents/compose.h"
#include "axiometry/report/sections/sections.h"
#include "tests/support/document_parts.h"
#include "tests/support/made_up_monte_carlo.h"
#include "tests/support/report_subject.h"

namespace axiometry::report {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using ::testing::Not;
using testing_support::made_up_monte_carlo;
using testing_support::Reported;
using testing_support::reported_table2;
using testing_support::section;
using testing_support::section_ids;
using testing_support::tables;

enum Methods { gum = 1, monte_carlo = 2 };

Reported with(int methods, Reported reported = reported_table2()) {
  auto& assessment = reported.assessment;
  if (methods & gum) assessment.gum = iso230_2::gum(reported.test, assessment.evaluation).value();
  if (methods & monte_carlo) assessment.monte_carlo = made_up_monte_carlo(assessment.evaluation);
  return reported;
}

Document composed(const Reported& reported) { return compose(reported.subject(), reported.options); }

std::vector<std::string> heads(const Table& table) {
  std::vector<std::string> all;
  for (const Column& column : table.columns) all.push_back(plain_text(column.head));
  return all;
}

std::vector<std::string> groups(const Table& table) {
  std::vector<std::string> all;
  for (const ColumnGroup& group : table.groups) all.push_back(plain_text(group.head));
  return all;
}

/// Everything that is written in a section outside of figures.
std::string words(const Section& section) {
  std::string all;
  for (const Block& block : section.blocks) {
    if (const auto* paragraph = std::get_if<Paragraph>(&block)) all += plain_text(paragraph->text) + "\n";
    if (const auto* facts = std::get_if<Facts>(&block))
      for (const Fact& fact : facts->facts) all += plain_text(fact.name) + ": " + plain_text(fact.value.text) + "\n";
    if (const auto* table = std::get_if<Table>(&block)) {
      for (const auto& row : table->rows)
        for (const TableCell& cell : row) all += plain_text(cell.text) + "|";
      for (const RichText& note : table->notes) all += plain_text(note) + "\n";
    }
  }
  return all;
}

TEST(UncertaintySections, AreLeftOutWhereOnlyAnnexAWasRun) {
  const auto ids = section_ids(composed(reported_table2()));
  EXPECT_THAT(ids, AllOf(Not(Contains("methods")), Not(Contains("contributions")), Not(Contains("gum"))));
}

TEST(UncertaintySections, FollowTheParametersAndKeepTheBudgetOfAnnexA) {
  EXPECT_THAT(section_ids(composed(with(gum | monte_carlo))),
              ElementsAre("parameters", "methods", "contributions", "figures", "claims", "findings", "identification",
                          "positions", "uncertainty", "gum", "information", "provenance", "release"));
}

TEST(UncertaintySections, NameTheQuestionThatIsAnswered) {
  Reported table2 = with(gum | monte_carlo);
  EXPECT_THAT(words(section(composed(table2), "methods")), HasSubstr("that of this test"));
  table2.assessment.monte_carlo->measurand = iso230_2::Measurand::this_machine;
  EXPECT_THAT(words(section(composed(table2), "methods")),
              AllOf(HasSubstr("that of this machine"), HasSubstr("5 approaches"), HasSubstr("Sampling: pooled")));
  EXPECT_THAT(words(section(composed(reported_table2()), "uncertainty")), HasSubstr("that of this test"));
}

TEST(UncertaintySections, StateSeedTrialsAndCoverage) {
  EXPECT_THAT(words(section(composed(with(monte_carlo)), "methods")),
              AllOf(HasSubstr("1\u2009000\u2009000 trials"), HasSubstr("Seed: 7;"), HasSubstr("95\u00a0%")));
}

TEST(UncertaintySections, HaveAColumnForEachMethodThatWasRun) {
  EXPECT_THAT(groups(tables(section(composed(with(gum | monte_carlo)), "methods")).at(0)),
              ElementsAre("Parameter", "Annex A", "GUM", "Monte Carlo", "Against Monte Carlo"));
  EXPECT_THAT(groups(tables(section(composed(with(gum)), "methods")).at(0)),
              ElementsAre("Parameter", "Annex A", "GUM", "Against GUM"));
  Reported bare = testing_support::reported_without_metadata();
  bare.assessment.monte_carlo = made_up_monte_carlo(bare.assessment.evaluation);
  EXPECT_THAT(groups(tables(section(composed(bare), "methods")).at(0)), ElementsAre("Parameter", "Monte Carlo"));
}

TEST(UncertaintySections, HaveARowForEachParameterThatExists) {
  Reported table2 = reported_table2();
  auto& measured = table2.assessment.evaluation.parameters;
  for (auto member : {&iso230_2::AxisParameters::A, &iso230_2::AxisParameters::A_up, &iso230_2::AxisParameters::A_down,
                      &iso230_2::AxisParameters::R, &iso230_2::AxisParameters::R_up, &iso230_2::AxisParameters::R_down})
    (measured.*member).reset();
  table2.assessment.monte_carlo = made_up_monte_carlo(table2.assessment.evaluation);
  for (const Table& table : tables(section(composed(table2), "methods"))) EXPECT_EQ(table.rows.size(), 6u);
}

TEST(UncertaintySections, HaveAsManyCellsAsColumns) {
  for (int methods : {1, 2, 3})
    for (const Section& section : composed(with(methods)).sections)
      for (const Table& table : tables(section)) {
        std::size_t grouped = 0;
        for (const ColumnGroup& group : table.groups) grouped += group.columns;
        EXPECT_TRUE(table.groups.empty() || grouped == table.columns.size()) << section.id;
        for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size()) << section.id;
      }
}

TEST(UncertaintySections, SayWhatToImproveFirst) {
  EXPECT_THAT(words(section(composed(with(monte_carlo)), "contributions")),
              HasSubstr("Uncertainty of A: Temperature of the machine, less 20 °C, 64\u00a0% of the variance"));
}

std::string row_of_the_total(const Reported& reported) {
  const std::string all = words(section(composed(reported), "contributions"));
  const std::size_t start = all.find("All together|");
  return start == std::string::npos ? "" : all.substr(start, all.find('\n', start) - start);
}

TEST(UncertaintySections, StateNoSumWhereNothingActs) {
  Reported reported = with(monte_carlo);
  EXPECT_THAT(row_of_the_total(reported), AllOf(HasSubstr("All together|"), Not(HasSubstr("|–|"))));
  for (std::size_t p = 0; p < std::size(iso230_2::parameters); ++p)
    if (iso230_2::parameters[p].key == "R_up") reported.assessment.monte_carlo->distributions[p].reset();
  EXPECT_THAT(row_of_the_total(reported), HasSubstr("|–|")) << "not 0, which would be read as exact";
}

TEST(UncertaintySections, ListTheInputsWithTheirDistributions) {
  EXPECT_THAT(words(section(composed(with(monte_carlo)), "contributions")),
              AllOf(HasSubstr("uniform from 0.9 to 1.1|0.0577|°C|the whole test"), HasSubstr("(assumed)"),
                    HasSubstr("Made up.")));
  EXPECT_THAT(words(section(composed(with(gum)), "contributions")), HasSubstr("uniform from "));
}

TEST(UncertaintySections, GiveTheTablesOfTheGumAtEveryTarget) {
  const auto all = tables(section(composed(with(gum)), "gum"));
  EXPECT_EQ(all.front().rows.size(), 12u);
  EXPECT_EQ(all.back().rows.size(), 11u);
  EXPECT_THAT(groups(all.back()), ElementsAre("Target", "x̄i↑", "x̄i↓", "x̄i"));
}

TEST(UncertaintySections, ComposeTheMeansOfEveryTargetOfTheContributorsOfAnnexA) {
  Reported reported = reported_table2();
  const Section annex_a = section(composed(reported), "uncertainty");
  std::vector<std::string> heads;
  for (const Table& table : tables(annex_a))
    for (const Column& column : table.columns) heads.push_back(plain_text(column.head));
  EXPECT_THAT(heads, IsSupersetOf({"U (A.15)", "U (A.16)"})) << "each with its equation";
  const std::string all = words(annex_a);
  EXPECT_THAT(all, HasSubstr("the annex itself states no uncertainty of mean deviations"));
  EXPECT_THAT(all, Not(HasSubstr("U covers only the contributors")));
  reported.assessment.annex_a->missing = {"eve"};
  EXPECT_THAT(words(section(composed(reported), "uncertainty")), HasSubstr("U covers only the contributors"));
}

TEST(ParameterTable, NamesTheMethodOfItsUncertaintyWhereThereAreSeveral) {
  Reported other = with(gum | monte_carlo);
  other.assessment.method_of_record = iso230_2::UncertaintyMethod::annex_a;
  EXPECT_THAT(heads(tables(section(composed(other), "parameters")).at(0)), Contains("U (Annex A, k = 2)"));
  other.assessment.method_of_record = iso230_2::UncertaintyMethod::gum;
  EXPECT_THAT(heads(tables(section(composed(other), "parameters")).at(0)), Contains("U (GUM)"));
  other.assessment.method_of_record.reset();
  const Table table = tables(section(composed(other), "parameters")).at(0);
  EXPECT_THAT(heads(table), Contains("95\u00a0% (Monte Carlo)"));
  EXPECT_THAT(words(section(composed(other), "parameters")), HasSubstr("9.59|7.65 to 10.64|"));
}

TEST(ReportWriters, HandleEveryMethodInEveryFormat) {
  Reported table2 = with(gum | monte_carlo);
  table2.judge({testing_support::tolerance("A", 10)});
  for (const Writer* writer : writer_table()) EXPECT_GT(table2.written(writer->extension).size(), 1000u);
  EXPECT_THAT(table2.written("csv"), AllOf(HasSubstr("X,monte_carlo,,,A.mean,9.1"), HasSubstr("X,gum,,,A,9.58")));
  EXPECT_THAT(table2.written("svg"), AllOf(HasSubstr("Histograms"), HasSubstr("Largest contribution to A")));
}

TEST(ReportWriters, EscapeWhatInputsAreCalled) {
  Reported table2 = with(monte_carlo);
  table2.assessment.monte_carlo->inputs[0].title = table2.assessment.monte_carlo->contributions[0].title =
      "<script>alert(1)</script>";
  EXPECT_THAT(table2.written("html"), Not(HasSubstr("<script>")));
  EXPECT_THAT(table2.written("svg"), Not(HasSubstr("<script>")));
}

}  // namespace
}  // namespace axiometry::report
