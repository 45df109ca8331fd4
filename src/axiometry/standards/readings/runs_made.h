// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "axiometry/model/series.h"

/// How often a direction was run, which the numbers of the runs do not tell: an instrument that counts one-way runs
/// leaves every second number to the other direction, and of a run that was left out the number is missing.
namespace axiometry {

/// Runs in which at least one target has a reading from this direction.
std::size_t runs_made(const Series& series, Direction direction);

/// The same of the direction that was run more often.
std::size_t most_runs_made(const Series& series);

/// The same readings with runs that count from 1 without gaps: the k-th run ↑ and the k-th ↓ are one where no run has
/// both. For what asks which runs belong together and not when they were.
Series without_empty_runs(const Series& series);

}  // namespace axiometry
