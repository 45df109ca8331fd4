// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/method_values.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/made_up_monte_carlo.h"
#include "tests/support/report_subject.h"

namespace axiometry::report {
namespace {

using ::testing::HasSubstr;
using testing_support::made_up_monte_carlo;
using testing_support::Reported;
using testing_support::reported_table2;

Reported with_monte_carlo() {
  Reported table2 = reported_table2();
  table2.assessment.monte_carlo = made_up_monte_carlo(table2.assessment.evaluation);
  return table2;
}

std::vector<MethodRow> rows(const Reported& reported) {
  return method_rows(reported.assessment, reported.test.metadata.axis.kind, reported.options);
}

const MethodRow& row(const std::vector<MethodRow>& rows, std::string_view key) {
  for (const MethodRow& row : rows)
    if (row.parameter->key == key) return row;
  throw std::logic_error("no such row");
}

std::size_t index(std::string_view key) {
  return static_cast<std::size_t>(iso230_2::find_parameter(key) - iso230_2::parameters);
}

TEST(MethodValues, EndWhereTheStandardUncertaintyDoes) {
  const auto all = rows(with_monte_carlo());
  const MethodRow& a = row(all, "A");
  ASSERT_TRUE(a.monte_carlo);
  EXPECT_EQ(a.value, "9.59");
  EXPECT_EQ(a.monte_carlo->u, "0.77");
  EXPECT_EQ(a.monte_carlo->mean, "9.11");
  EXPECT_EQ(a.monte_carlo->bias, "0.48");
  EXPECT_EQ(a.monte_carlo->lower, "7.65");
  EXPECT_EQ(a.monte_carlo->upper, "10.64");
  EXPECT_EQ(a.monte_carlo->tolerance, "0.005");
}

TEST(MethodValues, FollowUnitAndDecimalMark) {
  Reported table2 = with_monte_carlo();
  table2.options = {.numbers = {','}, .unit = DisplayUnit::mm};
  const auto all = rows(table2);
  EXPECT_EQ(row(all, "A").value, "0,00959");
  EXPECT_EQ(row(all, "A").monte_carlo->u, "0,00077");
}

TEST(MethodValues, AreOfTheParametersThatExist) {
  Reported single = testing_support::reported_without_metadata();
  single.assessment.evaluation.parameters.A.reset();
  single.assessment.monte_carlo = made_up_monte_carlo(single.assessment.evaluation);
  for (const MethodRow& row : rows(single)) EXPECT_NE(row.parameter->key, "A");
}

TEST(MethodValues, SayHowFarTheSimplifiedMethodIsOff) {
  const Options options;
  EXPECT_EQ(width_words(1.4, 1.0, options), "1.4× wider");
  EXPECT_EQ(width_words(1.0, 1.4, options), "1.4× narrower");
  EXPECT_EQ(width_words(1.0, 1.04, options), "alike");
  EXPECT_EQ(width_words(31.4, 1.0, options), "31× wider");
  EXPECT_EQ(width_words(1e9, 1.0, options), "over 100× wider");
  EXPECT_EQ(width_words(1.0, 0.0, options), "");
  EXPECT_EQ(width_words(0.0, 1.0, options), "");
  EXPECT_EQ(width_words(1.5, 1.0, {.numbers = {','}}), "1,5× wider");
}

TEST(MethodValues, CompareAnnexAWithHalfTheSymmetricInterval) {
  Reported table2 = with_monte_carlo();
  const auto& interval = table2.assessment.monte_carlo->distributions[index("A")]->summary.symmetric;
  const double U = table2.assessment.annex_a->U.A->in_native();
  EXPECT_EQ(row(rows(table2), "A").annex_a_width,
            width_words(U, (interval.upper - interval.lower) / 2.0, table2.options));
}

TEST(MethodValues, CompareAnnexAWithTheGumWhereThereIsNoMonteCarlo) {
  Reported table2 = reported_table2();
  table2.assessment.gum = iso230_2::gum(table2.test, table2.assessment.evaluation).value();
  const auto all = rows(table2);
  const MethodRow& a = row(all, "A");
  EXPECT_FALSE(a.monte_carlo);
  EXPECT_NE(a.annex_a_width, "");
  EXPECT_EQ(a.gum_width, "");
}

TEST(MethodValues, NameTheValuesOutsideTheirInterval) {
  Reported table2 = with_monte_carlo();
  EXPECT_EQ(outside_statement(rows(table2)), "");
  for (std::string_view key : {"R", "R_up"}) {
    auto& d = *table2.assessment.monte_carlo->distributions[index(key)];
    d.high = d.value - 0.01;
  }
  EXPECT_THAT(outside_statement(rows(table2)), ::testing::EndsWith(": R, R↑"));
}

TEST(MethodValues, TellWhatIsNotStable) {
  Reported table2 = with_monte_carlo();
  auto& run = *table2.assessment.monte_carlo;
  EXPECT_THAT(trials_statement(run), HasSubstr("every u is stable"));
  run.stable = false;
  run.distributions[index("R_down")]->summary.stable = false;
  EXPECT_THAT(trials_statement(run), ::testing::EndsWith("not stable within the numerical tolerance: R↓"));
}

TEST(MethodValues, SayWhyNothingIsStatedWhereNothingActs) {
  Reported table2 = with_monte_carlo();
  auto& run = *table2.assessment.monte_carlo;
  for (auto& distribution : run.distributions) distribution.reset();
  EXPECT_EQ(refusal_statement(run), "No interval is stated, since no input of the uncertainty acts on any parameter");
  EXPECT_THAT(trials_statement(run), ::testing::EndsWith(" trials, of which none states an interval"));
}

TEST(MethodValues, GroupTheDigitsOfLargeCounts) {
  EXPECT_EQ(shown_count(999), "999");
  EXPECT_EQ(shown_count(1000), "1\u2009000");
  EXPECT_EQ(shown_count(1'000'000), "1\u2009000\u2009000");
}

TEST(MethodValues, ShowSmallAndNearlyWholeParts) {
  const Options options;
  EXPECT_EQ(shown_percent(0.0, options), "0\u00a0%");
  EXPECT_EQ(shown_percent(0.004, options), "<\u00a01\u00a0%");
  EXPECT_EQ(shown_percent(0.824, options), "82\u00a0%");
  EXPECT_EQ(shown_percent(0.95, options), "95\u00a0%");
  EXPECT_EQ(shown_percent(0.9973, options), "99.7\u00a0%");
  EXPECT_EQ(shown_percent(1.0, options), "100\u00a0%");
}

TEST(Contributions, ShareTheVarianceOfAParameter) {
  const Reported table2 = with_monte_carlo();
  const auto all = contributions(table2.assessment);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].key, "machine_temperature");
  EXPECT_NEAR(share(all, 0, index("A")), 0.64, 1e-12);
  EXPECT_NEAR(share(all, 1, index("R")), 1.0, 1e-12);
}

