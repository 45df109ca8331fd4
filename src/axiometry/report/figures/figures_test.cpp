// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/figures/figures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "axiometry/report/drawing/svg.h"
#include "axiometry/report/drawing/text_layout.h"
#include "axiometry/report/figures/figure_rules_test_support.h"
#include "axiometry/report/figures/figures_test_support.h"
#include "axiometry/report/figures/parts/dimension_line.h"
#include "axiometry/report/figures/parts/ink.h"

namespace axiometry::report {
namespace {

using testing::all_words;
using testing::crowded_cases;
using testing::Drawn;
using testing::expect_golden;
using testing::fault_of;
using testing::table_2;
using testing::texts;
using testing::words;

/// Tips of the arrow heads at one x, from top to bottom.
std::vector<double> tips_at(const Figure& figure, double x) {
  std::vector<double> tips;
  for (const Operation& operation : figure.operations) {
    const Path* path = std::get_if<Path>(&operation);
    if (path == nullptr || !path->closed || path->fill != plot::ink::black) continue;
    if (std::abs(path->points.front().x - x) < 1e-9) tips.push_back(path->points.front().y);
  }
  std::ranges::sort(tips);
  return tips;
}

/// Length of the dimension line with the label that begins so.
double length_of(const Figure& figure, std::string_view label) {
  for (const Text& text : texts(figure)) {
    if (!words(text).starts_with(label) || text.degrees == 0.0) continue;
    for (const Operation& operation : figure.operations) {
      const Path* path = std::get_if<Path>(&operation);
      if (path == nullptr || !path->closed || path->fill != plot::ink::black) continue;
      const double x = path->points.front().x;
      if (x < text.at.x || x > text.at.x + 5.0) continue;
      const auto tips = tips_at(figure, x);
      return tips.back() - tips.front();
    }
  }
  ADD_FAILURE() << "no dimension line " << label;
  return 0.0;
}

TEST(Figures, OfTheWorkedExampleAreTheThreeOfClause8) {
  const auto example = table_2();
  const auto all = example.draw();
  ASSERT_EQ(all.size(), 3u);
  EXPECT_TRUE(all[0].title.starts_with("Figure 2."));
  EXPECT_TRUE(all[1].title.starts_with("Figure 3a."));
  EXPECT_TRUE(all[2].title.starts_with("Figure 3b."));
}

TEST(Figures, LabelTheDimensionLinesWithSymbolAndValue) {
  const auto all = table_2().draw();
  using ::testing::IsSupersetOf;
  EXPECT_THAT(all_words(all[0]), IsSupersetOf({"A = 9.6\u00A0µm", "E = 7.7\u00A0µm", "M = 4.0\u00A0µm",
                                               "B = |B2| = 4.1\u00A0µm", "R = R9 = 6.6\u00A0µm"}));
  EXPECT_THAT(all_words(all[1]), IsSupersetOf({"A↑ = 6.1\u00A0µm", "E↑ = 3.9\u00A0µm", "R↑ = R10↑ = 3.0\u00A0µm"}));
  EXPECT_THAT(all_words(all[2]), IsSupersetOf({"A↓ = 5.8\u00A0µm", "E↓ = 4.0\u00A0µm"}));
}

TEST(Figures, DrawDimensionLinesToScale) {
  const auto example = table_2();
  const Figure figure = example.draw().front();
  const auto& p = example.assessment.evaluation.parameters;
  const double points_per_um = length_of(figure, "A = ") / p.A->in_native();
  EXPECT_NEAR(length_of(figure, "E = "), points_per_um * p.E->in_native(), 1e-6);
  EXPECT_NEAR(length_of(figure, "M = "), points_per_um * p.M->in_native(), 1e-6);
}

TEST(Figures, OfOneDirectionAreFigure3Alone) {
  for (const auto& c : crowded_cases()) {
    if (c.name != "up_only") continue;
    const auto all = c.drawn.draw();
    ASSERT_EQ(all.size(), 1u);
    EXPECT_TRUE(all[0].title.starts_with("Figure 3."));
  }
}

TEST(Figures, OfASingleRunHaveNoLinesForRAndA) {
  for (const auto& c : crowded_cases()) {
    if (c.name != "single_run") continue;
    for (const Figure& figure : c.drawn.draw()) {
      for (const std::string& label : all_words(figure)) {
        EXPECT_FALSE(label.starts_with("R") || label.starts_with("A")) << label;
      }
    }
  }
}

TEST(Figures, CarryTheLabelThatMustStandWhereverResultsDo) {
  auto example = table_2();
  example.assessment.label = "step cycle (Annex B), not for acceptance";
  for (const Figure& figure : example.draw()) {
    EXPECT_THAT(all_words(figure), ::testing::Contains("step cycle (Annex B), not for acceptance"));
  }
}

TEST(Figures, UseTheDecimalMarkOfTheOptions) {
  auto example = table_2();
  example.options.numbers.decimal_mark = ',';
  EXPECT_THAT(all_words(example.draw().front()), ::testing::Contains("A = 9,6\u00A0µm"));
}

TEST(Figures, ShowNanometresRatherThanAZeroThatIsNone) {
  for (const auto& c : crowded_cases()) {
    if (c.name != "nanometres") continue;
    using ::testing::IsSupersetOf;
    EXPECT_THAT(all_words(c.drawn.draw().front()),
                IsSupersetOf({"A = 14\u00A0nm", "M = 2.1\u00A0nm", "Deviation / nm"}));
  }
}

TEST(Figures, StayInTheirBoxWithoutOverlapInEveryCrowdedCase) {
  for (const auto& c : crowded_cases()) {
    for (const Figure& figure : c.drawn.draw()) EXPECT_EQ(fault_of(figure), "") << c.name << ": " << figure.title;
  }
}

RC_GTEST_PROP(Figures, StayInTheirBoxWithoutOverlapForAnySeries, ()) {
  const auto m = *rc::gen::inRange<std::size_t>(2, 60);
  const auto n = *rc::gen::inRange<std::size_t>(1, 5);
  const double scale = std::pow(10.0, *rc::gen::inRange(-5, 9));
  const double slope = scale * *rc::gen::elementOf(std::vector<double>{0, 0.5, -3, 50});
  const double offset = scale * *rc::gen::elementOf(std::vector<double>{0, 0, 7, -1000});
  const auto cells = *rc::gen::container<std::vector<int>>(2 * m * n, rc::gen::inRange(-1000, 1000));
  const auto steps = *rc::gen::container<std::vector<int>>(m, rc::gen::inRange(1, 2000));
  std::vector<double> targets;
  double target = *rc::gen::inRange(-100000, 100000) * 0.01;
  for (const int step : steps) targets.push_back(target += 0.001 * step * step);
  const AxisKind kind = *rc::gen::element(AxisKind::linear, AxisKind::rotary);
  const Drawn any = testing::drawn_from(
      targets, n,
      [&](std::size_t i, Direction direction, std::size_t j) {
        const int cell = cells[(static_cast<std::size_t>(direction) * m + i) * n + j];
        const bool keep = (direction == Direction::up && j == 0) || cell % 11 != 0;
        const double value = offset + slope * static_cast<double>(i) / static_cast<double>(m) + scale * 1e-3 * cell;
        return keep ? std::clamp(value, -1e9, 1e9) : std::nan("");
      },
      kind);
  for (const Figure& figure : any.draw()) RC_ASSERT(fault_of(figure) == "");
}

TEST(Figures, LookAsTheGoldenPictures) {
  const auto example = table_2().draw();
  expect_golden(example.at(0), "table_2_bidirectional");
  expect_golden(example.at(1), "table_2_up");
  expect_golden(example.at(2), "table_2_down");
  for (const auto& c : crowded_cases()) {
    if (c.name != "huge") expect_golden(c.drawn.draw().front(), c.name);
  }
}

}  // namespace
}  // namespace axiometry::report
