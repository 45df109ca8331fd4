// SPDX-License-Identifier: Apache-2.0
#include "axiometry/compensation/prediction.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <optional>
#include <vector>

#include "axiometry/compensation/fit.h"
#include "axiometry/compensation/retest_findings.h"
#include "axiometry/compensation/suspicions.h"
#include "axiometry/standards/iso230_2/parameters.h"
#include "tests/support/series.h"

namespace axiometry::compensation {
namespace {

using testing::Contains;
using testing::Field;
using testing::HasSubstr;
using testing_support::make_series;

const std::vector<double> targets{0, 100, 200, 300, 400};

Series before() {
  return make_series(targets, {{0, 9, 15, 22, 30}, {0.2, 9.2, 14.8, 22.4, 30}},
                     {{-4, 5, 11, 18, 26}, {-4, 5.4, 11, 18, 26.2}});
}

AxisCorrection table() {
  return fit_correction(before(), AxisKind::linear, {.nodes = targets, .curves = TableCurves::each_way})->correction;
}

/// The re-test with this share of the table active, and a new zero of the instrument.
Series with_share(double share) {
  AxisCorrection c = table();
  std::vector<double> up = c.values(Direction::up), down = c.values(Direction::down);
  for (double& x : up) x = share * x + 3.0;
  for (double& x : down) x = share * x + 3.0;
  return *corrected_series(before(), *AxisCorrection::make(AxisKind::linear, targets, up, down));
}

TEST(EffectOfTable, TellsHowMuchOfItIsActive) {
  for (const double share : {1.0, 0.0, -1.0, 2.0, 0.5}) {
    const auto effect = effect_of_table(before(), with_share(share), table(), nullptr, 1e-3);
    ASSERT_TRUE(effect);
    EXPECT_NEAR(effect->whole.share, share, 1e-9);
    EXPECT_EQ(effect->compared, 10u);
  }
}

TEST(FindingOfRetest, NamesASignMistake) {
  const auto id_of = [](double share) {
    return finding_of_retest(*effect_of_table(before(), with_share(share), table(), nullptr, 1e-3)).id;
  };
  EXPECT_EQ(id_of(1.0), "retest-as-predicted");
  EXPECT_EQ(id_of(-1.0), "retest-sign");
  EXPECT_EQ(id_of(0.0), "retest-not-active");
  EXPECT_EQ(id_of(2.0), "retest-twice");
  EXPECT_EQ(id_of(0.5), "retest-otherwise");
}

TEST(FindingOfRetest, NamesDirectionsThatAreExchanged) {
  const AxisCorrection c = table();
  const AxisCorrection exchanged =
      *AxisCorrection::make(AxisKind::linear, c.positions(), c.values(Direction::down), c.values(Direction::up));
  const auto effect = effect_of_table(before(), *corrected_series(before(), exchanged), c, nullptr, 1e-3);
  EXPECT_EQ(finding_of_retest(*effect).id, "retest-directions");
}

TEST(FindingOfRetest, NamesABacklashBesideTheTable) {
  const AxisCorrection c = table();
  std::vector<double> down = c.values(Direction::down);
  for (double& x : down) x += 4.0;
  const AxisCorrection twice = *AxisCorrection::make(AxisKind::linear, c.positions(), c.values(Direction::up), down);
  const auto effect = effect_of_table(before(), *corrected_series(before(), twice), c, nullptr, 1e-3);
  EXPECT_EQ(finding_of_retest(*effect).id, "retest-reversal-twice");
}

/// What a re-test is called in which the control added `acting`, with an axis that is otherwise the same but for a
/// little.
std::string id_of_retest(const AxisCorrection& acting, const RetestContext& context = {}) {
  std::size_t k = 0;
  const auto after = shifted_series(*corrected_series(before(), acting),
                                    [&](double, Direction) { return 0.05 * static_cast<double>((3 * k++) % 4) + 1.0; });
  return finding_of_retest(*effect_of_table(before(), *after, table(), nullptr, 1e-3), context).id;
}

AxisCorrection acting(const std::vector<double>& up, const std::vector<double>& down) {
  return *AxisCorrection::make(AxisKind::linear, targets, up, down);
}

TEST(FindingOfRetest, CallsNothingWhatItShouldBeThatIsNot) {
  const AxisCorrection c = table();
  const std::vector<double>&up = c.values(Direction::up), &down = c.values(Direction::down), none(up.size(), 0.0);
  const auto scaled = [](std::vector<double> values, double by) {
    for (double& x : values) x *= by;
    return values;
  };
  EXPECT_EQ(id_of_retest(c), "retest-as-predicted");
  EXPECT_EQ(id_of_retest(c, {.above_expected = true}), "retest-more-left");
  EXPECT_EQ(id_of_retest(acting(scaled(up, 0.9), scaled(down, 0.9))), "retest-as-predicted")
      << "what changes from one day to the next, and leaves no more than was expected";
  EXPECT_EQ(id_of_retest(acting(scaled(up, 0.9), scaled(down, 0.9)), {.above_expected = true}), "retest-otherwise");
  EXPECT_EQ(id_of_retest(acting(scaled(up, 0.8), scaled(down, 0.8))), "retest-otherwise");
  EXPECT_EQ(id_of_retest(acting(scaled(up, 1.2), scaled(down, 1.2))), "retest-otherwise");
  EXPECT_EQ(id_of_retest(acting(up, none)), "retest-one-direction");
  EXPECT_EQ(id_of_retest(acting(none, down)), "retest-one-direction");
  EXPECT_EQ(id_of_retest(acting(down, up)), "retest-directions");
  EXPECT_EQ(id_of_retest(acting(none, none)), "retest-not-active");
  EXPECT_EQ(id_of_retest(acting({0, 14, -14, 14, -14}, {9, -9, 9, -9, 9})), "retest-unexplained")
      << "a table that is not active changes nothing";
}

/// Of the same axis, measured again at these of its targets alone.
Series part_of(const Series& whole, const std::vector<std::size_t>& places) {
  std::vector<Position> positions;
  std::vector<double> readings;
  for (const std::size_t i : places) positions.push_back(whole.targets()[i]);
  for (const Direction d : {Direction::up, Direction::down})
    for (const std::size_t i : places)
      readings.insert(readings.end(), whole.cell(i, d).begin(), whole.cell(i, d).end());
  return *Series::make_dense(std::move(positions), whole.run_count(), std::move(readings));
}

TEST(FindingOfRetest, SaysOfWhichPartOfTheTableItTells) {
  const auto effect_of = [](const std::vector<std::size_t>& places) {
    return effect_of_table(before(), part_of(with_share(1.0), places), table(), nullptr, 1e-3);
  };
  EXPECT_FALSE(effect_of({0, 1})) << "two targets, from both sides";
  const auto part = effect_of({0, 1, 2});
  ASSERT_TRUE(part);
  const auto told = finding_of_part(*part, before(), AxisKind::linear);
  ASSERT_TRUE(told);
  EXPECT_EQ(
      told->message,
      "found 3 of the 5 targets of the test in the re-test, from 0 mm to 200 mm: of the rest of the table it tells "
      "nothing");
  EXPECT_THAT(finding_of_retest(*part, {.is_part = true}).message, HasSubstr("where it was measured again"));
  EXPECT_TRUE(finding_of_part(*effect_of({1, 2, 3}), before(), AxisKind::linear));
  EXPECT_FALSE(finding_of_part(*effect_of({0, 2, 4}), before(), AxisKind::linear));
}

TEST(FindingOfRetest, DoesNotSayThatNoMoreIsLeftWhereALittleMoreIs) {
  const AxisCorrection c = table();
  std::vector<double> up = c.values(Direction::up), down = c.values(Direction::down);
  for (auto* values : {&up, &down})
    for (double& x : *values) x *= 0.9;
  EXPECT_EQ(id_of_retest(acting(up, down), {.above_95 = true}), "retest-little-more-left");
}

TEST(FindingOfRetest, CallsAReversalThatChangedNoPrediction) {
  // One curve for both directions, which leaves the reversal as it is; in the re-test it is another one.
  const std::vector<double> curve{2, -7, -13, -20, -28};
  std::vector<double> turned = curve;
  for (double& x : turned) x += 12.0;
  const AxisCorrection made = acting(curve, curve);
  const auto id_of = [&](const std::vector<double>& down) {
    return finding_of_retest(
               *effect_of_table(before(), *corrected_series(before(), acting(curve, down)), made, nullptr, 1e-3))
        .id;
  };
  EXPECT_EQ(id_of(curve), "retest-as-predicted");
  EXPECT_EQ(id_of(turned), "retest-unexplained");
}

TEST(FindingOfRetest, CallsAReversalOfWhichItKnowsTooLittleNoPrediction) {
  const auto id_of = [](std::optional<double> reversal, double u) {
    return finding_of_retest({.whole = {1.0, 0.01, 1.0, true, false},
                              .of_reversal = reversal,
                              .u_of_reversal = u,
                              .has_reversal = true})
        .id;
  };
  EXPECT_EQ(id_of(0.15, 0.2), "retest-reversal-not-active");
  EXPECT_EQ(id_of(1.9, 0.2), "retest-reversal-twice");
  EXPECT_EQ(id_of(1.0, 0.2), "retest-as-predicted");
  EXPECT_EQ(id_of(0.5, 0.2), "retest-reversal-untold") << "as near to nothing as to what it should be";
  EXPECT_EQ(id_of(1.0, 0.5), "retest-reversal-untold");
  EXPECT_EQ(id_of(std::nullopt, 0.0), "retest-reversal-untold");
}

TEST(FindingOfRetest, DoesNotVouchForAReversalThatTheReTestHasNoApproachesFor) {
  const std::vector<std::vector<double>> none(2, std::vector<double>(5, std::numeric_limits<double>::quiet_NaN()));
  const Series once = make_series(targets, {{2, 2, 2, 2, 2}, {2.2, 2.2, 1.8, 2.4, 2}}, none);
  EXPECT_EQ(finding_of_retest(*effect_of_table(before(), once, table(), nullptr, 1e-3)).id, "retest-reversal-untold");
}

TEST(FindingOfRetest, NamesMirroredPositionsWhereTheyExplainTheChange) {
  const std::vector<double> bent{0, -20, -24, -26, -27}, mirrored{-27, -26, -24, -20, 0};
  const Series first = make_series(targets, {{0, 20, 24, 26, 27}, {0.1, 20, 24.1, 26, 27}},
                                   {{0, 20.1, 24, 26, 27}, {0, 20, 24, 26.1, 27}});
  const AxisCorrection made = acting(bent, bent);
  const auto named = [&](const std::vector<double>& values) {
    return finding_of_retest(
               *effect_of_table(first, *corrected_series(first, acting(values, values)), made, nullptr, 1e-3))
        .id;
  };
  EXPECT_EQ(named(mirrored), "retest-mirrored");
  EXPECT_EQ(named(bent), "retest-as-predicted");
}

TEST(FindingOfRetest, SaysWhereMirroredPositionsLookLikeASignMistake) {
  const std::vector<double> straight{0, -10, -20, -30, -40}, turned{-40, -30, -20, -10, 0};
  const Series first = make_series(targets, {{0, 10, 20, 30, 40}, {0.1, 10, 20.1, 30, 40}},
                                   {{0, 10.1, 20, 30, 40}, {0, 10, 20, 30.1, 40}});
  const AxisCorrection made = acting(straight, straight);
  const auto effect = effect_of_table(first, *corrected_series(first, acting(turned, turned)), made, nullptr, 1e-3);
  const NamedFinding found = finding_of_retest(*effect);
  EXPECT_EQ(found.id, "retest-sign");
  EXPECT_THAT(found.message, HasSubstr("positions mirrored"));
}

TEST(EffectOfTable, TellsNothingOfOtherTargets) {
  const Series other = make_series({50, 150, 250}, {{1, 2, 3}}, {{1, 2, 3}});
  EXPECT_FALSE(effect_of_table(before(), other, table(), nullptr, 1e-3));
}

TEST(ScatterAlone, IsKnownOfWhatWasRepeated) {
  EXPECT_TRUE(tells_scatter(before()));
  EXPECT_FALSE(tells_scatter(make_series({0, 100}, {{0, 9}}, {{-4, 5}})));
  EXPECT_TRUE(tells_scatter(make_series({0, 100}, {{0, 9}, {testing_support::none, 9}}, {})));
}

TEST(ScatterAlone, HasNoSystematicErrorLeft) {
  const auto parameters = iso230_2::evaluate(*scatter_alone(before())).parameters;
  EXPECT_NEAR(parameters.E->in_native(), 0.0, 1e-12);
  EXPECT_NEAR(parameters.R_up->in_native(), iso230_2::evaluate(before()).parameters.R_up->in_native(), 1e-12);
}

TEST(CheckPlausible, RefusesWhatNoAxisDoes) {
  const auto fault_of = [](double per_mm) {
    std::vector<double> run;
    for (const double x : targets) run.push_back(per_mm * 1000.0 * x);
    return check_plausible(make_series(targets, {run}, {run}), AxisKind::linear).error().message;
  };
  EXPECT_TRUE(check_plausible(before(), AxisKind::linear));
  EXPECT_THAT(fault_of(-2.0), HasSubstr("against the axis"));
  EXPECT_THAT(fault_of(24.4), HasSubstr("targets are in inches"));
  EXPECT_THAT(fault_of(1.0 / 25.4 - 1.0), HasSubstr("readings in inches"));
  EXPECT_THAT(fault_of(-1.0), HasSubstr("did not see the axis move"));
  EXPECT_THAT(fault_of(0.3), HasSubstr("no deviations"));
}

TEST(FindingsOfReadings, TellsAnOutlierWithWhatItDoesToTheTable) {
  std::vector<testing_support::RunDeviations> up, down;
  for (int j = 0; j < 5; ++j) {
    up.push_back({0.1 * j, 9.0 - 0.2 * j, 15 + 0.1 * (j % 3), 22 - 0.1 * j, 30 + 0.15 * (j % 2)});
    down.push_back({-4 + 0.1 * (j % 2), 5 - 0.1 * j, 11 + 0.2 * (j % 3), 18 + 0.1 * j, 26 - 0.1 * j});
  }
  up[2][1] += 25.0;
  const auto findings = findings_of_readings(make_series(targets, up, down), AxisKind::linear, TableCurves::each_way);
  EXPECT_THAT(findings, Contains(Field(&NamedFinding::id, "compensation-outlier")));
}

TEST(FindingsOfReadings, TellsWhatOneApproachAndFewTargetsDoNotTell) {
  const auto ids = [](const std::vector<double>& places, std::vector<testing_support::RunDeviations> runs) {
    std::vector<std::string> found;
    for (const NamedFinding& f :
         findings_of_readings(make_series(places, runs, runs), AxisKind::linear, TableCurves::each_way)) {
      EXPECT_FALSE(f.serious) << f.message;
      found.push_back(f.id);
    }
    return found;
  };
  EXPECT_THAT(ids({0, 110, 190, 310, 400}, {{0, 1, 2, 3, 4}}), ::testing::ElementsAre("compensation-one-approach"));
  EXPECT_THAT(ids({0, 400}, {{0, 4}, {0.1, 4}}), ::testing::ElementsAre("compensation-few-targets"));
  EXPECT_THAT(ids({0, 110, 190, 310, 400}, {{0, 1, 2, 3, 4}, {0.1, 1, 2.1, 3, 4}}), ::testing::IsEmpty());
}

TEST(FindingsOfReadings, TellsATurnThatDoesNotClose) {
  const Series open = make_series({0, 90, 180, 270, 360}, {{0, 1, 2, 1, 5}, {0.1, 1, 2, 1, 5.1}, {0, 1, 2, 1.1, 5}},
                                  {{0, 1, 2, 1, 5}, {0, 1, 2.1, 1, 5}, {0.1, 1, 2, 1, 5.1}});
  EXPECT_THAT(findings_of_readings(open, AxisKind::rotary, TableCurves::each_way),
              Contains(Field(&NamedFinding::id, "compensation-turn-not-closed")));
}

}  // namespace
}  // namespace axiometry::compensation
