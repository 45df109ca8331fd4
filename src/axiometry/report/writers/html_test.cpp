// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>

#include "tests/support/report_subject.h"

namespace axiometry::report {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using testing_support::Reported;
using testing_support::reported_table2;
using testing_support::reported_without_metadata;

std::string file_content(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Compares with tests/golden/report/<name>.html; where they differ, the new page stands beside the old
/// one as <name>.new.html, to be looked at in a browser before it takes its place.
void expect_golden(const std::string& page, const std::string& name) {
  const std::filesystem::path folder = std::filesystem::path(AXIOMETRY_SOURCE_DIR) / "tests/golden/report";
  const std::filesystem::path golden = folder / (name + ".html");
  const std::filesystem::path fresh = folder / (name + ".new.html");
  if (page == file_content(golden)) {
    std::filesystem::remove(fresh);
    return;
  }
  std::ofstream(fresh, std::ios::binary) << page;
  ADD_FAILURE() << name << " differs from the golden page; compare it with " << fresh;
}

TEST(HtmlWriter, MakesTheGoldenPageOfTable2) {
  Reported table2 = reported_table2();
  table2.judge({testing_support::tolerance("A", 10), testing_support::tolerance("B", 4)});
  expect_golden(table2.written("html"), "table2");
}

TEST(HtmlWriter, MakesTheGoldenPageOfReadingsAloneInMillimetresWithDecimalComma) {
  Reported bare = reported_without_metadata();
  bare.options = {.numbers = {','}, .unit = DisplayUnit::mm, .deviation_decimals = 2};
  expect_golden(bare.written("html"), "bare_mm_comma");
}

TEST(HtmlWriter, LoadsNothingAndRunsNothing) {
  const std::string page = reported_table2().written("html");
  EXPECT_THAT(page, Not(HasSubstr("<script")));
  EXPECT_THAT(page, Not(HasSubstr("<link")));
  EXPECT_FALSE(std::regex_search(page, std::regex(R"((src|href)="[^#])")));
  EXPECT_FALSE(std::regex_search(page, std::regex(R"(url\([^#])")));
  EXPECT_FALSE(std::regex_search(page, std::regex("@import")));
}

TEST(HtmlWriter, StatesItsLanguageAndIsSemantic) {
  const std::string page = reported_table2().written("html");
  for (const char* part :
       {"<!DOCTYPE html>", "<html lang=\"en\">", "<meta charset=\"utf-8\">", "<header>", "<main>", "<h1>",
        "<section id=\"parameters\"", "<caption>", "scope=\"col\"", "scope=\"row\"", "<figcaption>"})
    EXPECT_THAT(page, HasSubstr(part));
}

TEST(HtmlWriter, EscapesWhateverPeopleWrite) {
  Reported hostile = reported_table2();
  const std::string attack = "</style><script>alert('1')</script>\"><img src=x onerror=y>&\x01\xff";
  auto& m = hostile.test.metadata;
  m.machine.name = m.axis.name = m.conditions.report_number = m.conditions.comment = m.equipment[0].manufacturer =
      attack;
  hostile.test.provenance.file = hostile.assessment.label = attack;
  hostile.assessment.findings.push_back({attack, attack, iso230_2::Severity::departure, attack});
  const std::string page = hostile.written("html");
  EXPECT_THAT(page, Not(HasSubstr("<script")));
  EXPECT_THAT(page, Not(HasSubstr("<img")));
  EXPECT_EQ(page.find("</style>"), page.rfind("</style>"));
  EXPECT_EQ(page.find('\x01'), std::string::npos);
  EXPECT_EQ(page.find('\xff'), std::string::npos);
}

TEST(HtmlWriter, KeepsEveryScript) {
  Reported table2 = reported_table2();
  table2.test.metadata.machine.name = "立式加工中心 VMC-850";
  EXPECT_THAT(table2.written("html"), HasSubstr("立式加工中心 VMC-850"));
}

TEST(HtmlWriter, AlignsAtTheDecimalMarkByInvisibleDigits) {
  const std::string page = reported_table2().written("html");
  EXPECT_THAT(page, HasSubstr("<td class=\"number\" data-pad=\"0\"><b>9.6</b></td>"));
  EXPECT_THAT(page, HasSubstr("<td class=\"number\"><b>4.12</b></td>"));
}

TEST(HtmlWriter, ShowsTheLabelBesideEveryResult) {
  Reported table2 = reported_table2();
  table2.assessment.label = "step cycle (Annex B), not for acceptance";
  const std::string page = table2.written("html");
  std::size_t labels = 0;
  for (std::size_t at = page.find("<span class=\"label\">"); at != std::string::npos;
       at = page.find("<span class=\"label\">", at + 1))
    ++labels;
  EXPECT_EQ(labels, 5u);
}

}  // namespace
}  // namespace axiometry::report
