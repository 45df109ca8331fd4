// SPDX-License-Identifier: Apache-2.0
#include "axiometry/compensation/periodic_part.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <regex>
#include <string>
#include <vector>

#include "axiometry/language/language.h"
#include "axiometry/numeric/moments.h"
#include "tests/support/series.h"

namespace axiometry::compensation {
namespace {

constexpr double pitch = 10.0;

double periodic_at(double x) { return 1.5 * std::sin(2.0 * std::numbers::pi * x / pitch + 0.4); }

/// 21 targets over 500 mm, each shifted within a pitch, three runs; a bent axis with a screw's periodic error.
Series bent(double periodic_share) {
  std::vector<double> targets;
  std::vector<testing_support::RunDeviations> up, down;
  for (int i = 0; i < 21; ++i) targets.push_back(25.0 * i + pitch * std::fmod(i * std::numbers::phi, 1.0));
  for (int j = 0; j < 3; ++j) {
    testing_support::RunDeviations run_up, run_down;
    for (int i = 0; i < 21; ++i) {
      const double u = targets[static_cast<std::size_t>(i)] / 500.0;
      const double value = 20.0 * u - 15.0 * u * u + periodic_share * periodic_at(targets[static_cast<std::size_t>(i)]);
      run_up.push_back(value + 0.1 * ((3 * i + 2 * j) % 5));
      run_down.push_back(value - 4.0 + 0.1 * ((2 * i + 3 * j) % 5));
    }
    up.push_back(run_up);
    down.push_back(run_down);
  }
  return testing_support::make_series(targets, up, down);
}

std::vector<std::string> ids_in_german(const std::vector<NamedFinding>& findings) {
  std::vector<std::string> ids;
  for (const NamedFinding& finding : findings) {
    ids.push_back(finding.id);
    EXPECT_TRUE(language::is_known(finding.message, language::Language::german)) << finding.message;
    const std::string german = language::translated(finding.message, language::Language::german, {.decimal_mark = ','});
    EXPECT_FALSE(std::regex_search(german, std::regex("[0-9]\\.[0-9]| and "))) << german;
  }
  return ids;
}

using Ids = std::vector<std::string>;
const std::vector<double> coarse_nodes{0.0, 25.0, 500.0}, fine_nodes{0.0, 4.0, 8.0, 12.0};

TEST(PeriodicPart, IsTakenOutOfTheReadingsAlone) {
  const Series series = bent(1.0);
  const PeriodicPart part = periodic_part(series, pitch);
  ASSERT_TRUE(part.is_significant(Direction::up) && part.is_significant(Direction::down));
  for (const double x : {3.0, 251.7, 499.0}) EXPECT_NEAR(part.at(x, Direction::down), periodic_at(x), 0.15);
  const Series left = without_periodic(series, part).value();
  const Series expected = bent(0.0);
  for (std::size_t i = 0; i < series.target_count(); ++i)
    EXPECT_NEAR(numeric::moments(left.cell(i, Direction::up)).mean,
                numeric::moments(expected.cell(i, Direction::up)).mean, 0.15);
}

TEST(PeriodicPart, OfAnAxisWithoutOneNothingIsLeftOut) {
  const Series series = bent(0.0);
  const PeriodicPart part = periodic_part(series, pitch);
  EXPECT_TRUE(part.is_told());
  EXPECT_FALSE(part.is_significant());
  const Series left = without_periodic(series, part).value();
  for (std::size_t i = 0; i < series.target_count(); ++i)
    EXPECT_EQ(left.cell(i, Direction::up)[0], series.cell(i, Direction::up)[0]);
  EXPECT_EQ(ids_in_german(findings_of_periodic(part, Periodic::leave, coarse_nodes, AxisKind::linear)),
            Ids{"compensation-nothing-periodic"});
  EXPECT_TRUE(findings_of_periodic(part, Periodic::keep, coarse_nodes, AxisKind::linear).empty());
}

TEST(PeriodicPart, OfTargetsThatDoNotTellItIsNotCalledAbsent) {
  const PeriodicPart part = periodic_part(bent(1.0), 400.0);
  EXPECT_FALSE(part.is_told());
  const auto findings = findings_of_periodic(part, Periodic::leave, coarse_nodes, AxisKind::linear);
  EXPECT_EQ(ids_in_german(findings), Ids{"compensation-nothing-periodic"});
  EXPECT_NE(findings[0].message.find("the targets do not tell"), std::string::npos);
}

/// Targets on multiples of a step, not all of them, over 600 mm; a sinusoid of 3 µm.
Series on_steps(double step, double period) {
  std::vector<double> targets, up, down;
  for (int i = 0; step * i <= 600.0; ++i) {
    if (i == 7) continue;
    targets.push_back(step * i);
    up.push_back(3.0 * std::sin(2.0 * std::numbers::pi * step * i / period) + 0.05 * std::fmod(0.7548 * i * i, 1.0));
    down.push_back(up.back() - 4.0);
  }
  return testing_support::make_series(targets, {up}, {down});
}

TEST(PeriodicPart, OfTargetsOnEvenStepsIsNotToldFromAnotherPeriod) {
  for (const double period : {10.0, 60.0}) {
    const PeriodicPart part = periodic_part(on_steps(12.0, period), pitch);
    EXPECT_FALSE(part.is_told());
    EXPECT_FALSE(part.is_significant());
    ASSERT_TRUE(part.ambiguity) << "both pass through the same readings";
    EXPECT_NEAR(part.ambiguity->step, 12.0, 1e-9);
    EXPECT_NEAR(part.ambiguity->other_period, 60.0, 1e-6);
    EXPECT_NEAR(part.ambiguity->amplitude, 3.0, 0.05);
    const auto left = findings_of_periodic(part, Periodic::leave, fine_nodes, AxisKind::linear);
    EXPECT_EQ(ids_in_german(left), Ids{"compensation-nothing-periodic"});
    EXPECT_NE(left[0].message.find("the targets do not tell"), std::string::npos);
    const auto kept = findings_of_periodic(part, Periodic::keep, fine_nodes, AxisKind::linear);
    EXPECT_EQ(ids_in_german(kept), Ids{"compensation-periodic-ambiguous"});
    EXPECT_TRUE(kept[0].serious);
  }
  EXPECT_FALSE(periodic_part(on_steps(12.0, 1e9), pitch).ambiguity) << "nothing is there";
}

TEST(PeriodicPart, OfFineTargetsOnEvenStepsIsTold) {
  const PeriodicPart part = periodic_part(on_steps(3.0, pitch), pitch);
  EXPECT_TRUE(part.is_significant() && !part.ambiguity);
  EXPECT_TRUE(
      findings_of_periodic(periodic_part(on_steps(2.0, pitch), pitch), Periodic::keep, fine_nodes, AxisKind::linear)
          .empty());
}

TEST(PeriodicPart, IsAliasedByATableThatIsCoarserThanHalfThePeriod) {
  const PeriodicPart part = periodic_part(bent(1.0), pitch);
  const auto found = findings_of_periodic(part, Periodic::keep, coarse_nodes, AxisKind::linear);
  EXPECT_EQ(ids_in_german(found), Ids{"compensation-periodic-aliased"});
  EXPECT_TRUE(found[0].serious);
  EXPECT_EQ(ids_in_german(findings_of_periodic(part, Periodic::keep, fine_nodes, AxisKind::linear)),
            Ids{"compensation-periodic-aliased"})
      << "finer positions are filled in from the same targets";
  EXPECT_TRUE(findings_of_periodic(part, Periodic::keep, std::vector{0.0, 500.0}, AxisKind::linear).empty())
      << "a scale factor follows no period";
  for (const auto& nodes : {coarse_nodes, fine_nodes})
    EXPECT_EQ(ids_in_german(findings_of_periodic(part, Periodic::leave, nodes, AxisKind::linear)),
              Ids{"compensation-periodic-left"});
}

}  // namespace
}  // namespace axiometry::compensation
