// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/cases/check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "axiometry/base/read_budget.h"
#include "tests/support/series.h"

namespace axiometry::app {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Result<Test> no_files(std::string_view file) { return fail("there is no " + std::string(file)); }

CheckReport checked(std::string_view text, const LoadTest& load = no_files) {
  auto report = check_case(text, load);
  EXPECT_TRUE(report) << report.error().to_string();
  return report ? *report : CheckReport{};
}

std::string error_of(std::string_view text) {
  const auto report = check_case(text, no_files);
  return report ? "no error" : report.error().to_string();
}

constexpr std::string_view small =
    "title a small case\n"
    "operation iso230-2\n"
    "targets 0 100 200 mm\n"
    "up      0   1   2 um  # a comment\n"
    "down   -1   0   - um\n";

std::string small_with(std::string_view lines) { return std::string(small) + std::string(lines); }

TEST(CheckCase, CountsExpectationsThatAreMet) {
  const CheckReport report = checked(small_with("expect E = 3 um\nexpect B=1 um\nexpect R not applicable\n"));
  EXPECT_EQ(report.title, "a small case");
  EXPECT_EQ(report.comparisons.size(), 3u);
  EXPECT_TRUE(report.passed());
}

TEST(CheckCase, SaysWhatWasExpectedAndWhatCame) {
  const CheckReport report =
      checked(small_with("tolerance 0.1 um\nexpect E = 3.5 um\nexpect R = 1 um\n"
                         "expect B not applicable\nexpect E > 0.01 mm\n"
                         "expect conforming yes\nexpect finding 9.9\nexpect no finding 8.1\n"));
  std::vector<std::string> lines;
  for (const CaseComparison& f : report.failures()) lines.push_back(to_string(f));
  EXPECT_THAT(lines, ElementsAre("line 7: E = 3.5 um: got 3 um, expected 3.5 um within 0.1 um, difference -0.5 um",
                                 "line 8: R = 1 um: got not applicable, expected 1 um within 0.1 um",
                                 "line 9: B not applicable: got 1 um, expected not applicable",
                                 "line 10: E > 0.01 mm: got 3 um, expected > 0.01 mm, difference -7 um",
                                 HasSubstr("line 11: conforming yes: got no: found"),
                                 HasSubstr("line 12: finding 9.9: got only"),
                                 HasSubstr("line 13: no finding 8.1: got 8.1: not given")));
}

TEST(CheckCase, RefusesWhatIsMetWhateverComes) {
  EXPECT_THAT(error_of(small_with("expect no finding 5.9.9\n")),
              HasSubstr("line 6:19: found \"5.9.9\", expected a clause"));
  EXPECT_THAT(error_of(small_with("expect no finding \"\"\n")), HasSubstr("expected a \"text\" that is not empty"));
  EXPECT_THAT(error_of(small_with("expect finding 8.1 \"\"\n")), HasSubstr("expected a \"text\" that is not empty"));
  EXPECT_THAT(error_of(small_with("expect no finding \"outlyer\"\n")),
              HasSubstr("found \"outlyer\", expected words that messages have, not \"outlyer\""));
  EXPECT_EQ(error_of(small_with("expect no finding \"an Outlier\"\nexpect no finding \"repeatab\"\n")), "no error");
  EXPECT_THAT(error_of(small_with("expect error \"\"\n")), HasSubstr("expected a \"text\" of the message"));
  EXPECT_EQ(error_of(small_with("expect no finding 3.17\nexpect no finding Annex D\nexpect no finding source\n")),
            "no error");
}

TEST(CheckCase, NamesTheWordItDoesNotUnderstand) {
  EXPECT_EQ(error_of("expect A = 1 um\n"),
            "line 1:1: found \"expect\", expected 'operation iso230-2' or 'operation model' first");
  EXPECT_EQ(error_of("operation iso230-4\n"), "line 1:11: found \"iso230-4\", expected iso230-2 or model");
  EXPECT_EQ(error_of("operation iso230-2\ntargts x\n"), "line 2:1: found \"targts\", expected perhaps 'targets'");
  EXPECT_EQ(error_of(small_with("expect E = 3 arcsec\n")),
            "line 6:14: found \"arcsec\", expected the unit um, mm or nm");
  EXPECT_EQ(error_of(small_with("expect E = 3\n")),
            "line 6:13: found the end of the line, expected the unit um, mm or nm");
  EXPECT_EQ(error_of(small_with("expect E = 3,5 um\n")), "line 6:12: found \"3,5\", expected a number");
  EXPECT_THAT(error_of(small_with("expect X = 3 um\n")), HasSubstr("line 6:8: found \"X\", expected a parameter"));
  EXPECT_THAT(error_of(small_with("expect position 4 R = 3 um\n")), HasSubstr("a target from 1 to 3"));
  EXPECT_THAT(error_of(small_with("expect finding 5.2 \"open\n")), HasSubstr("line 6:20: found a quotation mark"));
  EXPECT_THAT(error_of(small_with("set machin.name = x\n")), HasSubstr("line 6:5: found the unknown key"));
  EXPECT_EQ(error_of(small_with("")), "found no expectation, expected at least one line 'expect …'");
  EXPECT_EQ(error_of("operation iso230-2\ntargets 0 1 mm\nup 1 um\n"),
            "line 3:4: found 2 values after 'up', expected 2 readings (- where one is missing) and their unit");
  EXPECT_THAT(error_of(small_with("expect E = 3 um\nup 1 2 3 um\n")), HasSubstr("a new 'operation' before other data"));
  EXPECT_THAT(error_of("operation iso230-2\n\xff"), HasSubstr("line 2: found a byte that is not UTF-8"));
}

TEST(CheckCase, AsksItsCallerForFiles) {
  const LoadTest load = [](std::string_view file) -> Result<axiometry::Test> {
    EXPECT_EQ(file, "../data/table 2.csv");
    return testing_support::table2::complete_test();
  };
  const CheckReport report = checked(
      "operation iso230-2\nfile ../data/table 2.csv\nset uncertainty.environmental_variation = 0\n"
      "tolerance 1e-9 um\nexpect A = 9.586397554173445 um\nexpect U_R = 0 um\nexpect conforming yes\n",
      load);
  EXPECT_TRUE(report.passed());
}

TEST(CheckCase, TakesRefusedDataForAnUnmetExpectation) {
  const CheckReport report = checked("operation iso230-2\nfile gone.csv\nexpect A = 1 um\nexpect error \"no gone\"\n");
  ASSERT_EQ(report.failures().size(), 1u);
  EXPECT_EQ(to_string(report.failures()[0]),
            "line 3: A = 1 um: got the error: there is no gone.csv, expected a result");
}

TEST(CheckCase, StartsEveryOperationAfresh) {
  const std::string twice = small_with("expect E = 3 um\n") + small_with("tolerance 5 um\nexpect E = 7 um\n") +
                            small_with("expect E = 3.1 um\n");
  EXPECT_EQ(checked(twice).failures().size(), 1u);
}

class ConformanceCases : public testing::TestWithParam<std::filesystem::path> {};

std::vector<std::filesystem::path> every_case() {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(AXIOMETRY_SOURCE_DIR "/tests/conformance"))
    if (entry.path().extension() == ".case") paths.push_back(entry.path());
  std::ranges::sort(paths);
  return paths;
}

TEST(CheckCase, TakesNoMoreRunsThanAnyOtherReader) {
  std::string text = "operation iso230-2\ntargets 0 1 mm\n";
  for (std::size_t run = 0; run <= read_budget::runs; ++run) text += "up 0 1 um\n";
  const auto report = check_case(text, no_files);
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().message, "found more than 10000 runs, expected fewer");
  EXPECT_EQ(report.error().at.line, 3 + read_budget::runs);
}

TEST_P(ConformanceCases, Hold) {
  std::ostringstream text;
  text << std::ifstream(GetParam()).rdbuf();
  const auto report = check_case(text.str(), no_files);
  ASSERT_TRUE(report) << report.error().to_string();
  EXPECT_FALSE(report->title.empty());
  for (const CaseComparison& failure : report->failures()) ADD_FAILURE() << to_string(failure);
}

INSTANTIATE_TEST_SUITE_P(All, ConformanceCases, testing::ValuesIn(every_case()),
                         [](const auto& of) { return of.param.stem().string(); });

}  // namespace
}  // namespace axiometry::app
