// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

#include "axiometry/report/writer.h"
#include "tests/support/report_subject.h"
#include "tests/support/temporary_folder.h"

namespace axiometry::report {
namespace {

using ::testing::HasSubstr;
using testing_support::Reported;
using testing_support::reported;
using testing_support::reported_table2;
using testing_support::reported_without_metadata;

/// The text of a PDF by pdftotext, in the order of the page; nothing where there is no such program.
std::optional<std::string> text_of(const std::string& pdf) {
  if (std::system("command -v pdftotext > /dev/null 2>&1") != 0) return std::nullopt;
  const testing_support::TemporaryFolder folder;
  const std::string base = folder.file("report");
  folder.written("report.pdf", pdf);
  const int status = std::system(("pdftotext -layout " + base + ".pdf " + base + ".txt").c_str());
  return status == 0 ? std::optional(folder.content("report.txt")) : std::nullopt;
}

#define TEXT_OR_SKIP(text, pdf)   \
  const auto text = text_of(pdf); \
  if (!text) GTEST_SKIP() << "pdftotext is not installed"

TEST(PdfWriter, HoldsTheContentOfTheReport) {
  TEXT_OR_SKIP(text, reported_table2().written("pdf"));
  for (const char* part :
       {"Positioning accuracy and repeatability of an NC axis", "Tested in accordance with ISO 230-2:2014",
        "Parameters of the axis", "Figure 2", "Findings", "Identification of the test", "Mill 5", "1750.920",
        "Measurement uncertainty (Annex A)", "floored", "Slope of the means", "table2.csv", "Axis X · Mill 5"})
    EXPECT_THAT(*text, HasSubstr(part));
}

TEST(PdfWriter, NumbersItsPages) {
  TEXT_OR_SKIP(text, reported_table2().written("pdf"));
  EXPECT_THAT(*text, HasSubstr("Page 1 of 7"));
  EXPECT_THAT(*text, HasSubstr("Page 7 of 7"));
}

TEST(PdfWriter, NamesTheProgramAtTheFootOfEveryDocument) {
  Document document;  // of whatever kind: nobody need think of it
  document.title = "Motion";
  TEXT_OR_SKIP(text, find_writer("pdf")->set(document, {}).value());
  EXPECT_THAT(*text, HasSubstr(program_text()));
}

TEST(PdfWriter, RepeatsTheHeadOfATableOnEveryPage) {
  std::vector<double> targets;
  for (int k = 0; k < 101; ++k) targets.push_back(20.0 * k);
  const std::vector<testing_support::RunDeviations> runs(5, testing_support::RunDeviations(101, 1.5));
  TEXT_OR_SKIP(text, reported({{}, testing_support::make_series(targets, runs, runs), {}}).written("pdf"));
  std::size_t heads = 0;
  for (std::size_t at = text->find("from below"); at != std::string::npos; at = text->find("from below", at + 1))
    ++heads;
  EXPECT_GE(heads, 2u);
  EXPECT_THAT(*text, HasSubstr("2000"));
}

TEST(PdfWriter, BreaksATextThatIsLongerThanAPage) {
  Reported table2 = reported_table2();
  std::string& comment = table2.test.metadata.conditions.comment;
  for (int k = 0; k < 3000; ++k) comment += "word" + std::to_string(k) + " ";
  TEXT_OR_SKIP(text, table2.written("pdf"));
  for (const char* word : {"word0 ", "word1500 ", "word2999"}) EXPECT_THAT(*text, HasSubstr(word));
}

TEST(PdfWriter, TakesHostileTextsAndHugeNumbers) {
  Reported hostile =
      reported({{}, testing_support::make_series({0, 1}, {{9e8, -9e8}, {9e8, 1}}, {{-9e8, 9e8}, {2, -9e8}}), {}});
  hostile.test.metadata.machine.name = std::string(5000, 'W') + "\xff\x01 立式 שלום";
  hostile.test.metadata.conditions.report_number = std::string(500, '9');
  EXPECT_TRUE(hostile.written("pdf").starts_with("%PDF-1."));
}

TEST(PdfWriter, LosesNothingOfAWordOrATextThatItCutsIntoParagraphs) {
  Reported table2 = reported_table2();
  std::string& comment = table2.test.metadata.conditions.comment;
  for (int k = 0; k < 1500; ++k) comment += "µ";
  comment += "|";
  table2.test.metadata.machine.name = std::string(100'000, 'W');  // took Pango most of a minute as one paragraph
  TEXT_OR_SKIP(text, table2.written("pdf"));
  EXPECT_THAT(*text, HasSubstr("|"));
  EXPECT_THAT(*text, ::testing::Not(HasSubstr("\uFFFD")));
  EXPECT_GE(std::ranges::count(*text, 'W'), 100'000);
}

TEST(PdfWriter, AddsNoHyphenWhereItBreaksASerialNumber) {
  Reported table2 = reported_table2();
  table2.test.metadata.machine.serial_number = std::string(300, 'Q');
  TEXT_OR_SKIP(text, table2.written("pdf"));
  EXPECT_THAT(*text, HasSubstr("QQQQ"));
  EXPECT_THAT(*text, ::testing::Not(HasSubstr("Q-")));
  EXPECT_THAT(*text, ::testing::Not(HasSubstr("Q\u2010")));
}

TEST(PdfWriter, SetsADocumentOfATitleAlone) {
  const Writer* writer = find_writer("pdf");
  Document document;
  document.title = "Nothing but a title";
  const auto pdf = writer->set(document, {});
  ASSERT_TRUE(pdf) << pdf.error().to_string();
  EXPECT_TRUE(pdf->starts_with("%PDF-"));
}

TEST(PdfWriter, KeepsTheCaptionOfAFigureThatFillsThePageBelowIt) {
  for (std::size_t paragraphs = 1; paragraphs <= 9; ++paragraphs) {
    Section section{"only", "Section", false, {}};
    for (std::size_t k = 0; k < paragraphs; ++k) section.blocks.emplace_back(Paragraph{plain("A line above.")});
    Figure figure;
    figure.width = 500.0 + static_cast<double>(paragraphs) / 3.0;
    figure.height = 620.0;
    figure.title = "Caption below";
    section.blocks.emplace_back(std::move(figure));
    Document document{.title = "Title"};
    document.sections.push_back(std::move(section));
    const auto pdf = find_writer("pdf")->set(document, {});
    ASSERT_TRUE(pdf) << pdf.error().to_string();
    TEXT_OR_SKIP(text, *pdf);
    EXPECT_THAT(*text, HasSubstr("Page 1 of 1")) << paragraphs;
  }
}

TEST(PdfWriter, WritesTheSameBytesAgain) {
  EXPECT_TRUE(reported_table2().written("pdf") == reported_table2().written("pdf"));
  EXPECT_TRUE(reported_without_metadata().written("pdf") == reported_without_metadata().written("pdf"));
}

TEST(PdfWriter, IsDatedByTheTestOrNotAtAll) {
  EXPECT_TRUE(reported_table2().written("pdf").contains("/CreationDate (D:20240506)"));
  EXPECT_FALSE(reported_without_metadata().written("pdf").contains("/CreationDate"));
}

}  // namespace
}  // namespace axiometry::report
