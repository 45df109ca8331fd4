// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "axiometry/app/results/experiment.h"
#include "axiometry/app/studies/lee_experiments.h"

/// The experiments of lee_experiments.h as tables beside the printed ones, and as JSON.
namespace axiometry::app::lee {

Experiment present(const CoordinateOffset& result, const report::Options& options);
/// One table for each fixture.
Experiment present(std::span<const ProportionalError> results, const report::Options& options);
Experiment present(const Slopes& result, const report::Options& options);

}  // namespace axiometry::app::lee
