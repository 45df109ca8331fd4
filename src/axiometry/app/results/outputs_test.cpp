// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/results/outputs.h"

#include <gtest/gtest.h>

#include "tests/support/series.h"
#include "tests/support/temporary_folder.h"

namespace axiometry::app {
namespace {

std::string fault_of_many(const std::string& report) {
  OutputNames names;
  names.reports = {report};
  const auto outputs = ManyOutputs::create(names, {});
  return outputs ? "" : outputs.error().message;
}

TEST(ManyOutputs, AreRefusedBeforeTheFirstTestWhereTheirFolderIsNotThere) {
  EXPECT_EQ(fault_of_many("no-such-folder/{name}.pdf"),
            "found no folder \"no-such-folder\" for the reports, expected one that is there");
  EXPECT_EQ(fault_of_many("{name}.pdf"), "");
  EXPECT_EQ(fault_of_many("./{name}.pdf"), "");
  EXPECT_EQ(fault_of_many("{name}/report.pdf"), "") << "not known before the name is";
}

TEST(ManyOutputs, NumberTheReportsOfTestsThatHaveOneName) {
  const testing_support::TemporaryFolder folder;
  OutputNames names;
  names.reports = {folder.file("{name}.svg")};
  auto outputs = ManyOutputs::create(names, {});
  ASSERT_TRUE(outputs) << outputs.error().to_string();
  const Series series = testing_support::make_series({0, 1}, {{0, 1}, {3, 1}}, {});
  Evaluated evaluated = evaluate_test({{}, series, {}}, {}).value();
  for (const char* file : {"a/x.csv", "b/x.csv", "x-2.csv"}) {
    evaluated.test.provenance.file = file;
    ASSERT_TRUE(outputs->add(evaluated)) << file;
  }
  for (const char* report : {"x.svg", "x-2.svg", "x-2-2.svg"}) EXPECT_NE(folder.content(report), "") << report;
  EXPECT_EQ(outputs->numbered(),
            (std::vector<std::string>{
                "the report of \"b/x.csv\" is called \"x-2\": that of \"a/x.csv\" is called \"x\"",
                "the report of \"x-2.csv\" is called \"x-2-2\": that of \"b/x.csv\" is called \"x-2\""}));
  EXPECT_TRUE(outputs->numbered().empty());
  evaluated.test.provenance.file = "c/x.csv";
  ASSERT_TRUE(outputs->add(evaluated));
  EXPECT_NE(folder.content("x-3.svg"), "");
}

TEST(WriteDocument, RefusesAPictureWhereThereIsNoFigure) {
  const testing_support::TemporaryFolder folder;
  report::Document document;
  document.title = "List";
  document.sections.push_back({"list", "List", false, {report::Paragraph{report::plain("words"), {}}}});
  for (const char* picture : {"list.svg", "list.PNG"}) {
    const std::string files[] = {folder.file("list.html"), folder.file(picture)};
    const auto written = write_document(document, files, {});
    ASSERT_FALSE(written) << picture;
    EXPECT_TRUE(written.error().message.contains("expected html, pdf or csv: there is no figure")) << picture;
    EXPECT_EQ(folder.content("list.html"), "");
  }
  document.sections[0].blocks.emplace_back(report::Figure{});
  const std::string picture[] = {folder.file("list.svg")};
  EXPECT_TRUE(write_document(document, picture, {}));
}

}  // namespace
}  // namespace axiometry::app
