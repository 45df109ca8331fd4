// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/identify/anomalies.h"

#include <gtest/gtest.h>

#include <numeric>
#include <vector>

#include "axiometry/volumetric/identify/identification_test_support.h"
#include "tests/support/cpu_time.h"

namespace axiometry::volumetric::detail {
namespace {

/// Readings of one beam, σ = 1 µm each, with breaks; what a fit of them found.
class BrokenBeam {
 public:
  BrokenBeam(std::vector<std::size_t> stretches, std::vector<double> dead_paths_um, bool drift)
      : weights(std::accumulate(stretches.begin(), stretches.end(), std::size_t{0}), 1.0),
        readings_(weights.size()),
        residuals_um_(weights.size(), 0.0) {
    std::size_t end = 0;
    for (const std::size_t count : stretches) breaks_.push_back(end += count);
    breaks_.pop_back();
    unknowns_ = unknowns_of(coefficients_, readings_, breaks_, drift);
    for (const double um : dead_paths_um) state_.dead_paths_mm.push_back(1e-3 * um);
    state_.drifts_um.assign(stretches.size(), 0.0);
  }

  std::optional<std::size_t> least_clear() const {
    const Problem problem{machine_.model, coefficients_, unknowns_, readings_, {}, {}, weights};
    return least_clear_break(problem, state_, residuals_um_, breaks_);
  }

  std::vector<double> weights;

 private:
  test::TrueMachine machine_{"XYZF", 1};
  Coefficients coefficients_ =
      Coefficients::make(CurveKind::spline, machine_.model.travel, {2, 2, 2}, Reversal::none).value();
  std::vector<VolumetricReading> readings_;
  std::vector<std::size_t> breaks_;
  Unknowns unknowns_;
  State state_;
  std::vector<double> residuals_um_;
};

/// 30 + 4 ln 100 = 48.4 variances: of means of 50 readings 1.39 µm. A straight line at its end has (4n − 2)/(n(n + 1)),
/// which is 3.9 times as much, so that 2.75 µm is asked for.
TEST(LeastClearBreak, AsksForMoreWhereStretchesDrift) {
  EXPECT_FALSE(BrokenBeam({50, 50}, {0.0, 1.45}, false).least_clear());
  EXPECT_EQ(BrokenBeam({50, 50}, {0.0, 1.35}, false).least_clear(), 50u);
  EXPECT_EQ(BrokenBeam({50, 50}, {0.0, 2.7}, true).least_clear(), 50u);
  EXPECT_FALSE(BrokenBeam({50, 50}, {0.0, 2.8}, true).least_clear());
}

TEST(LeastClearBreak, IsThatOfTheSmallestJumpInDeviationsOfItsStretches) {
  EXPECT_EQ(BrokenBeam({50, 3, 50}, {0.0, 2.5, 4.9}, false).least_clear(), 53u);  // both are unclear
  EXPECT_EQ(BrokenBeam({50, 3, 50}, {0.0, 2.4, 4.9}, false).least_clear(), 50u);
  EXPECT_FALSE(BrokenBeam({53, 50}, {0.14, 4.9}, false).least_clear());  // without the first of them
}

TEST(LeastClearBreak, IsUnclearWhereNoReadingCountsOnASide) {
  BrokenBeam beam({50, 3}, {0.0, 100.0}, true);
  EXPECT_FALSE(beam.least_clear());
  beam.weights[50] = beam.weights[51] = 0.0;  // one is left, through which any line goes
  EXPECT_EQ(beam.least_clear(), 50u);
  beam.weights[52] = 0.0;
  EXPECT_EQ(beam.least_clear(), 50u);
}

TEST(LeastClearBreak, IsFoundInTimeInProportionToTheReadings) {
  const auto seconds_of = [](std::size_t stretches) {
    const BrokenBeam beam(std::vector<std::size_t>(stretches, 100'000 / stretches),
                          std::vector<double>(stretches, 0.0), true);
    const double begun = testing_support::cpu_seconds();
    EXPECT_TRUE(beam.least_clear());
    return testing_support::cpu_seconds() - begun;
  };
  const double few = seconds_of(2), many = seconds_of(1000);
  EXPECT_LT(many, 10.0 * few + 0.02) << few;
}

}  // namespace
}  // namespace axiometry::volumetric::detail
