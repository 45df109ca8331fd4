// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "axiometry/base/json/json.h"
#include "axiometry/base/result.h"
#include "axiometry/uncertainty/monte_carlo.h"

/// How fast the Monte Carlo method goes through the whole of clause 3, on one model that other programs can compute
/// too (bench/compare_numpy_monte_carlo.py does).
///
/// The model: m = 11 targets at P_i = 0.05 + 0.09 i (m, i from 0), n = 5 runs, both directions.
///   base↑_i = 6 sin(0.55 i) + 0.4 i,  base↓_i = base↑_i + 2.5 + 0.6 cos(0.9 i)                             (µm)
///   x_ij = base_i + √(0.7² + 0.4²)·z_ij + 0.5·d_j + 1.5·P_i·c                                              (µm)
/// z one standard normal number for each reading (scatter of the machine and of the environment in one), d for each
/// run, c for each trial: 116 for each trial. Every reading is made, and evaluated as evaluate() does.
namespace axiometry::app {

enum class Precision { both_double, both_single };  ///< draws and evaluation; summaries are double

struct MonteCarloBench {
  std::size_t trials = 1'000'000;
  unsigned threads = 1;  ///< 0: as many as the machine has
  std::uint64_t seed = 1;
  Precision precision = Precision::both_double;
};

/// The model as propagate() runs it; outputs are the twelve parameters in the order of iso230_2::parameters.
uncertainty::BlockModel monte_carlo_bench_model(const MonteCarloBench& bench);

/// Runs it and returns trials, threads, seed, precision, instructions (numeric::vector_target_name), seconds,
/// trials_per_second, and for every parameter by its key mean, sd, q025 and q975 (µm). Fails as propagate() does.
Result<json::Value> bench_monte_carlo(const MonteCarloBench& bench);

}  // namespace axiometry::app