TEST(Contributions, LeadToTheInputThatItPaysToImprove) {
  const Reported table2 = with_monte_carlo();
  const auto all = contributions(table2.assessment);
  const auto first = leading(all, index("A"), table2.assessment);
  ASSERT_TRUE(first);
  EXPECT_NEAR(first->u_without, 0.6 * first->u, 1e-12);
  EXPECT_EQ(leading_statement(*first, AxisKind::linear, table2.options),
            "Temperature of the machine, less 20 °C, 64\u00a0% of the variance; without it u would fall from 0.77 to "
            "about 0.46\u00a0µm");
  const auto alone = leading(all, index("R"), table2.assessment);
  EXPECT_EQ(leading_statement(*alone, AxisKind::linear, table2.options),
            "Environmental variation of a reading, 100\u00a0% of the variance; u\u00a0=\u00a00.52\u00a0µm");
}

TEST(Contributions, AreNoneWhereNothingContributes) {
  Reported table2 = with_monte_carlo();
  for (auto& c : table2.assessment.monte_carlo->contributions) c.u = {};
  EXPECT_FALSE(leading(contributions(table2.assessment), index("A"), table2.assessment));
}

TEST(Contributions, DropWhatRoundingLeaves) {
  Reported table2 = with_monte_carlo();
  table2.assessment.monte_carlo->contributions[0].u[index("R")] = 1e-14;
  for (const auto& c : contributions(table2.assessment))
    EXPECT_TRUE(c.key != "machine_temperature" || c.u[index("R")] == 0.0);
}

TEST(Contributions, OfTheGumAddUpToItsUncertainty) {
  Reported table2 = reported_table2();
  table2.assessment.gum = iso230_2::gum(table2.test, table2.assessment.evaluation).value();
  double squares = 0.0;
  for (const auto& c : contributions(table2.assessment)) squares += c.u[index("A")] * c.u[index("A")];
  EXPECT_NEAR(std::sqrt(squares), standard_uncertainty(table2.assessment, index("A")), 1e-9);
}

TEST(MainParameters, AreThoseOfTheOnlyDirectionWhereThereIsOne) {
  iso230_2::AxisParameters one;
  one.A_up = one.E_up = one.R_up = Deviation::native(1.0);
  EXPECT_THAT(main_parameters(one), ::testing::ElementsAre(index("A_up"), index("E_up"), index("R_up")));
}

TEST(ShownDistribution, NamesTheNumbersOfEachForm) {
  const auto shown = [](std::string_view text) { return shown_distribution(std::string(text), Options{}); };
  EXPECT_EQ(shown("uniform -0.85 0.85"), "uniform from −0.85 to 0.85");
  EXPECT_EQ(shown("normal 0 0.5"), "normal, mean 0, standard deviation 0.5");
  EXPECT_EQ(shown("t 9 0 1.5"), "t with 9 degrees of freedom, location 0, scale 1.5");
  EXPECT_EQ(shown("ctrap -1 1 0.2"), "uniform from −1 to 1, limits ± 0.2");
  EXPECT_EQ(shown("trapezoidal -1 1 0.5"), "trapezoidal from −1 to 1, top to base 0.5");
  EXPECT_EQ(shown("arcsine -1 1"), "arcsine from −1 to 1");
  EXPECT_EQ(shown("triangular -1 1"), "triangular from −1 to 1");
  EXPECT_EQ(shown("constant 3"), "constant 3");
  EXPECT_EQ(shown("empirical 1 2 3"), "empirical, 3 values");
  EXPECT_EQ(shown("as given by the maker"), "as given by the maker");
}

}  // namespace
}  // namespace axiometry::report
