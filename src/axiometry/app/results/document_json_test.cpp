// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/results/document_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace axiometry::app {
namespace {

using json::Value;
using testing::HasSubstr;
using testing::Not;

report::Document with(report::Block block) {
  report::Document document;
  document.sections.push_back({"one", "One", false, {std::move(block)}});
  return document;
}

std::string block_of(const report::Document& document, bool dark = false) {
  const Value all = document_to_json(document, dark);
  return json::dump(all.find("sections")->items().front().find("blocks")->items().front(), 0);
}

TEST(DocumentJson, HasTheStylesOfTexts) {
  const std::string text = block_of(with(report::Paragraph{report::symbol("B\u0304_i"), report::Tone::bad}));
  EXPECT_THAT(text, HasSubstr(R"("kind":"paragraph","tone":"bad")"));
  EXPECT_THAT(text, HasSubstr("{\"text\":\"B\u0304\",\"italic\":true}"));
  EXPECT_THAT(text, HasSubstr(R"({"text":"i","italic":true,"script":"sub"})"));
}

TEST(DocumentJson, HasTablesWithWhatTheirCellsMean) {
  report::Table table;
  table.caption = report::plain("Sizes");
  table.columns = {{report::plain("Name"), report::Align::start, true, true},
                   {report::plain("Value"), report::Align::decimal}};
  table.rows = {{{report::plain("A")}, {report::plain("–"), report::Tone::quiet}}};
  table.notes = {report::plain("In µm.")};
  EXPECT_EQ(block_of(with(table)),
            R"({"kind":"table","caption":[{"text":"Sizes"}],"groups":[],)"
            R"("columns":[{"head":[{"text":"Name"}],"align":"start","names_row":true,"takes_space":true},)"
            R"({"head":[{"text":"Value"}],"align":"decimal","names_row":false,"takes_space":false}],)"
            R"("rows":[[{"text":[{"text":"A"}],"tone":"normal"},{"text":[{"text":"–"}],"tone":"quiet"}]],)"
            R"("notes":[[{"text":"In µm."}]]})");
}

TEST(DocumentJson, HasNoticesFactsAndTheStatus) {
  report::Document document = with(report::Facts{"Test", {{report::plain("Axis"), {report::verbatim("X")}}}});
  document.status = {{report::Tone::caution, report::plain("Label: trial"), {report::plain("Look at it.")}}};
  EXPECT_EQ(block_of(document), R"({"kind":"facts","title":"Test","facts":[{"name":[{"text":"Axis"}],)"
                                R"("value":{"text":[{"text":"X"}],"tone":"normal"}}]})");
  EXPECT_EQ(json::dump(*document_to_json(document, false).find("status"), 0),
            R"([{"tone":"caution","heading":[{"text":"Label: trial"}],"lines":[[{"text":"Look at it."}]]}])");
}

TEST(DocumentJson, DrawsFiguresForTheLightOrTheDarkPage) {
  report::Figure figure{.width = 10, .height = 10, .title = "Line", .description = "A line."};
  figure.operations.emplace_back(
      report::Path{.points = {{0, 0}, {10, 10}}, .stroke = {.colour = {0, 0, 0}, .width = 1}});
  const std::string light = block_of(with(figure)), dark = block_of(with(figure), true);
  EXPECT_THAT(light, HasSubstr(R"("kind":"figure","title":"Line","description":"A line.","svg":"<svg)"));
  EXPECT_NE(light, dark);
}

}  // namespace
}  // namespace axiometry::app
