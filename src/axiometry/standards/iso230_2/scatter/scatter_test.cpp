// SPDX-License-Identifier: Apache-2.0
//
// Figures of Table 2 computed by another program; error rates by simulation from a seed.
#include "axiometry/standards/iso230_2/scatter/scatter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "axiometry/numeric/moments.h"
#include "axiometry/standards/iso230_2/assessment/assessment.h"
#include "axiometry/standards/iso230_2/scatter/outliers.h"
#include "tests/support/series.h"
#include "tests/support/statistics_of_trials.h"

namespace axiometry::iso230_2 {
namespace {

using testing_support::make_series;
using testing_support::none;
using testing_support::RunDeviations;
namespace table2 = testing_support::table2;

/// Reproducible on every standard library.
class Normal {
 public:
  explicit Normal(unsigned seed) : bits_(seed) {}
  double operator()() {
    const double u = (static_cast<double>(bits_()) + 1.0) / 4294967297.0;
    const double v = static_cast<double>(bits_()) / 4294967296.0;
    return std::sqrt(-2.0 * std::log(u)) * std::cos(2.0 * std::numbers::pi * v);
  }

 private:
  std::mt19937 bits_;
};

std::vector<double> targets(std::size_t m) {
  std::vector<double> all;
  for (std::size_t i = 0; i < m; ++i) all.push_back(static_cast<double>(100 * i + 7 * (i % 3)));
  return all;
}

struct Runs {
  std::vector<RunDeviations> up, down;
};

/// s = 1, a curve, a reversal error of 3; rounded to `step` where there is one.
Runs clean(std::size_t m, std::size_t n, Normal& normal, double step = 0.0) {
  Runs runs{std::vector<RunDeviations>(n, RunDeviations(m)), std::vector<RunDeviations>(n, RunDeviations(m))};
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = 0; i < m; ++i)
      for (bool is_up : {true, false}) {
        double x = 4.0 * std::sin(static_cast<double>(i)) + (is_up ? 3.0 : 0.0) + normal();
        if (step > 0.0) x = std::round(x / step) * step;
        (is_up ? runs.up : runs.down)[j][i] = x;
      }
  return runs;
}

Series made(const Runs& runs) { return make_series(targets(runs.up.front().size()), runs.up, runs.down); }

bool speaks(const ScatterStudy& study) {
  return !study.outliers.empty() || study.uneven || study.shifts || study.tilts;
}

double rate(std::size_t m, std::size_t n, double step, int tests) {
  Normal normal(static_cast<unsigned>(m * 100 + n));
  int found = 0;
  for (int k = 0; k < tests; ++k) found += speaks(scatter_study(made(clean(m, n, normal, step)))) ? 1 : 0;
  return static_cast<double>(found) / tests;
}

TEST(Scatter, KnowsWhatAllReadingsAreMultiplesOf) {
  const auto step = [](double a, double b, double c) { return step_of(make_series({0, 10}, {{a, b}}, {{c, none}})); };
  EXPECT_DOUBLE_EQ(step(-0.3, 0.6, 1.2), 0.3);
  EXPECT_DOUBLE_EQ(step(-4.0, 2.0, 6.0), 2.0);
  EXPECT_DOUBLE_EQ(step(0.5, -1.5, 2.0), 0.5);
  EXPECT_DOUBLE_EQ(step(0.1 + 0.2, 0.1, -0.7), 0.1) << "0.30000000000000004";
  EXPECT_DOUBLE_EQ(step(0.0002, -0.0004, 123.4567), 0.0001);
  EXPECT_EQ(step(1.0 / 3, 1.0, 2.0), 0.0) << "finer than anything that is rounded to";
  EXPECT_EQ(step(0.0, 0.0, 0.0), 0.0);
  EXPECT_DOUBLE_EQ(step(-9e8, 3e8, 6e8), 3e8);
}

// Of a target whose scatter grows: not before it is beyond the level, and then always.
TEST(Scatter, FindsUnevenScatterAtItsLevel) {
  Normal normal(11);
  int found = 0, looked = 0;
  for (double factor : {1.0, 2.0, 3.0, 4.0, 6.0})
    for (int k = 0; k < 40; ++k) {
      Runs runs = clean(7, 5, normal);
      for (RunDeviations& run : runs.up) run[3] *= factor;
      const ScatterStudy study = scatter_study(made(runs));
      ++looked;
      if (!study.uneven) continue;
      ++found;
      EXPECT_LE(study.uneven->p, uneven_level);
      EXPECT_GE(study.uneven->within.in_native(), 1.5 * study.uneven->elsewhere.in_native());
    }
  EXPECT_GT(found, 40);
  EXPECT_LT(found, looked - 40);
}

TEST(Scatter, IsSilentInCleanTestsButForOneOfNinety) {
  AXIOMETRY_STATISTICS_OF_TRIALS();
  struct Shape {
    std::size_t m, n;
  };
  for (const auto& [m, n] : {Shape{5, 5}, {11, 5}, {9, 3}, {8, 10}, {3, 5}, {30, 5}, {5, 2}})
    EXPECT_LE(rate(m, n, 0.0, 2000), 0.011 + 3 * std::sqrt(0.011 * 0.989 / 2000)) << m << " targets, " << n << " runs";
}

TEST(Scatter, IsSilentWhereReadingsAreRounded) {
  for (double step : {0.1, 1.0, 3.0, 10.0}) EXPECT_LE(rate(11, 5, step, 1000), 0.019) << "step " << step;
}

TEST(Scatter, FindsAnOutlierAndWhereItIs) {
  Normal normal(7);
  int found = 0, else_found = 0, uneven = 0;
  for (int k = 0; k < 100; ++k) {
    Runs runs = clean(9, 5, normal);
    runs.down[3][4] += 8.0;
    const ScatterStudy study = scatter_study(made(runs));
    for (const OutlyingReading& o : study.outliers) {
      const bool it = o.target == 4 && o.direction == Direction::down && o.run == 3;
      (it ? found : else_found) += 1;
      if (it) EXPECT_NEAR(o.distance.in_native(), 8.0, 5.0);
    }
    uneven += study.uneven ? 1 : 0;
  }
  EXPECT_LE(uneven, 2) << "one cause, one finding";
  EXPECT_GE(found, 95);
  EXPECT_LE(else_found, 2);
}

// Most cells are passed over by the tails of the normal law, before those of Student's t are computed.
TEST(Scatter, PassesOverNoCellWhoseChanceIsWithinTheLevel) {
  Normal normal(11);
  for (const std::size_t n : {3u, 5u, 30u, 5000u})
    for (const double step : {0.0, 0.1}) {
      std::vector<double> table(8 * n);
      for (double& x : table) x = normal();
      table[3] += 10.0;
      const numeric::AdditiveFit fit = numeric::fit_additive(table, n);
      const std::vector<scatter::Candidate> all = scatter::cell_outliers(fit, {step}, 16.0, 1e9);
      ASSERT_EQ(all.size(), 8u);
      for (const scatter::Candidate& c : all) {
        const auto at_level = scatter::cell_outliers(fit, {step}, 16.0, c.p);
        EXPECT_TRUE(std::ranges::any_of(at_level, [&](const auto& o) { return o.at.row == c.at.row && o.p == c.p; }))
            << n << ' ' << step << ' ' << c.p;
        EXPECT_TRUE(std::ranges::none_of(scatter::cell_outliers(fit, {step}, 16.0, 0.9 * c.p),
                                         [&](const auto& o) { return o.at.row == c.at.row; }));
      }
    }
}

TEST(Scatter, FindsTwoOutliersThatHideEachOther) {
  Normal normal(8);
  int found = 0;
  for (int k = 0; k < 100; ++k) {
    Runs runs = clean(9, 5, normal);
    runs.up[1][2] -= 12.0;
    runs.up[4][7] += 11.0;
    found += scatter_study(made(runs)).outliers.size() == 2 ? 1 : 0;
  }
  EXPECT_GE(found, 95);
}

TEST(Scatter, FindsATargetThatScattersAndCallsNoReadingOfItAnOutlier) {
  Normal normal(9);
  int found = 0;
  for (int k = 0; k < 100; ++k) {
    Runs runs = clean(9, 5, normal);
    for (std::size_t j = 0; j < 5; ++j) runs.up[j][6] += 12.0 * normal();
    const ScatterStudy study = scatter_study(made(runs));
    EXPECT_LE(study.outliers.size(), 1u);
    if (study.uneven && study.uneven->first == 6 && study.uneven->last == 6) ++found;
  }
  EXPECT_GE(found, 85);
}

TEST(Scatter, FindsAStretchAndADirection) {
  Normal normal(10);
  Runs runs = clean(10, 5, normal);
  for (auto& run : runs.up)
    for (std::size_t i = 0; i < 4; ++i) run[i] += 8.0 * normal();
  for (auto& run : runs.down)
    for (std::size_t i = 0; i < 4; ++i) run[i] += 8.0 * normal();
  const ScatterStudy stretch = scatter_study(made(runs));
  ASSERT_TRUE(stretch.uneven);
  EXPECT_EQ(stretch.uneven->first, 0u);
  EXPECT_EQ(stretch.uneven->last, 3u);
  EXPECT_FALSE(stretch.uneven->direction);

  runs = clean(10, 5, normal);
  for (auto& run : runs.up)
    for (double& x : run) x += 10.0 * normal();
  const ScatterStudy direction = scatter_study(made(runs));
  ASSERT_TRUE(direction.uneven);
  EXPECT_EQ(direction.uneven->direction, Direction::up);
  EXPECT_EQ(direction.uneven->first, 0u);
  EXPECT_EQ(direction.uneven->last, 9u);
  EXPECT_TRUE(direction.outliers.empty());
}

TEST(Scatter, TellsADriftFromShiftsWithoutOrder) {
  Normal normal(11);
  Runs runs = clean(9, 5, normal);
  for (std::size_t j = 0; j < 5; ++j)
    for (auto* of : {&runs.up, &runs.down})
      for (double& x : (*of)[j]) x -= 3.0 * static_cast<double>(j);
  const ScatterStudy drift = scatter_study(made(runs));
  ASSERT_TRUE(drift.shifts);
  EXPECT_TRUE(drift.shifts->ordered);
  EXPECT_NEAR(drift.shifts->drift.in_native(), -12.0, 1.5);
  EXPECT_TRUE(drift.outliers.empty());
  EXPECT_FALSE(drift.uneven);

  runs = clean(9, 5, normal);
  for (auto* of : {&runs.up, &runs.down})
    for (double& x : (*of)[2]) x += 9.0;
  const ScatterStudy shifted = scatter_study(made(runs));
  ASSERT_TRUE(shifted.shifts);
  EXPECT_FALSE(shifted.shifts->ordered);
  EXPECT_EQ(shifted.shifts->run, 2u);
  EXPECT_TRUE(shifted.outliers.empty()) << "a run that lies elsewhere is one thing, not nine";
}

/// Runs with these tilts, of an axis that stays in its place at `still` of its range; ↓ with `against` times the tilt.
Runs with_tilts(const std::vector<double>& tilts, Normal& normal, double still = 0.5, double against = 1.0) {
  Runs runs = clean(11, tilts.size(), normal);
  for (std::size_t j = 0; j < tilts.size(); ++j)
    for (std::size_t i = 0; i < 11; ++i) {
      const double lever = static_cast<double>(i) / 10.0 - still;
      runs.up[j][i] += tilts[j] * lever;
      runs.down[j][i] += against * tilts[j] * lever;
    }
  return runs;
}

TEST(Scatter, TellsSlopesOfRunsAsOneThing) {
  Normal normal(17);
  for (const double still : {0.5, 0.0}) {
    const Series series = made(with_tilts({-2, -2, -2, 8, -2}, normal, still));
    const ScatterStudy study = scatter_study(series);
    ASSERT_TRUE(study.tilts) << still;
    EXPECT_EQ(study.tilts->farthest, (std::array<std::optional<std::size_t>, 2>{3, 3}));
    EXPECT_EQ(study.tilts->runs, 5u);
    EXPECT_NEAR(study.tilts->farthest_tilt, 8.0, 1.5);
    EXPECT_NEAR(study.tilts->between(), std::sqrt((64.0 + 4.0 * 4.0) / 4.0), 1.0);
    EXPECT_NEAR(study.tilts->u_of_mean(), study.tilts->between() / std::sqrt(5.0), 1e-12);
    EXPECT_NEAR(study.tilts->within, 1.0, 0.2);
    EXPECT_LT(study.tilts->p, 1e-6);
    EXPECT_FALSE(study.uneven) << "ends that scatter more are the slopes";
    EXPECT_TRUE(study.outliers.empty());
    EXPECT_EQ(study.shifts.has_value(), still == 0.0);
    EXPECT_FALSE(scatter_study(without_tilts(series)).tilts);
  }
}

// It bends the slope of its run too.
TEST(Scatter, FindsAnOutlierAtTheEndOfRunsWithSlopes) {
  Normal normal(20);
  int found = 0, uneven = 0;
  for (int k = 0; k < 50; ++k) {
    Runs runs = with_tilts({-5, 4, 0, 6, -5}, normal);
    runs.down[2][10] += 25.0;
    const ScatterStudy study = scatter_study(made(runs));
    found += study.outliers.size() == 1 && study.outliers.front().target == 10 ? 1 : 0;
    uneven += study.uneven ? 1 : 0;
  }
  EXPECT_GE(found, 47);
  EXPECT_LE(uneven, 2);
}

TEST(Scatter, CountsSlopesOfOneDirectionAloneWhereAnIntervalRestsOnThem) {
  Normal normal(21);
  const TiltStudy study = tilt_study(made(with_tilts({-6, 5, 0, 4, -3}, normal, 0.5, 0.0)));
  EXPECT_TRUE(counts(study));
  EXPECT_LT(study.p_of_each, 1e-4);
  const auto& [up, down] = direction_tilts(made(with_tilts({-6, 5, 0, 4, -3}, normal, 0.5, 0.0)));
  EXPECT_GT(numeric::moments(up).standard_deviation, 3.0);
  EXPECT_LT(numeric::moments(down).standard_deviation, 2.0);
}

// What a drift within the runs does, forth and back: no slope that the mean of both directions has.
TEST(Scatter, TellsNoSlopesThatBothDirectionsHaveAgainstEachOther) {
  Normal normal(18);
  EXPECT_FALSE(scatter_study(made(with_tilts({-4, 3, 5, -6, 2}, normal, 0.5, -1.0))).tilts);
}

TEST(Scatter, TellsSlopesOfOneDirectionOfTwoRunsAndOfRunsWithNumbersOfTheirOwn) {
  Normal normal(19);
  Runs runs = with_tilts({-6, 6, 0, 4, -4}, normal);
  const TiltStudy both = tilt_study(made(runs));
  const std::vector<RunDeviations> no_run(5, RunDeviations(11, none));
  const ScatterStudy up = scatter_study(make_series(targets(11), runs.up, no_run));
  ASSERT_TRUE(up.tilts);
  EXPECT_EQ(up.tilts->runs, 5u);
  EXPECT_TRUE(up.tilts->farthest[0]);
  EXPECT_FALSE(up.tilts->farthest[1]);
  EXPECT_NEAR(up.tilts->of_scatter_each, up.tilts->of_scatter, 1e-12);
  EXPECT_NEAR(both.of_scatter_each, 2.0 * both.of_scatter, 1e-12);
  Runs short_run = runs;  // the first one has too few targets of its own
  for (std::size_t i = 2; i < 11; ++i) short_run.down[0][i] = none;
  const TiltStudy lacking = tilt_study(made(short_run));
  EXPECT_NEAR(lacking.of_scatter_each / both.of_scatter_each, 1.0, 0.25);

  std::vector<RunDeviations> up_apart, down_apart;  // ↑ has the numbers 1, 3, 5…, ↓ 2, 4, 6…
  for (std::size_t j = 0; j < 5; ++j) {
    up_apart.insert(up_apart.end(), {runs.up[j], RunDeviations(11, none)});
    down_apart.insert(down_apart.end(), {RunDeviations(11, none), runs.down[j]});
  }
  const TiltStudy apart = tilt_study(make_series(targets(11), up_apart, down_apart));
  EXPECT_EQ(apart.runs, 5u);
  EXPECT_NEAR(apart.variance, both.variance, 1e-9);
  EXPECT_NEAR(apart.p, both.p, 1e-9);
  EXPECT_EQ(*apart.farthest[0] / 2, *both.farthest[0]);
  EXPECT_EQ(*apart.farthest[1], *apart.farthest[0] + 1);

  const TiltStudy two = tilt_study(made(with_tilts({-20, 20}, normal)));
  EXPECT_EQ(two.degrees(), 1.0);
  EXPECT_LT(two.p, 1e-6);
  const TiltStudy of_two_targets = tilt_study(make_series({0, 100}, {{1, 2}, {3, 5}, {2, 7}}, {}));
  EXPECT_EQ(of_two_targets.runs, 0u);
  EXPECT_EQ(of_two_targets.p, 1.0);
}

// Of readings without scatter nothing is left, whatever targets a run has.
TEST(Scatter, TakesSlopesOutOfRunsThatLackTargets) {
  std::vector<RunDeviations> up(4, RunDeviations(11, 0.0));
  const std::vector<double> places = targets(11);
  for (std::size_t j = 0; j < 4; ++j)
    for (std::size_t i = 0; i < 11; ++i)
      up[j][i] = j == 3 && i > 5 ? none : (static_cast<double>(j) - 1.0) * places[i] / 100.0;
  const Series left =
      without_shifts(without_tilts(make_series(places, up, std::vector<RunDeviations>(4, RunDeviations(11, none)))));
  for (std::size_t i = 0; i < 11; ++i)
    EXPECT_LT(numeric::moments(left.cell(i, Direction::up)).standard_deviation, 0.3) << i;
}

// Computed by another program (numpy, scipy): F = 19.09 of 4 and 72 degrees of freedom.
TEST(Scatter, OfTableTwoHasSlopesToo) {
  const ScatterStudy study = scatter_study(table2::series());
  ASSERT_TRUE(study.tilts);
  EXPECT_NEAR(study.tilts->p, 9.695851474075494e-11, 1e-15);
  EXPECT_NEAR(study.tilts->within, 0.1281715490156909, 1e-12);
  EXPECT_NEAR(study.tilts->between(), 0.36586152059564947, 1e-9);
  EXPECT_EQ(study.tilts->farthest, (std::array<std::optional<std::size_t>, 2>{2, 2}));
  EXPECT_NEAR(study.tilts->farthest_tilt, -0.47643281, 1e-8);
}

// Table 2: s is 0.18 µm about target and run, and 0.36 µm between runs, which rise and fall again.
TEST(Scatter, OfTableTwoIsThatOfItsRuns) {
  const ScatterStudy study = scatter_study(table2::series());
  EXPECT_TRUE(study.outliers.empty());
  EXPECT_FALSE(study.uneven);
  ASSERT_TRUE(study.shifts);
  EXPECT_FALSE(study.shifts->ordered);
  EXPECT_NEAR(study.shifts->within.in_native(), 0.18, 0.01);
  EXPECT_EQ(study.shifts->run, 3u);
  EXPECT_LT(study.shifts->p, 1e-6);
}

TEST(Scatter, OfReadingsThatAreAllAlikeIsNone) {
  const std::vector<RunDeviations> same(5, RunDeviations{0.1, 0.2, 0.3, 0.4, 0.5});
  EXPECT_FALSE(speaks(scatter_study(make_series(targets(5), same, same))));
  std::vector<RunDeviations> one = same;
  one[2][1] += 0.1;  // one step of the readings: rounding explains it
  EXPECT_FALSE(speaks(scatter_study(make_series(targets(5), one, same))));
  one[2][1] += 5.0;
  EXPECT_EQ(scatter_study(make_series(targets(5), one, same)).outliers.size(), 1u);
}

TEST(Scatter, StandsReadingsThatAreMissing) {
  Normal normal(12);
  Runs runs = clean(7, 5, normal);
  for (std::size_t j = 0; j < 5; ++j) runs.up[j][3] = none;
  runs.up[0][0] = runs.down[4][6] = none;
  runs.down[1][1] += 40.0;
  const ScatterStudy study = scatter_study(made(runs));
  ASSERT_EQ(study.outliers.size(), 1u);
  EXPECT_EQ(study.outliers.front().target, 1u);
  EXPECT_FALSE(speaks(scatter_study(make_series({0, 100}, {{1, none}}, {{none, 2}}))));
}

TEST(Scatter, IsToldWithPlaceAndEffect) {
  Normal normal(13);
  Runs runs = clean(9, 5, normal);
  runs.down[3][4] += 30.0;
  std::string message;
  for (const Finding& finding : assess({{}, made(runs), {}}).findings)
    if (finding.message.starts_with("found an outlier")) {
      message = finding.message;
      ASSERT_EQ(finding.deviations.size(), 4u);
      EXPECT_TRUE(finding.message.substr(finding.deviations[0].at, finding.deviations[0].length).ends_with(" µm"));
    }
  EXPECT_TRUE(message.starts_with("found an outlier at target 5 (407 mm) ↓ run 4: a reading of ")) << message;
  EXPECT_NE(message.find("p < 0.0001"), std::string::npos) << message;
  EXPECT_NE(message.find("without it "), std::string::npos) << message;
}

}  // namespace
}  // namespace axiometry::iso230_2
