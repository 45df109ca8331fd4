// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "axiometry/model/series.h"
#include "axiometry/standards/iso230_2/scatter/run_tilts.h"

/// How the runs of a test differ as wholes. Private to compensation/.
namespace axiometry::compensation::retest {

/// What a run has of its own: shift ↑, shift ↓, tilt ↑, tilt ↓ (run_tilts.h).
inline constexpr std::size_t numbers_of_run = 4;
using RunNumbers = std::array<double, numbers_of_run>;

/// L of their covariance L Lᵀ, so that L z of four normal numbers are those of another run.
using RunSpread = std::array<RunNumbers, numbers_of_run>;

/// Of the runs of a test, freed of what scatter makes of their numbers; `tilted`: whether their tilts count.
RunSpread run_spread(const Series& series, const iso230_2::TiltStudy& study, bool tilted);

/// share · L z.
RunNumbers drawn_run(const RunSpread& spread, std::span<const double> z, double share);

}  // namespace axiometry::compensation::retest
