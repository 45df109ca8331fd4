// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/uncertainty/gradient.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/support/series.h"

namespace axiometry::iso230_2 {
namespace {

using testing_support::none;

std::optional<Deviation>& mean_of(PositionResult& p, Direction d) {
  return d == Direction::up ? p.mean_up : p.mean_down;
}
std::optional<Deviation>& s_of(PositionResult& p, Direction d) { return d == Direction::up ? p.s_up : p.s_down; }

void add(std::optional<Deviation>& x, double step) { x = Deviation::native(x->in_native() + step); }

/// The parameters when x̄_i or s_i of one direction is moved by `step`.
AxisParameters moved(const Evaluation& evaluation, std::size_t i, Direction d, bool mean, double step) {
  std::vector<PositionResult> positions = evaluation.positions;
  PositionResult& p = positions[i];
  add(mean ? mean_of(p, d) : s_of(p, d), step);
  if (p.mean_up && p.mean_down) {
    p.mean = Deviation::native((p.mean_up->in_native() + p.mean_down->in_native()) / 2.0);
    p.reversal = Deviation::native(p.mean_up->in_native() - p.mean_down->in_native());
  }
  p = with_estimators(p, p.s_up, p.s_down);
  return evaluate_axis(positions);
}

/// Every derivative against the difference quotient of evaluate_axis(), which is exact between the kinks.
void expect_derivatives(const Series& series) {
  const Evaluation evaluation = evaluate(series);
  const auto gradients = parameter_gradients(evaluation);
  constexpr double step = 1e-6;
  for (std::size_t k = 0; k < std::size(parameters); ++k) {
    const auto member = parameters[k].member;
    if (!(evaluation.parameters.*member)) {
      EXPECT_TRUE(gradients[k].empty()) << parameters[k].key;
      continue;
    }
    for (std::size_t i = 0; i < evaluation.positions.size(); ++i)
      for (Direction d : {Direction::up, Direction::down})
        for (bool mean : {true, false}) {
          PositionResult p = evaluation.positions[i];
          if (!(mean ? mean_of(p, d) : s_of(p, d))) continue;
          const double after = (moved(evaluation, i, d, mean, step).*member)->in_native();
          const double quotient = (after - (evaluation.parameters.*member)->in_native()) / step;
          double derivative = 0.0;
          ASSERT_EQ(gradients[k].size(), 1u) << parameters[k].key << ": nothing is tied";
          for (const CellTerm& term : gradients[k].front())
            if (term.target == i && term.direction == d) derivative += mean ? term.by_mean : term.by_s;
          EXPECT_NEAR(derivative, quotient, 1e-6) << parameters[k].key << " target " << i << (mean ? " mean" : " s");
        }
  }
}

TEST(ParameterGradients, AreTheDerivativesOfTheEvaluation) {
  // Table 2 itself has two means that are equal but for rounding, where the derivative is not the quotient.
  auto table2_down = testing_support::table2::down;
  table2_down[0][1] = 3.8;
  expect_derivatives(
      testing_support::make_series(testing_support::table2::targets, testing_support::table2::up, table2_down));
  std::mt19937 random(230);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 30; ++trial) {
    std::vector<std::vector<double>> up(3, std::vector<double>(5));
    std::vector<std::vector<double>> down(3, std::vector<double>(5));
    for (auto* runs : {&up, &down})
      for (auto& run : *runs)
        for (double& x : run) x = normal(random) + (trial % 2 && random() % 4 == 0 ? none : 0.0);
    up[0][0] = 1.0;
    for (double& x : down[1]) x = 1.5 + normal(random);
    expect_derivatives(testing_support::make_series({0, 1, 2, 3, 4}, up, trial % 5 ? down : decltype(down){}));
  }
}

TEST(ParameterGradients, OfAnAxisThatIsExtremeAtOneTargetHoldTheMeanNoMore) {
  // ↑ alone: at the second target s is so large that both boundaries of A↑ lie there.
  const auto series = testing_support::make_series({0, 10}, {{0, -9}, {0, 9}}, {});
  const auto gradients = parameter_gradients(evaluate(series));
  ASSERT_EQ(gradients[1].size(), 1u);
  ASSERT_EQ(gradients[1][0].size(), 1u);
  EXPECT_EQ(gradients[1][0][0].by_mean, 0.0);
  EXPECT_EQ(gradients[1][0][0].by_s, 4.0);
}

TEST(ParameterGradients, OfTargetsThatShareAnExtremeAreOneEach) {
  // 0.1 + 0.2 is not 0.3 in binary: both means of ↑ are 0.3.
  const auto series = testing_support::make_series({0, 10, 20}, {{0.1, 0.3, -1}, {0.5, 0.3, -1}}, {});
  const auto gradients = parameter_gradients(evaluate(series));
  const std::size_t E_up = static_cast<std::size_t>(find_parameter("E_up") - parameters);
  ASSERT_EQ(gradients[E_up].size(), 2u);
  EXPECT_EQ(gradients[E_up][0][0].target, 0u);
  EXPECT_EQ(gradients[E_up][1][0].target, 1u);
}

TEST(ParameterGradients, AreFewHoweverManyTargetsShareAnExtreme) {
  const std::vector<double> flat(200, 0.0);
  std::vector<double> targets;
  for (int i = 0; i < 200; ++i) targets.push_back(i);
  const auto gradients =
      parameter_gradients(evaluate(testing_support::make_series(targets, {flat, flat}, {flat, flat})));
  for (const auto& tied : gradients) EXPECT_LE(tied.size(), 256u);
}

TEST(TieBound, IsFarBelowTheLastDigitOfDataAndAboveTheirRounding) {
  const double bound = tie_bound(evaluate(testing_support::table2::series()));
  EXPECT_LT(bound, 1e-6);
  EXPECT_GT(bound, 1e-10);
}

}  // namespace
}  // namespace axiometry::iso230_2
