// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "axiometry/app/volumetric/simulated_recording.h"
#include "axiometry/base/json/json.h"
#include "axiometry/base/result.h"
#include "axiometry/volumetric/simulate/coverage.h"
#include "axiometry/volumetric/simulate/simulated_lengths.h"

/// The use case "lengths of a machine whose 21 errors are known".
namespace axiometry::app {

struct SimulateRequest {
  std::string machine;  ///< JSON, formats/volumetric/machine_json.h; empty where a plan is given
  std::string plan;     ///< JSON, formats/volumetric/volumetric_plan_json.h: its machine, stations and points
  std::string errors;   ///< JSON with the member "errors"; empty: drawn by the seed
  volumetric::DrawnSize size = {};
  std::vector<Vector3> stations_mm = {};  ///< stations in place of those of the machine's file, S1, S2, …
  std::size_t points = 100;               ///< points of each station and tool
  volumetric::SimulatedFaults faults = {};
  std::uint64_t seed = 1;
  std::size_t spans = 0;  ///< spans of curves in trials; 0: as identify chooses
  /// Of errors that are drawn; in trials also what is looked for.
  volumetric::Reversal reversal = volumetric::Reversal::none;
  RecordingNoise recording = {};
};

/// Empty names are not written; "-" is the standard output.
struct SimulateFiles {
  std::string lengths;     ///< CSV for `volumetric identify`
  std::string recordings;  ///< ".csv", ".txt" or ".npy": one of each part where the name has "{part}", else one of all
  std::string truth;       ///< JSON
};

struct SimulatedCalibration {
  SimulateRequest request;
  volumetric::MachineModel machine;
  volumetric::TrueErrors errors;
  volumetric::SimulatedLengths simulated;
  std::optional<volumetric::CalibrationPlan> plan;  ///< plan that was asked for
};

/// What a request names, read: the machine with its stations, and its errors for a trial.
struct SimulationInputs {
  volumetric::MachineModel machine;
  bool has_errors = false;  ///< whether a file stated them
  volumetric::TrueErrors errors;
  std::vector<volumetric::Visit> visits;  ///< visits of a plan
  std::optional<volumetric::CalibrationPlan> plan;
};
/// Fails as the readers do, on neither a machine nor a plan or both, on a machine without stations where none are
/// given, and beyond 1 000 000 readings.
Result<SimulationInputs> simulation_inputs(const SimulateRequest& request);

/// Fails as simulation_inputs() does, and on reversal to be drawn beside errors of a file, which hold their own.
Result<SimulatedCalibration> simulate_calibration(const SimulateRequest& request);

/// The errors as they are and in the gauge of the identification, and all that went wrong.
json::Value truth_value(const SimulatedCalibration& calibration);

struct SimulatedSummary {
  std::size_t recordings = 0;
  std::size_t samples = 0;  ///< samples of all recordings
};

/// Writes all files or none. Fails on no output, on one name twice, on a name that is an input's, and on recordings
/// without a plan.
Result<SimulatedSummary> write_simulated(const SimulatedCalibration& calibration, const SimulateFiles& files);

/// The use case "whether the stated uncertainties are true": trials of the whole procedure.
Result<volumetric::CoverageStudy> coverage_of(const SimulateRequest& request, std::size_t trials);

/// {"trials", "failed", "curves", "field": {share, standard_error, z_rms, values}, "errors" by name, "chi2_per_dof",
/// "field_rms_um", "breaks", "outliers"}.
json::Value coverage_value(const SimulateRequest& request, const volumetric::CoverageStudy& coverage);
std::string coverage_text(const volumetric::CoverageStudy& coverage);

}  // namespace axiometry::app
