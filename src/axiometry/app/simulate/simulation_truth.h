// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>

#include "axiometry/app/simulate/simulate_text.h"
#include "axiometry/base/json/json.h"
#include "axiometry/simulation/simulate.h"
#include "axiometry/standards/iso230_2/parameters.h"

/// The truth behind a simulation, for programs: schema in docs/howto/simulate.md.
namespace axiometry::app {

/// Clause 3 of the true deviations at the readings that were taken: what this test would have given with a perfect
/// instrument (the measurand "this test").
iso230_2::AxisParameters true_parameters_of_test(const simulation::SimulatedTest& simulated);

/// Clause 3 of the expected curves and spreads: what many tests like this one would come to (the measurand "this
/// machine"). Their estimates scatter about them, and those that are largest values lie above them on average.
iso230_2::AxisParameters true_parameters_of_machine(const simulation::SimulatedTest& simulated);

/// All of it; the last is absent without a recording.
json::Value truth_value(const SimulationRequest& request, const simulation::SimulatedTest& simulated,
                        const std::optional<simulation::TrueRecording>& recording);

}  // namespace axiometry::app
