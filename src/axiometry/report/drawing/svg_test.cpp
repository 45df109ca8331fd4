// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/drawing/svg.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace axiometry::report {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

Figure figure_with(Operation operation) {
  return {.width = 100, .height = 50, .title = "T", .description = "D", .operations = {std::move(operation)}};
}

TEST(Svg, NamesItselfForThoseWhoCannotSeeIt) {
  const std::string svg = to_svg({.width = 100, .height = 50.5, .title = "A <b> & \"c\"", .description = "D > E"});
  EXPECT_THAT(svg, HasSubstr("role=\"img\""));
  EXPECT_THAT(svg, HasSubstr("viewBox=\"0 0 100 50.5\""));
  EXPECT_THAT(svg, HasSubstr("<title>A &lt;b&gt; &amp; &quot;c&quot;</title>"));
  EXPECT_THAT(svg, HasSubstr("<desc>D &gt; E</desc>"));
}

TEST(Svg, ReplacesWhatXmlForbids) {
  const std::string svg = to_svg({.width = 1,
                                  .height = 1,
                                  .title = "a\x01"
                                           "b\xff"
                                           "c\nd"});
  EXPECT_THAT(svg, HasSubstr("<title>a\uFFFDb\uFFFDc d</title>"));
}

TEST(Svg, WritesNumbersShortly) {
  const Path path{.points = {{0, -0.001}, {0.5, -12.25}, {100.126, 3}}, .stroke = {.colour = {1, 0, 0}, .width = 0.5}};
  EXPECT_THAT(to_svg(figure_with(path)),
              HasSubstr("<path d=\"M0 0L.5 -12.25L100.13 3\" fill=\"none\" stroke=\"#ff0000\" stroke-width=\".5\"/>"));
}

TEST(Svg, SetsSymbolsAsRealText) {
  const Text text{.runs = {{.text = "x", .italic = true, .bar = true},
                           {.text = "i", .italic = true, .script = Script::sub},
                           {.text = " < 2"}},
                  .at = {10, 20},
                  .size = 10};
  const std::string svg = to_svg(figure_with(text));
  EXPECT_THAT(svg, HasSubstr("<tspan font-style=\"italic\">x</tspan><tspan dy=\"1.7\" font-size=\"7.2\" "
                             "font-style=\"italic\">i</tspan><tspan dy=\"-1.7\"> &lt; 2</tspan></text>"));
  EXPECT_THAT(svg, HasSubstr("<path d=\"M11."));  // the bar
}

TEST(Svg, TurnsATextWithItsBar) {
  const Text text{.runs = {{.text = "B", .bar = true}}, .at = {10, 20}, .degrees = 90};
  const std::string svg = to_svg(figure_with(text));
  const std::string rotation = "transform=\"rotate(-90 10 20)\"";
  const auto first = svg.find(rotation);
  ASSERT_NE(first, std::string::npos);
  EXPECT_NE(svg.find(rotation, first + 1), std::string::npos);
}

TEST(Svg, GathersEqualDotsInOnePath) {
  Figure figure{.width = 10, .height = 10};
  for (const double x : {1.0, 2.0}) figure.operations.push_back(Disc{.centre = {x, 3}, .radius = 0.5});
  figure.operations.push_back(Disc{.centre = {5, 5}, .radius = 0.7});
  const std::string svg = to_svg(figure);
  EXPECT_THAT(svg, HasSubstr("<path d=\"M1 3h0M2 3h0\" fill=\"none\" stroke-linecap=\"round\""));
  EXPECT_THAT(svg, HasSubstr("<circle cx=\"5\""));
}

TEST(Stacked, PutsFiguresBelowEachOtherWithTheirCaptions) {
  const Disc disc{.centre = {50, 25}, .radius = 1};
  const std::vector<Figure> both = {figure_with(disc), figure_with(disc)};
  const Figure page = stacked(both);
  EXPECT_EQ(page.operations.size(), 4u);
  const double first = std::get<Disc>(page.operations[0]).centre.y;
  const double second = std::get<Disc>(page.operations[2]).centre.y;
  EXPECT_GT(second - first, 50.0);
  EXPECT_EQ(std::get<Text>(page.operations[1]).runs.front().text, "T");
  EXPECT_EQ(page.title, "T T");
  EXPECT_LT(std::get<Text>(page.operations[3]).at.y, page.height);
}

TEST(Stacked, OfNothingIsAnEmptyPage) { EXPECT_TRUE(stacked({}).operations.empty()); }

}  // namespace
}  // namespace axiometry::report
