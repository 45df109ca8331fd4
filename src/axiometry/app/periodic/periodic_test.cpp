// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/periodic/periodic.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "axiometry/numeric/random/random.h"
#include "axiometry/report/periodic.h"
#include "tests/support/series.h"

namespace axiometry::app {
namespace {

constexpr double pitch_mm = 5.0;

/// A screw measured at 41 targets, of this amplitude beside noise of 1 µm.
EvaluatedPeriodic screw(double amplitude_um, std::uint64_t seed, bool pitch_is_known) {
  std::vector<double> targets, noise(41);
  numeric::fill_normal({seed, 3, 0}, noise);
  testing_support::RunDeviations run;
  for (std::size_t k = 0; k < noise.size(); ++k) {
    targets.push_back(1.2 * static_cast<double>(k) + (k % 3 == 1 ? 0.3 : 0.0));
    run.push_back(amplitude_um * std::sin(2.0 * std::numbers::pi * targets.back() / pitch_mm + 0.6) + noise[k]);
  }
  Test test{{}, testing_support::make_series(targets, {run}, {}), {}};
  test.metadata.conditions.cycle = TestCycle::unidirectional;
  iso230_2::PeriodicOptions options;
  if (pitch_is_known) options.period = Position::native(pitch_mm);
  auto result = iso230_2::periodic_error(test, options);
  EXPECT_TRUE(result);
  return {std::move(test), *std::move(result)};
}

bool has_U(const json::Value& estimate) {
  return estimate.find("U")->is(json::Kind::number) && estimate.find("u")->is(json::Kind::number);
}

const json::Value& first_direction(const json::Value& object) { return object.find("directions")->items().front(); }

/// The highest of many peaks of noise alone is far from 0 by its u: an interval about it would hold nothing true.
TEST(PeriodicResult, StatesNoUncertaintyOfAPeriodThatNoiseMakes) {
  constexpr std::uint64_t tests = 60;
  for (const bool known : {false, true}) {
    int stated = 0;
    for (std::uint64_t seed = 0; seed < tests; ++seed) {
      const EvaluatedPeriodic noise = screw(0.0, seed, known);
      const json::Value result = to_json(noise);
      const json::Value& d = first_direction(result);
      const bool significant = noise.result.directions.front().significant;
      for (const char* key : {"amplitude", "phase_deg", "phase_at_zero_deg", "peak_to_valley"})
        EXPECT_EQ(has_U(*d.find(key)), significant) << key;
      EXPECT_EQ(has_U(*d.find("period")), significant && !known);
      EXPECT_TRUE(has_U(*d.find("slope"))) << "of the line it is right";
      stated += significant;
    }
    EXPECT_LE(stated, 3) << "of 60 tests where 1 % are false alarms";
  }
}

TEST(PeriodicResult, StatesTheUncertaintyOfAPeriodThatIsThere) {
  const EvaluatedPeriodic there = screw(4.0, 1, false);
  const json::Value result = to_json(there);
  const json::Value& d = first_direction(result);
  for (const char* key : {"period", "amplitude", "phase_deg", "phase_at_zero_deg", "peak_to_valley"})
    EXPECT_TRUE(has_U(*d.find(key))) << key;
}

TEST(PeriodicResult, ShowsNoUncertaintyOfAPeriodThatNoiseMakes) {
  const auto U_of = [](const EvaluatedPeriodic& e, std::string_view title) {
    const auto rows = report::periodic_rows(e.result.directions.front(), AxisKind::linear, {});
    const auto row = std::ranges::find(rows, title, &report::PeriodicRow::title);
    return row == rows.end() ? std::string("no such row") : row->U;
  };
  const EvaluatedPeriodic noise = screw(0.0, 1, false), there = screw(4.0, 1, false);
  ASSERT_FALSE(noise.result.directions.front().significant);
  for (const char* title : {"Period, found", "Amplitude", "Phase at the first target", "Phase at position 0",
                            "Peak to valley of the curve"}) {
    EXPECT_EQ(U_of(noise, title), "") << title;
    EXPECT_NE(U_of(there, title), "") << title;
  }
  EXPECT_NE(U_of(noise, "Slope of the removed line"), "");
}

}  // namespace
}  // namespace axiometry::app
