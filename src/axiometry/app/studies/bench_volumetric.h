// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "axiometry/base/json/json.h"
#include "axiometry/base/result.h"

/// How fast the 21 errors are found, on a machine that other programs can be given too: XFYZ with travels of 1000, 600
/// and 500 mm, four stations, three tools (the first at all stations, the others at three: 10 virtual stations, one
/// dead path each), cubic B-splines of eight spans: 177 unknowns of errors and 40 of stations. Readings are in memory;
/// bench/compare_scipy_volumetric.py writes the same problem for scipy.
namespace axiometry::app {

struct VolumetricBench {
  std::size_t observations = 2'000;
  std::size_t runs = 5;  ///< their least, median and first time are told
  unsigned threads = 0;  ///< 0: as many as the machine has
  std::uint64_t seed = 1;
};

/// observations, unknowns, threads, seconds (start of the stations, solution and covariance of all coefficients: the
/// least of the runs), median_seconds, first_seconds (of a process that has just begun), chi2_per_dof, monte_carlo
/// {trials: 200, observations, seconds}. Fails as volumetric::identify() does.
Result<json::Value> bench_volumetric(const VolumetricBench& bench);

}  // namespace axiometry::app
