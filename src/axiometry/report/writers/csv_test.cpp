// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "axiometry/base/text/number_text.h"
#include "tests/support/report_subject.h"

namespace axiometry::report {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;
using testing_support::Reported;
using testing_support::reported_table2;
using testing_support::reported_without_metadata;

TEST(CsvWriter, HasOneLinePerParameterAndPerQuantityOfATarget) {
  const std::string csv = reported_table2().written("csv");
  EXPECT_EQ(std::ranges::count(csv, '\n'), 1 + 12 + 11 * (11 + 3) + 3);
  EXPECT_EQ(std::ranges::count(csv, '\r'), std::ranges::count(csv, '\n'));
  EXPECT_THAT(
      csv,
      StartsWith(
          "axis,record,target,target_unit,name,value,U,unit,clause,remark,limit,verdict,low,high,method,symbol\r\n"));
}

TEST(CsvWriter, GivesFullPrecision) {
  const std::string csv = reported_without_metadata().written("csv");
  EXPECT_THAT(csv, HasSubstr(",parameter,,,E,7.699999999999999,,um,3.24,"));
  EXPECT_THAT(csv, HasSubstr(",position,6.711,mm,s_up,0.33166247903553997,,um,3.18,"));
  EXPECT_THAT(csv, HasSubstr(",position,6.711,mm,n_up,5,,,3.5,"));
}

TEST(CsvWriter, SeparatesBySemicolonWhereTheMarkIsAComma) {
  Reported bare = reported_without_metadata();
  bare.options = {.numbers = {','}, .unit = DisplayUnit::mm, .deviation_decimals = {}};
  const std::string csv = bare.written("csv");
  EXPECT_THAT(csv, StartsWith("axis;record;"));
  EXPECT_THAT(csv, HasSubstr(";position;6,711;mm;mean_up;-1,6;;um;3.13;"));
  EXPECT_THAT(csv, HasSubstr(";parameter;;;E;0,0076"));
}

TEST(CsvWriter, LeavesTheCellOfAMissingParameterEmpty) {
  const auto single =
      testing_support::reported({{}, testing_support::make_series({0, 100, 200}, {{1, 2, 3}}, {{2, 3, 4}}), {}});
  EXPECT_THAT(single.written("csv"), HasSubstr(",parameter,,,R,,,um,3.22,"));
}

TEST(CsvWriter, SaysInEveryLineWhatTheResultIsNot) {
  Reported table2 = reported_table2();
  table2.assessment.label = "step cycle (Annex B), not for acceptance";
  table2.assessment.findings.push_back({"step-cycle", "5.3.2", iso230_2::Severity::departure, "found the step cycle"});
  EXPECT_THAT(
      table2.written("csv"),
      HasSubstr(",um,3.27,\"Computed after clause 3 of ISO 230-2:2014; not a test in accordance with it; step cycle "
                "(Annex B), not for acceptance\",,,5.31"));
  EXPECT_THAT(table2.written("csv"), HasSubstr(",claim,,,tested,no,"));
  EXPECT_THAT(reported_table2().written("csv"), HasSubstr(",claim,,,tested,yes,"));
}

TEST(CsvWriter, SaysOfAnIssuedReportWhereTheTrailEndedBefore) {
  const Reported table2 = reported_table2();
  const Subject issued{table2.test, table2.assessment, table2.judgements, {}, "17:3f2a9c0b1d2e4f56"};
  const std::string csv = find_writer("csv")->write(issued, {}).value();
  EXPECT_TRUE(csv.starts_with(table2.written("csv"))) << "all else stays as it was";
  EXPECT_TRUE(csv.ends_with("X,trail,,,head,17:3f2a9c0b1d2e4f56,,,,,,,,,,\r\n")) << csv.substr(csv.size() - 80);
}

TEST(CsvWriter, StatesLimitAndVerdictInTheUnitOfTheParameter) {
  Reported table2 = reported_table2();
  table2.options.unit = DisplayUnit::mm;
  table2.judge({testing_support::tolerance("A", 10), testing_support::tolerance("B", 4)});
  const std::string csv = table2.written("csv");
  EXPECT_THAT(csv,
              HasSubstr(",mm,3.27,,0.01,conforms,0.005315831278904754,0.013856963829442135,annex_a,\"E_XX,A\"\r\n"));
  EXPECT_THAT(csv, HasSubstr(",mm,3.16,,0.004,does not conform,"));
  EXPECT_THAT(csv, HasSubstr(",mm,3.24,,,,"));
}

TEST(CsvWriter, StatesTheUncertaintyOfEveryMeanWhereTheGumWasRun) {
  Reported table2 = reported_table2();
  table2.assessment.gum = iso230_2::gum(table2.test, table2.assessment.evaluation).value();
  const std::string csv = table2.written("csv");
  const auto lines = [&](const std::string& name) {
    std::size_t count = 0;
    for (std::size_t at = csv.find("X,gum,"); at != csv.npos; at = csv.find("X,gum,", at + 1))
      if (csv.substr(at, csv.find('\r', at) - at).find(",mm," + name + ",") != std::string::npos) ++count;
    return count;
  };
  EXPECT_EQ(lines("mean_up"), 11u);
  EXPECT_EQ(lines("mean_down"), 11u);
  EXPECT_EQ(lines("mean"), 11u);
  const auto& at = table2.assessment.gum->positions[3];
  EXPECT_THAT(csv, HasSubstr("X,gum,525.668,mm,mean," +
                             format_exact(table2.assessment.evaluation.positions[3].mean->in_native()) + "," +
                             format_exact(at.mean->U.in_native()) + ",um,3.14,"));
}

TEST(CsvWriter, StatesTheUncertaintyOfEveryMeanByAnnexAAndWhatItLacks) {
  Reported table2 = reported_table2();
  const std::string csv = table2.written("csv");
  const auto& at = table2.assessment.annex_a->positions[3];
  EXPECT_THAT(csv, HasSubstr("X,annex_a,525.668,mm,mean," +
                             format_exact(table2.assessment.evaluation.positions[3].mean->in_native()) + "," +
                             format_exact(at.mean->U.in_native()) + ",um,3.14,"));
  EXPECT_THAT(csv, ::testing::Not(HasSubstr("X,annex_a,,,missing,")));
  table2.assessment.annex_a->missing = {"eve"};
  EXPECT_THAT(table2.written("csv"), HasSubstr("X,annex_a,,,missing,eve,"));
}

TEST(CsvWriter, NamesTheAxisTogetherWithTheParameter) {  // 8.2.4
  Reported table2 = reported_table2();
  EXPECT_THAT(table2.written("csv"), HasSubstr(",annex_a,\"E_XX,A↑\"\r\n"));
  table2.test.metadata.axis.name = "C";
  EXPECT_THAT(table2.written("csv"), HasSubstr(",annex_a,\"E_CC,B\"\r\n"));
  table2.test.metadata.axis.name = "slide";
  EXPECT_THAT(table2.written("csv"), ::testing::Not(HasSubstr(",\"E_")));
}

TEST(CsvWriter, QuotesAndDefusesWhatASpreadsheetWouldMistake) {
  Reported table2 = reported_table2();
  table2.test.metadata.axis.name = "a \"b\", c";
  EXPECT_THAT(table2.written("csv"), HasSubstr("\r\n\"a \"\"b\"\", c\",parameter"));
  table2.test.metadata.axis.name = "=1+1";
  EXPECT_THAT(table2.written("csv"), HasSubstr("\r\n'=1+1,parameter"));
}

}  // namespace
}  // namespace axiometry::report
