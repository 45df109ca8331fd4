// SPDX-License-Identifier: Apache-2.0
#include "axiometry/numeric/spread_posterior.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "axiometry/numeric/moments.h"
#include "axiometry/numeric/random/random.h"
#include "tests/support/statistics_of_trials.h"

namespace axiometry::numeric {
namespace {

std::vector<std::vector<double>> draws(const SpreadPosterior& posterior, std::size_t count) {
  const std::size_t each = posterior.size() + 2;
  std::vector<double> uniforms(count * each), sds(posterior.size());
  fill_uniform({1, 0, 0}, uniforms);
  std::vector<std::vector<double>> found(posterior.size());
  for (std::size_t t = 0; t < count; ++t) {
    const auto own = std::span<const double>(uniforms).subspan(t * each, each);
    posterior.draw({own[0], own[1], own.subspan(2)}, sds);
    for (std::size_t c = 0; c < sds.size(); ++c) found[c].push_back(sds[c]);
  }
  return found;
}

TEST(SpreadPosterior, IsZeroWhereNothingScatters) {
  const std::vector<CellScatter> cells(4, {0.0, 4.0});
  const auto found = draws(SpreadPosterior(cells, 0.0), 10);
  for (const auto& cell : found) EXPECT_EQ(cell[3], 0.0);
}

TEST(SpreadPosterior, IsZeroWhereNothingIsKnown) {
  const std::vector<CellScatter> cells(4, {0.0, 0.0});
  EXPECT_EQ(draws(SpreadPosterior(cells, 0.7), 10)[0][0], 0.0);
}

TEST(SpreadPosterior, IsSureWhereManyCellsAgree) {
  const std::vector<CellScatter> cells(200, {4.0 * 9.0, 4.0});  // s = 3
  const auto found = draws(SpreadPosterior(cells, 0.0), 4000);
  const Moments moment = moments(found[17]);
  EXPECT_NEAR(moment.mean, 3.0, 0.06);
  EXPECT_LT(moment.standard_deviation, 0.15);
}

/// With one cell and a level equally likely in every octave, σ² is ν s²/χ² with ν degrees of freedom.
TEST(SpreadPosterior, OfOneCellIsThatOfTheChiSquareDistribution) {
  const std::vector<CellScatter> cells = {{8.0, 8.0}};  // s = 1
  auto found = draws(SpreadPosterior(cells, 0.0), 40000)[0];
  std::ranges::sort(found);
  EXPECT_NEAR(found[1000], std::sqrt(8.0 / 17.5345), 0.02);   // χ²(0.975; 8)
  EXPECT_NEAR(found[20000], std::sqrt(8.0 / 7.3441), 0.02);   // χ²(0.5; 8)
  EXPECT_NEAR(found[39000], std::sqrt(8.0 / 2.17973), 0.05);  // χ²(0.025; 8)
}

TEST(SpreadPosterior, TakesTheNoiseOutAndStaysAboveZero) {
  const std::vector<CellScatter> cells(22, {4.0 * 2.0, 4.0});  // s² = 2, of which 1 is noise
  const auto found = draws(SpreadPosterior(cells, 1.0), 4000);
  EXPECT_NEAR(moments(found[0]).mean, 1.0, 0.1);
  const std::vector<CellScatter> quiet(22, {4.0 * 0.8, 4.0});  // less than the noise alone
  const auto of_quiet = draws(SpreadPosterior(quiet, 1.0), 1000);
  for (const double sd : of_quiet[5]) EXPECT_GE(sd, 0.0);
  // 3.5e-4 of all draws (of 200 000 by the inverse of each distribution function): more than five once in a million.
  EXPECT_LE(std::ranges::count_if(of_quiet[5], [](double sd) { return sd >= 0.9; }), 5);
}

TEST(SpreadPosterior, SeesCellsThatDiffer) {
  std::vector<CellScatter> cells(22, {4.0 * 1.0, 4.0});
  for (std::size_t c = 0; c < 11; ++c) cells[c].sum_of_squares = 4.0 * 25.0;
  const auto found = draws(SpreadPosterior(cells, 0.0), 4000);
  EXPECT_GT(moments(found[0]).mean, 2.5 * moments(found[21]).mean);
}

/// Mean σ of every cell, over its uniform number, of the hypothesis that a choice picks.
std::vector<double> mean_sds(const SpreadPosterior& posterior, double choice) {
  constexpr std::size_t steps = 20'000;
  std::vector<double> means(posterior.size(), 0.0), sds(posterior.size()), uniforms(posterior.size());
  for (std::size_t k = 0; k < steps; ++k) {
    std::ranges::fill(uniforms, (double(k) + 0.5) / double(steps));
    posterior.draw({choice, 0.5, uniforms}, sds);
    for (std::size_t c = 0; c < sds.size(); ++c) means[c] += sds[c] / double(steps);
  }
  return means;
}

/// Cells that share values against cells one by one: hypotheses are as likely, and every cell has the same σ on
/// average, within what 20 000 steps of its uniform number tell. Cells of other degrees of freedom and cells without
/// any scatter among them; noise that explains nothing, a part, or all.
TEST(SpreadPosterior, IsTheSameWhereManyCellsShareValues) {
  AXIOMETRY_STATISTICS_OF_TRIALS();
  constexpr std::size_t count = 600;
  std::vector<double> z(5 * count);
  fill_normal({8, 0, 0}, z);
  std::vector<CellScatter> cells;
  for (std::size_t c = 0; c < count; ++c) {
    const std::size_t freedom = c % 7 == 0 ? c % 3 : 4;
    double squares = 0.0;
    for (std::size_t k = 0; k < freedom; ++k) squares += z[5 * c + k] * z[5 * c + k] * std::exp(0.6 * z[5 * c + 4]);
    cells.push_back({c % 50 == 1 ? 0.0 : squares, double(freedom)});
  }
  for (double noise : {0.0, 0.6, 1.2}) {
    const SpreadPosterior one_by_one(cells, noise, false), shared(cells, noise, true);
    for (double choice : {0.03, 0.5, 0.99}) {
      const auto expected = mean_sds(one_by_one, choice), found = mean_sds(shared, choice);
      for (std::size_t c = 0; c < count; ++c)
        ASSERT_NEAR(found[c], expected[c], 0.005 * expected[c]) << noise << ' ' << choice << ' ' << c;
    }
  }
}

/// No σ that they have in common is likely, in any of the hypotheses: products of their likelihoods are far below what
/// a double holds.
TEST(SpreadPosterior, IsFoundOfManyCellsThatContradictEachOther) {
  std::vector<CellScatter> cells(60, {500.0, 500.0});
  for (std::size_t c = 0; c < 30; ++c) cells[c].sum_of_squares = 500.0 * 1e-4;
  const auto found = draws(SpreadPosterior(cells, 0.0), 200);
  EXPECT_NEAR(moments(found[0]).mean, 0.0145, 0.006);  // the grid ends at a fiftieth of the pooled s
  EXPECT_NEAR(moments(found[59]).mean, 1.0, 0.05);
}

}  // namespace
}  // namespace axiometry::numeric
