// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "axiometry/volumetric/identify/equations/thinned_problem.h"
#include "axiometry/volumetric/identify/identification_test_support.h"
#include "axiometry/volumetric/identify/identifier.h"

namespace axiometry::volumetric::detail {
namespace {

struct RowsCase {
  CurveKind curves;
  Reversal reversal;
  bool drift;
};

/// a of a reading with all its zeros: normal_equations.h.
std::vector<double> dense_row(const Problem& problem, Vector3 u, std::size_t i) {
  std::vector<double> row(problem.unknowns.columns, 0.0);
  BeamRow beam = beam_row(problem, i);
  beam.along(u);
  for (const BeamRow::Piece& piece : beam.pieces())
    for (std::size_t k = 0; k < piece.count; ++k) row[piece.first + k] = piece.values[k];
  const BeamStretch& stretch = problem.unknowns.stretches[problem.unknowns.stretch_of[i]];
  const std::size_t station = problem.unknowns.stations[stretch.virtual_station].column;
  for (std::size_t k = 0; k < 3; ++k) row[station + k] = -u[k];
  row[stretch.column] = -1.0;
  if (problem.unknowns.drift) row[stretch.column + 1] = problem.unknowns.along_stretch[i];
  return row;
}

/// Readings of all stations and tools in turn, with breaks, some of them left out.
TEST(RowSums, AreTheSumsOfAllProductsWrittenOut) {
  test::TrueMachine machine("XFYZ", 11);
  VolumetricLengths lengths = test::measured(machine, test::four_stations(), {.points = 90});
  std::vector<VolumetricReading> mixed;
  for (std::size_t k = 0; k < 90; ++k)
    for (std::size_t v = 0; v < 12; ++v) mixed.push_back(lengths.readings[90 * v + k]);
  lengths.readings = mixed;
  std::vector<Approaches> approaches;
  std::vector<double> weights;
  for (std::size_t i = 0; i < mixed.size(); ++i) {
    approaches.push_back({i % 3 == 0 ? 1.0 : -1.0, i % 5 == 0 ? 0.0 : 1.0, -1.0});
    weights.push_back(i % 7 == 0 ? 0.0 : 1.0 + 0.01 * static_cast<double>(i % 11));
  }
  const std::vector<Vector3> tools = {machine.model.tools[0].offset_mm, machine.model.tools[1].offset_mm,
                                      machine.model.tools[2].offset_mm};
  const std::vector<std::size_t> breaks = {400, 800};
  for (const RowsCase& c :
       {RowsCase{CurveKind::spline, Reversal::none, false}, RowsCase{CurveKind::spline, Reversal::curves, true},
        RowsCase{CurveKind::nodes, Reversal::constant, false},
        RowsCase{CurveKind::legendre, Reversal::constant, true}}) {
    const auto coefficients = Coefficients::make(c.curves, machine.model.travel, {4, 3, 2}, c.reversal);
    ASSERT_TRUE(coefficients);
    const Unknowns unknowns = unknowns_of(*coefficients, lengths.readings, breaks, c.drift);
    const Problem problem{machine.model, *coefficients, unknowns, lengths.readings, tools, approaches, weights, 2};
    State state{std::vector<double>(coefficients->raw(), 0.0), {}, {}, {}};
    for (const VirtualStation& v : unknowns.stations)
      state.stations_mm.push_back(test::four_stations()[v.station].at_mm);
    state.dead_paths_mm.assign(unknowns.stretches.size(), 300.0);
    state.drifts_um.assign(unknowns.stretches.size(), 1.0);
    const Sights seen = sights(problem, state);
    const NormalEquations equations = normal_equations(problem, seen);
    const std::size_t n = equations.columns;
    std::vector<double> expected(n * n, 0.0);
    for (std::size_t i = 0; i < mixed.size(); ++i) {
      const std::vector<double> row = dense_row(problem, seen.beams[i], i);
      for (std::size_t a = 0; a < n; ++a)
        for (std::size_t b = a; b < n; ++b) expected[a * n + b] += weights[i] * row[a] * row[b];
    }
    for (std::size_t a = 0; a < n; ++a)
      for (std::size_t b = a; b < n; ++b)
        ASSERT_NEAR(equations.matrix[a * n + b], expected[a * n + b], 1e-9)
            << curve_kind_name(c.curves) << " row " << a << " column " << b;
  }
}

/// Of a grid whose rows have so many places as the step from one chosen reading to the next, or a part of it.
TEST(ThinnedProblem, TakesReadingsAtAllPlacesOfAGrid) {
  for (const std::size_t places : {2u, 5u, 10u, 20u, 25u}) {
    Unknowns unknowns;
    unknowns.stretches = {{0, 0, 20'000}, {0, 1, 30}};
    unknowns.stretch_of.assign(20'000, 0);
    unknowns.stretch_of.insert(unknowns.stretch_of.end(), 30, 1);
    const std::vector<std::size_t> some = some_of_each_stretch(unknowns, 1000);
    std::vector<std::size_t> at(places, 0);
    std::size_t of_short = 0;
    for (const std::size_t i : some) (i < 20'000 ? at[i % places] : of_short) += 1;
    EXPECT_EQ(of_short, 30u);  // fewer than a few: all
    EXPECT_NEAR(static_cast<double>(some.size()), 1000.0, 60.0);
    for (const std::size_t count : at)
      EXPECT_NEAR(static_cast<double>(count), 1000.0 / static_cast<double>(places),
                  0.2 * 1000.0 / static_cast<double>(places) + 3.0);
  }
}

/// Some readings give the start; the end is that of all of them: no step is left that would be seen.
TEST(LeastSquares, OfVeryManyReadingsEndsWhereAllOfThemSay) {
  test::TrueMachine machine("FXYZ", 12);
  const VolumetricLengths lengths = test::measured(machine, test::four_stations(), {.points = 1500});
  IdentifyOptions options;
  options.sizes = {2, 2, 2};
  options.drift = DriftModel::none;
  options.find_breaks = options.find_outliers = options.find_part_scales = false;
  options.threads = 1;
  auto done = Identifier::make(machine.model, lengths, options);
  ASSERT_TRUE(done);
  ASSERT_TRUE(done->run());
  const Problem problem = done->problem();
  ASSERT_GT(lengths.readings.size(), 80 * problem.unknowns.columns);  // so that some were taken for a start
  EXPECT_LE(done->fit().iterations, 2u);
  const Sights seen = sights(problem, done->fit().state);
  const std::vector<double> step = done->fit().solution.step(seen.gradient);
  double squared = 0.0;
  for (std::size_t k = 0; k < step.size(); ++k) squared += step[k] * seen.gradient[k];
  EXPECT_LT(std::sqrt(std::abs(squared)), 1e-6);
  for (std::size_t i = 0; i < seen.residuals_um.size(); ++i)
    ASSERT_NEAR(seen.residuals_um[i], done->fit().residuals_um[i], 1e-5);
}

}  // namespace
}  // namespace axiometry::volumetric::detail
