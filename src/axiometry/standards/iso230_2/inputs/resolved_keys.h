// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <string_view>

/// The keys of the vocabulary that resolved_inputs.cpp and the archive's reading of instruments need, and
/// which of them say one thing together.
namespace axiometry::iso230_2 {

struct BodyKeys {
  std::string_view expansion;
  std::string_view expansion_range;
  std::string_view difference;
  std::string_view temperature_range;
  std::string_view nde_expansion;
};

struct CalibrationKeys {
  std::string_view constant;
  std::string_view per_length;
  std::string_view sum;
};

inline constexpr BodyKeys machine_keys{"uncertainty.machine_expansion_um_per_m_C",
                                       "uncertainty.machine_expansion_range_um_per_m_C",
                                       "uncertainty.machine_temperature_difference_C",
                                       "uncertainty.machine_temperature_range_C", "nde.machine_expansion_um_per_m_C"};
inline constexpr BodyKeys device_keys{"uncertainty.device_expansion_um_per_m_C",
                                      "uncertainty.device_expansion_range_um_per_m_C",
                                      "uncertainty.device_temperature_difference_C",
                                      "uncertainty.device_temperature_range_C", "nde.equipment_expansion_um_per_m_C"};
inline constexpr CalibrationKeys device_calibration_keys{
    "uncertainty.device_calibration", "uncertainty.device_calibration_um_per_m", "uncertainty.device_calibration_sum"};
inline constexpr CalibrationKeys artefact_calibration_keys{
    "artefact.calibration_uncertainty", "artefact.calibration_uncertainty_um_per_m", "artefact.calibration_sum"};
inline constexpr std::string_view length_key = "uncertainty.length_mm";
inline constexpr std::string_view error_range_key = "uncertainty.device_error_range_um_per_m";
inline constexpr std::string_view misalignment_key = "uncertainty.misalignment_mm";
inline constexpr std::string_view alignment_angle_key = "uncertainty.alignment_angle_deg";
inline constexpr std::string_view sensitivity_key = "uncertainty.environment_sensitivity_um_per_m_C";
inline constexpr std::string_view air_difference_key = "uncertainty.environment_temperature_difference_C";
inline constexpr std::string_view axis_resolution_key = "uncertainty.axis_resolution";
inline constexpr std::string_view instrument_resolution_key = "uncertainty.instrument_resolution";
inline constexpr std::string_view run_drift_key = "uncertainty.run_drift";
inline constexpr std::string_view variation_key = "uncertainty.environmental_variation";
inline constexpr std::string_view kind_key = "uncertainty.environment_kind";
inline constexpr std::string_view recording_key = "uncertainty.drift_recording";
inline constexpr std::string_view recording_interval_key = "uncertainty.drift_interval_s";
inline constexpr std::string_view correlation_key = "uncertainty.up_down_correlation";
inline constexpr std::string_view distributions_key = "uncertainty.distributions";
inline constexpr std::string_view probing_key = "artefact.probing_uncertainty";
inline constexpr std::string_view scale_expansion_key = "axis.scale_expansion_um_per_m_C";
inline constexpr std::string_view sensors_key = "sensors";
inline constexpr std::string_view air_start_key = "environment.air_temperature_start_C";
inline constexpr std::string_view air_end_key = "environment.air_temperature_end_C";

/// One statement of a certificate, in parts.
inline constexpr std::array device_calibration_all{device_calibration_keys.constant, device_calibration_keys.per_length,
                                                   device_calibration_keys.sum};
inline constexpr std::array artefact_calibration_all{
    artefact_calibration_keys.constant, artefact_calibration_keys.per_length, artefact_calibration_keys.sum};

/// All that is said of the errors of the device.
inline constexpr std::array device_statement_keys{device_calibration_keys.constant, device_calibration_keys.per_length,
                                                  device_calibration_keys.sum, error_range_key};

/// What has no meaning on a rotary axis.
inline constexpr std::array linear_keys{length_key,
                                        device_calibration_keys.per_length,
                                        device_calibration_keys.sum,
                                        error_range_key,
                                        misalignment_key,
                                        alignment_angle_key,
                                        machine_keys.expansion,
                                        machine_keys.expansion_range,
                                        machine_keys.difference,
                                        machine_keys.temperature_range,
                                        device_keys.expansion,
                                        device_keys.expansion_range,
                                        device_keys.difference,
                                        device_keys.temperature_range,
                                        sensitivity_key,
                                        air_difference_key};

/// The items whose place a distribution of this input takes.
inline std::span<const std::string_view> items_of_input(std::string_view input) {
  static constexpr std::array machine_expansion{machine_keys.expansion, machine_keys.expansion_range};
  static constexpr std::array machine_temperature{machine_keys.difference, machine_keys.temperature_range};
  static constexpr std::array device_expansion{device_keys.expansion, device_keys.expansion_range};
  static constexpr std::array device_temperature{device_keys.difference, device_keys.temperature_range};
  static constexpr std::array alignment{misalignment_key, alignment_angle_key};
  static constexpr std::array environment{sensitivity_key, air_difference_key};
  static constexpr std::array artefact_constant{artefact_calibration_keys.constant};
  static constexpr std::array artefact_length{artefact_calibration_keys.per_length};
  static constexpr std::array probing{probing_key};
  static constexpr std::array axis_resolution{axis_resolution_key};
  static constexpr std::array instrument_resolution{instrument_resolution_key};
  static constexpr std::array run_drift{run_drift_key};
  static constexpr std::array variation{variation_key};
  if (input == "machine_expansion") return machine_expansion;
  if (input == "machine_temperature") return machine_temperature;
  if (input == "device_expansion") return device_expansion;
  if (input == "device_temperature") return device_temperature;
  if (input == "alignment") return alignment;
  if (input == "environment") return environment;
  if (input == "device") return device_statement_keys;
  if (input == "artefact_calibration") return artefact_constant;
  if (input == "artefact_calibration_length") return artefact_length;
  if (input == "probing") return probing;
  if (input == "axis_resolution") return axis_resolution;
  if (input == "instrument_resolution") return instrument_resolution;
  if (input == "run_drift") return run_drift;
  if (input == "environmental_variation") return variation;
  return {};
}

}  // namespace axiometry::iso230_2
