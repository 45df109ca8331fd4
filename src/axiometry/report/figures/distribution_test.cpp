// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/figures/distribution.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "axiometry/report/figures/contribution.h"
#include "axiometry/report/figures/figure_rules_test_support.h"
#include "axiometry/report/figures/figures_test_support.h"
#include "tests/support/made_up_monte_carlo.h"

namespace axiometry::report {
namespace {

using testing::all_words;
using ::testing::Contains;
using testing::Drawn;
using testing::fault_of;
using ::testing::IsSupersetOf;
using ::testing::Not;

Drawn with_monte_carlo(Drawn drawn) {
  drawn.assessment.monte_carlo = testing_support::made_up_monte_carlo(drawn.assessment.evaluation);
  return drawn;
}

/// Annex A and the GUM beside it.
Drawn with_all_methods(Drawn drawn) {
  drawn.test.metadata.uncertainty.environmental_variation = Deviation::native(1.7);
  drawn.test.metadata.uncertainty.misalignment = Length::mm(1);
  const Metadata& metadata = drawn.test.metadata;
  const Series& series = drawn.test.series;
  auto& assessment = drawn.assessment;
  assessment.annex_a = iso230_2::annex_a(metadata, series, assessment.evaluation);
  assessment.gum = iso230_2::gum(Test{metadata, series, {}}, assessment.evaluation).value();
  return with_monte_carlo(std::move(drawn));
}

Figure distribution(const Drawn& drawn) { return distribution_figure(drawn.subject(), drawn.options).value(); }

TEST(DistributionFigure, IsNoneWithoutTheMonteCarloMethod) {
  const Drawn table2 = testing::table_2();
  EXPECT_FALSE(distribution_figure(table2.subject(), table2.options));
}

TEST(DistributionFigure, ShowsEveryParameterThatExists) {
  const auto words = all_words(distribution(with_monte_carlo(testing::table_2())));
  EXPECT_THAT(words, IsSupersetOf({"A = 9.59\u00a0µm", "A↑ = 6.14\u00a0µm", "R↓ = 2.55\u00a0µm", "M = 3.99\u00a0µm",
                                   "B = 4.12\u00a0µm", "95\u00a0% interval"}));
  EXPECT_THAT(words, Not(Contains("limit")));
}

TEST(DistributionFigure, NamesTheMethodsThatItCompares) {
  const auto words = all_words(distribution(with_all_methods(testing::table_2())));
  EXPECT_THAT(words, IsSupersetOf({"Annex A, ± U", "GUM, ± U"}));
}

TEST(DistributionFigure, ShowsTheLimitThatWasJudged) {
  const Drawn table2 = with_monte_carlo(testing::table_2());
  const iso230_2::Tolerance limit{iso230_2::find_parameter("A"), Deviation::native(10)};
  const auto judgements = iso230_2::judge(table2.assessment.evaluation.parameters, std::vector{limit}, {}, {});
  const auto figure = distribution_figure({table2.test, table2.assessment, judgements}, table2.options).value();
  EXPECT_EQ(fault_of(figure), "");
  EXPECT_THAT(all_words(figure), IsSupersetOf({"limit", "limit 10"}));
}

TEST(DistributionFigure, CarriesTheLabelThatMustStandWhereverResultsDo) {
  Drawn table2 = with_monte_carlo(testing::table_2());
  table2.assessment.label = "step cycle (Annex B), not for acceptance";
  const auto contribution = contribution_figure(table2.subject(), table2.options).value();
  for (const Figure& figure : {distribution(table2), contribution}) {
    EXPECT_THAT(all_words(figure), Contains("step cycle (Annex B), not for acceptance"));
    EXPECT_EQ(fault_of(figure), "");
  }
}

TEST(DistributionFigure, SaysWhatDoesNotVary) {
  for (auto& c : testing::crowded_cases()) {
    if (c.name != "all_zero") continue;
    EXPECT_THAT(all_words(distribution(with_monte_carlo(c.drawn))), Contains("does not vary"));
  }
}

TEST(DistributionFigure, StaysInItsBoxWithoutOverlapInEveryCase) {
  for (auto& c : testing::crowded_cases()) {
    EXPECT_EQ(fault_of(distribution(with_monte_carlo(c.drawn))), "") << c.name;
    EXPECT_EQ(fault_of(distribution(with_all_methods(c.drawn))), "") << c.name;
  }
}

TEST(DistributionFigure, HasTheSameHeightOnEveryPanelWhateverTheNumberOfTrials) {
  Drawn table2 = with_monte_carlo(testing::table_2());
  const Figure few = distribution(table2);
  for (auto& d : table2.assessment.monte_carlo->distributions)
    if (d)
      for (auto& count : d->summary.histogram.counts) count *= 1000;
  EXPECT_EQ(to_svg(distribution(table2)), to_svg(few));
}

TEST(DistributionFigure, LooksAsTheGoldenPictures) {
  testing::expect_golden(distribution(with_all_methods(testing::table_2())), "distribution");
  for (auto& c : testing::crowded_cases()) {
    if (c.name == "all_zero" || c.name == "up_only" || c.name == "single_run" || c.name == "rotary")
      testing::expect_golden(distribution(with_monte_carlo(c.drawn)), "distribution_" + c.name);
  }
}

TEST(ContributionFigure, IsNoneWithoutAMethodThatTells) {
  const Drawn table2 = testing::table_2();
  EXPECT_FALSE(contribution_figure(table2.subject(), table2.options));
}

TEST(ContributionFigure, ShowsInputsByTheirPartOfTheVariance) {
  const Drawn table2 = with_monte_carlo(testing::table_2());
  const auto figure = contribution_figure(table2.subject(), table2.options).value();
  EXPECT_THAT(all_words(figure), IsSupersetOf({"u(A) / µm", "64\u00a0%", "36\u00a0%", "100\u00a0%", "–"}));
  testing::expect_golden(figure, "contribution");
}

TEST(ContributionFigure, SumsUpWhatIsBeyondTenInputs) {
  Drawn table2 = with_monte_carlo(testing::table_2());
  auto& all = table2.assessment.monte_carlo->contributions;
  for (int k = 0; k < 12; ++k) {
    all.push_back({"", std::string(200, 'W'), {}});
    all.back().u.fill(0.01);
  }
  const auto figure = contribution_figure(table2.subject(), table2.options).value();
  EXPECT_EQ(fault_of(figure), "");
  EXPECT_THAT(all_words(figure), Contains("5 others together"));
}

TEST(ContributionFigure, StaysInItsBoxWithoutOverlapInEveryCase) {
  for (auto& c : testing::crowded_cases()) {
    const Drawn drawn = with_monte_carlo(c.drawn);
    const auto figure = contribution_figure(drawn.subject(), drawn.options);
    if (figure) {
      EXPECT_EQ(fault_of(*figure), "") << c.name;
    }
  }
}

}  // namespace
}  // namespace axiometry::report
