// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "axiometry/app/simulate/simulate_text.h"
#include "axiometry/standards/iso230_2/parameters.h"

namespace axiometry::app {

/// The plan in a file, or a standard one of a linear axis of 500 mm when the name is empty: 11 targets, 5 runs, a
/// screw of 10 mm. Fails as formats::read_plan() and check_measures_positions() do. Further
/// plans of the file are not simulated.
Result<Plan> simulation_plan(const std::string& file);

/// Reads the table of a file. Fails as parse_pitch_table() does.
Result<std::vector<simulation::PitchError::Node>> read_pitch_table(const std::string& file);

/// Where a simulation goes, and from where; empty names are not written.
struct SimulationOutputs {
  std::string test;           ///< a format that can be written, by its extension
  std::string raw;            ///< .csv, .txt, .npy or .umd
  std::string truth;          ///< JSON
  std::string plan;           ///< plan that is read, and not to be overwritten
  std::string pitch_table{};  ///< pitch table that is read, and not to be overwritten
};

/// Fails on an extension that nothing writes, a name given twice, and on a file that is read among the outputs.
Result<void> check_simulation_outputs(const SimulationOutputs& outputs);

struct SimulationSummary {
  std::size_t readings = 0;
  std::size_t targets = 0;
  std::size_t samples = 0;  ///< samples of the recording
  Duration duration;
  iso230_2::AxisParameters true_parameters;  ///< true parameters of this test
};

/// Simulates, and writes all outputs or none. Fails as simulate(), record() and the outputs do.
Result<SimulationSummary> run_simulation(const SimulationRequest& request, const SimulationOutputs& outputs);

}  // namespace axiometry::app
