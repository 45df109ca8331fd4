// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/figures/mean_deviations.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "axiometry/report/figures/figure_rules_test_support.h"
#include "axiometry/report/figures/figures_test_support.h"
#include "axiometry/report/figures/parts/ink.h"
#include "axiometry/report/translated.h"

namespace axiometry::report {
namespace {

using testing::fault_of;
using ::testing::HasSubstr;
using ::testing::Not;

testing::Drawn with_means(testing::Drawn drawn) {
  drawn.test.metadata.uncertainty.machine_temperature_range = TemperatureDifference::kelvin(1.0);
  drawn.test.metadata.uncertainty.environmental_variation = Deviation::native(1.7);
  drawn.assessment.gum = iso230_2::gum(drawn.test, drawn.assessment.evaluation).value();
  return drawn;
}

testing::Drawn two_ways() {
  return with_means(testing::drawn_from({0, 250, 500, 1000}, 5, [](std::size_t i, Direction direction, std::size_t j) {
    return 2.0 * double(i) + (direction == Direction::up ? -1.0 : 1.0) + 0.1 * double(j);
  }));
}

testing::Drawn one_way(Direction only) {
  return with_means(testing::drawn_from({0, 250, 500, 1000}, 5, [&](std::size_t i, Direction direction, std::size_t j) {
    return direction == only ? 2.0 * double(i) + 0.1 * double(j) : std::nan("");
  }));
}

struct Bar {
  double x, middle, length;
};

/// Upright lines in the colour of the bars; the legend's lies.
std::vector<Bar> bars_in(const Figure& figure) {
  std::vector<Bar> bars;
  for (const Operation& operation : figure.operations) {
    const Path* path = std::get_if<Path>(&operation);
    if (path == nullptr || path->points.size() != 2 || path->stroke.colour != plot::ink::blue) continue;
    const auto [a, b] = std::pair(path->points[0], path->points[1]);
    if (a.x == b.x) bars.push_back({a.x, (a.y + b.y) / 2.0, std::abs(a.y - b.y)});
  }
  return bars;
}

TEST(MeanDeviations, HaveBarsAsLongAsTheirUncertaintiesAboutTheirMeans) {  // Lira & Cargill, Fig. 3
  const auto drawn = two_ways();
  const auto figure = mean_deviation_figure(drawn.subject(), drawn.options);
  ASSERT_TRUE(figure);
  const auto bars = bars_in(*figure);
  const auto& known = drawn.assessment.gum->positions;
  const auto& results = drawn.assessment.evaluation.positions;
  ASSERT_EQ(bars.size(), 4u);
  EXPECT_GT(known[3].mean->U.in_native(), 1.5 * known[0].mean->U.in_native()) << "the test must tell them apart";
  const double per_um =
      (bars[0].middle - bars[3].middle) / (results[3].mean->in_native() - results[0].mean->in_native());
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(bars[i].length, 2.0 * known[i].mean->U.in_native() * per_um, 1e-6) << i;
    EXPECT_NEAR(bars[i].middle - bars[0].middle, (results[0].mean->in_native() - results[i].mean->in_native()) * per_um,
                1e-6)
        << i;
  }
  EXPECT_NEAR((bars[1].x - bars[0].x) / (bars[3].x - bars[0].x), 0.25, 1e-9);
}

testing::Drawn with_annex_a(testing::Drawn drawn) {
  drawn.assessment.annex_a = iso230_2::annex_a(drawn.test.metadata, drawn.test.series, drawn.assessment.evaluation);
  return drawn;
}

TEST(MeanDeviations, HaveBarsOfTheContributorsOfAnnexA) {
  const auto drawn = with_annex_a(two_ways());
  const auto figure = mean_annex_a_figure(drawn.subject(), drawn.options);
  ASSERT_TRUE(figure);
  EXPECT_EQ(fault_of(*figure), "");
  EXPECT_THAT(figure->title, HasSubstr("contributors of Annex A"));
  const auto bars = bars_in(*figure);
  const auto& known = drawn.assessment.annex_a->positions;
  ASSERT_EQ(bars.size(), 4u);
  EXPECT_GT(known[3].mean->U.in_native(), 1.5 * known[0].mean->U.in_native()) << "the test must tell them apart";
  EXPECT_NEAR(bars[0].length / bars[3].length, known[0].mean->U.in_native() / known[3].mean->U.in_native(), 1e-9);
}

TEST(MeanDeviations, SayThatBarsOfAnnexAAreTooShortWhereContributorsAreMissing) {
  auto drawn = with_annex_a(two_ways());
  ASSERT_FALSE(drawn.assessment.annex_a->missing.empty());
  EXPECT_THAT(mean_annex_a_figure(drawn.subject(), drawn.options)->description, HasSubstr("too small"));
  drawn.assessment.annex_a->missing.clear();
  EXPECT_THAT(mean_annex_a_figure(drawn.subject(), drawn.options)->description, Not(HasSubstr("too small")));
  drawn.assessment.annex_a.reset();
  EXPECT_FALSE(mean_annex_a_figure(drawn.subject(), drawn.options));
}

TEST(MeanDeviations, OfOneDirectionAreThoseOfThatDirection) {
  for (const Direction only : {Direction::up, Direction::down}) {
    const auto drawn = one_way(only);
    const auto figure = mean_deviation_figure(drawn.subject(), drawn.options);
    ASSERT_TRUE(figure);
    EXPECT_THAT(figure->title, HasSubstr(only == Direction::up ? "unidirectional positioning deviations ↑"
                                                               : "unidirectional positioning deviations ↓"));
    EXPECT_EQ(bars_in(*figure).size(), 4u);
  }
}

TEST(MeanDeviations, AreNotDrawnWithoutTheMethodOrWithoutAnUncertainty) {
  auto drawn = two_ways();
  drawn.assessment.gum.reset();
  EXPECT_FALSE(mean_deviation_figure(drawn.subject(), drawn.options));
  drawn = two_ways();
  for (auto& position : drawn.assessment.gum->positions) position = {position.target, {}, {}, {}};
  EXPECT_FALSE(mean_deviation_figure(drawn.subject(), drawn.options));
}

TEST(MeanDeviations, KeepTheRulesOfFigures) {
  for (const auto& drawn : {two_ways(), one_way(Direction::up)}) {
    const auto figure = mean_deviation_figure(drawn.subject(), drawn.options);
    ASSERT_TRUE(figure);
    EXPECT_EQ(fault_of(*figure), "");
  }
  const auto many =
      with_means(testing::drawn_from(testing::evenly(0, 1000, 3000), 2, [](std::size_t i, Direction, std::size_t j) {
        return std::sin(0.01 * double(i)) + 0.1 * double(j);
      }));
  const auto figure = mean_deviation_figure(many.subject(), many.options);
  ASSERT_TRUE(figure);
  EXPECT_LT(bars_in(*figure).size(), 1100u) << "as many as the tables show";
}

TEST(MeanDeviations, AreGermanInAGermanReport) {
  auto drawn = two_ways();
  drawn.options.language = language::Language::german;
  const Figure figure = with_words_translated(*mean_deviation_figure(drawn.subject(), drawn.options), drawn.options);
  EXPECT_EQ(figure.title, "Mittlere beidseitige Positionsabweichungen mit erweiterter Unsicherheit (GUM)");
  EXPECT_THAT(figure.description, HasSubstr("Zielpositionen; die erweiterte Unsicherheit reicht von "));
}

}  // namespace
}  // namespace axiometry::report
