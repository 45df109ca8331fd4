// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/app/recordings/raw_recording.h"
#include "axiometry/base/result.h"
#include "axiometry/simulation/simulate.h"

/// The faults of a simulation as people write them: "--backlash 3um", "--cyclic 10mm:1.5um".
namespace axiometry::app {

/// A simulation with its recording, as far as the command line says it.
struct SimulationRequest {
  simulation::Request simulate;
  simulation::RecordingRequest recording;
  Length wavelength = simulated_wavelength;  ///< wavelength in air, of a stream of counts
};

/// Group of the options that change nothing without a recording.
inline constexpr std::string_view recording_group = "Recording";

/// One option: its values, its help, and what it does. One row of the table makes the option, its help, its manual and
/// its reading.
struct SimulationOption {
  std::string_view name;    ///< "--backlash"
  std::string_view values;  ///< "SIZE[:WEAR:AT:WIDTH]"
  std::string_view help;
  std::string_view group;
  bool repeated = false;

  /// Puts it into the request, over what a preset or an earlier option says. Needs the plan to be there: its axis
  /// says which units are right. Fails on a text that is not of the form of `values` with the units that belong there.
  Result<void> (*apply)(std::span<const std::string> texts, SimulationRequest& request);
};

std::span<const SimulationOption> simulation_options();

/// "position,deviation" (mm and µm, ° and ″) in each line, separated by comma, semicolon or blanks; lines that are
/// empty or begin with # are passed over. Fails, with the line, on others.
Result<std::vector<simulation::PitchError::Node>> parse_pitch_table(std::string_view text);

}  // namespace axiometry::app
