// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/figures/conformity.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "axiometry/report/figures/figure_rules_test_support.h"
#include "axiometry/report/figures/figures_test_support.h"
#include "axiometry/report/figures/parts/ink.h"

namespace axiometry::report {
namespace {

using iso230_2::Judgement;
using testing::all_words;
using ::testing::Contains;
using testing::fault_of;
using ::testing::IsSupersetOf;
using ::testing::Not;
using uncertainty::DecisionRule;
using Kind = DecisionRule::Kind;

/// Limits in parts of the measured value, u in parts of the limit; 0: none known.
std::vector<Judgement> judged(const testing::Drawn& drawn, std::size_t count, double limit, double u,
                              const DecisionRule& rule) {
  std::vector<iso230_2::Tolerance> tolerances;
  iso230_2::JudgedWith with;
  for (std::size_t k = 0; k < count; ++k) {
    const auto& parameter = iso230_2::parameters[k];
    const auto& value = drawn.assessment.evaluation.parameters.*parameter.member;
    const double magnitude = value ? std::max(std::abs(value->in_native()), 1e-3) : 1.0;
    tolerances.push_back({&parameter, Deviation::native(magnitude * limit)});
    if (u > 0.0 && value) {
      const double x = value->in_native();
      const double own = magnitude * limit * u;
      with.uncertainties[k] = iso230_2::ParameterUncertainty{{iso230_2::UncertaintyMethod::annex_a,
                                                              {},
                                                              Deviation::native(own),
                                                              Deviation::native(2.0 * own),
                                                              {x - 2.0 * own, x + 2.0 * own}},
                                                             uncertainty::Belief::normal(x, own)};
    }
  }
  return iso230_2::judge(drawn.assessment.evaluation.parameters, tolerances, rule, with);
}

std::optional<Figure> drawn(const testing::Drawn& from, const std::vector<Judgement>& judgements) {
  return conformity_figure({from.test, from.assessment, judgements}, from.options);
}

/// x of the disc of the k-th value.
double value_x(const Figure& figure, std::size_t k) {
  std::vector<double> all;
  for (const Operation& operation : figure.operations)
    if (const Disc* disc = std::get_if<Disc>(&operation)) all.push_back(disc->centre.x);
  return all.at(k + 1);  // the first is that of the legend
}

/// x of the line at 100 %.
double limit_x(const Figure& figure) {
  double x = 0.0;
  double longest = 0.0;
  for (const Operation& operation : figure.operations) {
    const Path* path = std::get_if<Path>(&operation);
    if (path == nullptr || path->points.size() != 2 || path->points[0].x != path->points[1].x) continue;
    const double length = std::abs(path->points[1].y - path->points[0].y);
    if (length > longest) std::tie(longest, x) = std::pair(length, path->points[0].x);
  }
  return x;
}

TEST(ConformityFigure, IsAbsentWhereNothingWasJudged) {
  const auto example = testing::table_2();
  EXPECT_FALSE(drawn(example, {}));
  const auto single =
      testing::drawn_from(testing::evenly(0, 100, 6), 1, [](auto i, auto, auto) { return static_cast<double>(i); });
  EXPECT_FALSE(drawn(single, judged(single, 1, 1.0, 0.1, {})));  // A does not exist
}

TEST(ConformityFigure, PutsEachValueOnTheScaleOfItsOwnTolerance) {
  const auto example = testing::table_2();
  const Figure figure = *drawn(example, judged(example, 12, 0.8, 0.05, {Kind::iso_14253_1}));
  constexpr double left = 34.0;
  for (std::size_t k = 0; k < 12; ++k)
    EXPECT_NEAR((value_x(figure, k) - left) / (limit_x(figure) - left), 1.0 / 0.8, 1e-9);
}

TEST(ConformityFigure, SaysValueLimitAndVerdictInWords) {
  const auto example = testing::table_2();
  const auto words = all_words(*drawn(example, judged(example, 1, 2.0, 0.05, {Kind::iso_14253_1})));
  EXPECT_THAT(words, IsSupersetOf({"A", "9.6 of 19.1728\u00A0µm", "conforms", "undecided", "does not conform"}));
}

TEST(ConformityFigure, HasNoUndecidedZoneUnderSimpleAcceptance) {
  const auto example = testing::table_2();
  EXPECT_THAT(all_words(*drawn(example, judged(example, 12, 2.0, 0.05, {}))), Not(Contains("undecided")));
}

TEST(ConformityFigure, CarriesTheLabelThatMustStandWhereverResultsDo) {
  auto example = testing::table_2();
  example.assessment.label = "step cycle (Annex B), not for acceptance";
  EXPECT_THAT(all_words(*drawn(example, judged(example, 3, 1.0, 0.1, {}))), Contains(example.assessment.label));
}

TEST(ConformityFigure, DescribesItselfForThoseWhoCannotSeeIt) {
  const auto example = testing::table_2();
  EXPECT_EQ(drawn(example, judged(example, 1, 2.0, 0.05, {Kind::iso_14253_1}))->description,
            "Each parameter against its tolerance: A = 9.6 of 19.1728\u00A0µm, conforms.");
}

TEST(ConformityFigure, StaysInItsBoxWithoutOverlapInEveryCrowdedCase) {
  for (const auto& c : testing::crowded_cases())
    for (const DecisionRule& rule :
         {DecisionRule{}, DecisionRule{Kind::iso_14253_1}, DecisionRule{Kind::guard_band, 1}})
      for (double limit : {1e-3, 0.7, 1.0, 1e3})
        for (double u : {0.0, 1e-6, 0.2, 1e3}) {
          const auto figure = drawn(c.drawn, judged(c.drawn, 12, limit, u, rule));
          if (figure) {
            EXPECT_EQ(fault_of(*figure), "") << c.name << " limit " << limit << " u " << u;
          }
        }
}

TEST(ConformityFigure, LooksAsTheGoldenPictures) {
  const auto example = testing::table_2();
  testing::expect_golden(*drawn(example, judged(example, 12, 1.3, 0.15, {Kind::iso_14253_1})), "conformity_twelve");
  testing::expect_golden(*drawn(example, judged(example, 1, 0.9, 0.05, {})), "conformity_simple");
  testing::expect_golden(*drawn(example, judged(example, 3, 0.2, 1.0, {Kind::iso_14253_1})), "conformity_huge_u");
  testing::expect_golden(*drawn(example, judged(example, 2, 1.2, 0.0, {Kind::iso_14253_1})), "conformity_without_u");
}

}  // namespace
}  // namespace axiometry::report
