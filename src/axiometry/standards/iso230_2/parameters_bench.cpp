// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

#include "axiometry/standards/iso230_2/parameters.h"

namespace axiometry {
namespace {

Series series_of(std::size_t targets, std::size_t runs) {
  std::vector<Position> positions;
  for (std::size_t i = 0; i < targets; ++i) positions.push_back(Position::native(170.0 * static_cast<double>(i)));
  std::vector<double> deviations(2 * targets * runs);
  for (std::size_t k = 0; k < deviations.size(); ++k) deviations[k] = 5.0 * std::sin(0.37 * static_cast<double>(k));
  return *Series::make_dense(std::move(positions), runs, std::move(deviations));
}

/// The whole of clause 3 for m targets and n runs in both directions, ordering checks included.
void evaluate(benchmark::State& state) {
  const Series series = series_of(static_cast<std::size_t>(state.range(0)), static_cast<std::size_t>(state.range(1)));
  for (auto _ : state) benchmark::DoNotOptimize(iso230_2::evaluate(series));
}
BENCHMARK(evaluate)->Args({11, 5})->Args({101, 5})->Args({11, 100});

}  // namespace
}  // namespace axiometry
