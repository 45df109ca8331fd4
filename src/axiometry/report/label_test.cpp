// SPDX-License-Identifier: Apache-2.0
// The label of a cycle that does not serve acceptance stands wherever results do. JSON and the combined table are
// checked in app/results/label_json_test.cpp, the terminal in tests/transcripts/label.txt.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <optional>

#include "axiometry/model/plan.h"
#include "axiometry/report/drawing/picture.h"
#include "axiometry/report/drawing/text_layout.h"
#include "axiometry/report/periodic.h"
#include "tests/support/document_parts.h"
#include "tests/support/made_up_monte_carlo.h"
#include "tests/support/report_subject.h"
#include "tests/support/temporary_folder.h"

namespace axiometry::report {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using testing_support::Reported;
using testing_support::reported;

constexpr TestCycle other_cycles[] = {TestCycle::step, TestCycle::pilgrim, TestCycle::user_defined};

/// A test with everything a report can show: tolerances, distributions, contributions.
Reported with_cycle(TestCycle cycle) {
  auto test = testing_support::table2::complete_test();
  test.metadata.conditions.cycle = cycle;
  Reported result = reported(std::move(test));
  result.assessment.monte_carlo = testing_support::made_up_monte_carlo(result.assessment.evaluation);
  result.judge({testing_support::tolerance("A", 12.0)});
  return result;
}

std::size_t count(std::string_view text, std::string_view part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + part.size())) ++found;
  return found;
}

/// Pages of a PDF by pdftotext; nothing where there is no such program.
std::optional<std::vector<std::string>> pages_of(const std::string& pdf) {
  if (std::system("command -v pdftotext > /dev/null 2>&1") != 0) return std::nullopt;
  const testing_support::TemporaryFolder folder;
  const std::string base = folder.file("report");
  folder.written("report.pdf", pdf);
  const int status = std::system(("pdftotext -layout " + base + ".pdf " + base + ".txt").c_str());
  const std::string text = folder.content("report.txt");
  if (status != 0) return std::nullopt;
  std::vector<std::string> pages;
  for (std::size_t start = 0, end = 0; (end = text.find('\f', start)) != text.npos; start = end + 1)
    pages.push_back(text.substr(start, end - start));
  return pages;
}

TEST(Label, StandsInTheStatusAndBesideEverySectionOfResultsInHtml) {
  for (TestCycle cycle : other_cycles) {
    const std::string label(cycle_label(cycle));
    const std::string html = with_cycle(cycle).written("html");
    EXPECT_THAT(html, HasSubstr("Label: " + label));
    std::size_t sections = 0;
    for (std::size_t at = html.find("<h2"); at != html.npos; at = html.find("<h2", at + 1)) ++sections;
    EXPECT_GE(count(html, "<span class=\"label\">" + label), 6u);
    EXPECT_LT(count(html, "<span class=\"label\">" + label), sections);  // findings are no results
  }
}

TEST(Label, IsTheFirstThatADocumentSays) {
  Document document;
  document.status = {{Tone::bad, plain("Something else"), {}}};
  put_label(document, "trial");
  ASSERT_EQ(document.status.size(), 2u);
  EXPECT_EQ(plain_text(document.status.front().heading), "Label: trial");
  put_label(document, "");
  EXPECT_EQ(document.status.size(), 2u);
}

TEST(Label, StandsOnEveryPageInPdf) {
  for (TestCycle cycle : other_cycles) {
    const auto pages = pages_of(with_cycle(cycle).written("pdf"));
    if (!pages) GTEST_SKIP() << "pdftotext is not installed";
    ASSERT_GE(pages->size(), 3u);
    for (const std::string& page : *pages) EXPECT_THAT(page, HasSubstr(std::string(cycle_label(cycle))));
  }
}

TEST(Label, StandsAboveEveryFigureOfAPicture) {
  for (TestCycle cycle : other_cycles) {
    const std::string label(cycle_label(cycle));
    // Figures 2, 3a and 3b, the tolerances, the means with their U, the distributions, the contributions.
    EXPECT_EQ(count(with_cycle(cycle).written("svg"), label), 7u) << label;
  }
}

TEST(Label, IsPaintedInPng) {
  // The same figures are painted; that the label is among them shows in the pixels.
  const std::string step = with_cycle(TestCycle::step).written("png");
  const std::string pilgrim = with_cycle(TestCycle::pilgrim).written("png");
  EXPECT_NE(step, pilgrim);
  EXPECT_EQ(step, with_cycle(TestCycle::step).written("png"));
}

TEST(Label, StandsInEveryRowOfTheCsv) {
  for (TestCycle cycle : other_cycles) {
    const std::string csv = with_cycle(cycle).written("csv");
    const auto rows = count(csv, "\r\n") - 1;
    EXPECT_EQ(count(csv, std::string(cycle_label(cycle))), rows);
  }
}

TEST(Label, IsAbsentFromTheStandardCycle) {
  for (const char* extension : {"html", "svg", "csv"})
    EXPECT_THAT(with_cycle(TestCycle::standard).written(extension), Not(HasSubstr("not for acceptance"))) << extension;
}

axiometry::Test dense(TestCycle cycle) {
  std::vector<double> targets;
  testing_support::RunDeviations run;
  for (int k = 0; k < 40; ++k) {
    targets.push_back(k + 0.3 * std::sin(k));
    run.push_back(std::sin(0.6 * targets.back()) + 0.1 * std::cos(11.0 * k));
  }
  axiometry::Test test{{}, testing_support::make_series(targets, {run}, {}), {}};
  test.metadata.conditions.cycle = cycle;
  return test;
}

TEST(Label, StandsWithAPeriodicErrorToo) {
  const axiometry::Test test = dense(TestCycle::step);
  const auto result = iso230_2::periodic_error(test).value();
  const Document document = compose({test, result}, {});
  const auto set = [&](std::string_view extension) { return find_writer(extension)->set(document, {}).value(); };
  const std::string label(cycle_label(TestCycle::step));
  EXPECT_EQ(count(set("svg"), label), 4u);
  EXPECT_THAT(set("html"), HasSubstr("Label: " + label));
  const std::string csv = set("csv");
  EXPECT_THAT(csv, HasSubstr("Unit,remark\r\n"));
  EXPECT_THAT(csv, HasSubstr(",\"" + label + "\"\r\n"));
  if (const auto pages = pages_of(set("pdf"))) {
    for (const std::string& page : *pages) EXPECT_THAT(page, HasSubstr(label));
  }
}

TEST(Label, IsNotThatOfAcceptanceWhereOneDirectionIsWhatTheTestWants) {
  const axiometry::Test test = dense(TestCycle::unidirectional);
  const Document document = compose({test, iso230_2::periodic_error(test).value()}, {});
  EXPECT_EQ(document.label, "");
  EXPECT_THAT(find_writer("csv")->set(document, {}).value(), Not(HasSubstr("remark")));
}

}  // namespace
}  // namespace axiometry::report
