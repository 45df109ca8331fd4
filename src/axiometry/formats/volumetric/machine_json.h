// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/base/json/json.h"
#include "axiometry/base/result.h"
#include "axiometry/volumetric/machine/machine_model.h"

/// The machine of a volumetric calibration (machine.json).
namespace axiometry::formats {

/// The linear axes, as members of objects name them.
inline constexpr std::array<std::string_view, 3> linear_axis_names = {"X", "Y", "Z"};

/// At least
///   {"chain": "XFYZ", "travel_mm": {"X": [0, 1000], "Y": [0, 600], "Z": [-500, 0]}, "tools_mm": {"T1": [0, 0, -150]}}
/// and, where they are not the usual ones, "name", "instrument": {"a_um", "b_um_per_m", "scale_u_um_per_m"},
/// "repeatability_um", "stations_mm": {"S1": [x, y, z]}, "functional_point_mm": {"X": [x, y, z]}. Members that nobody
/// knows are passed over and told, unless they look like one of these. Fails, with line and column, on a chain that is
/// none, travels that do not grow, no tool, names given twice, coordinates beyond 1e9 mm, uncertainties below 0 or all
/// 0.
struct MachineFile {
  volumetric::MachineModel machine;
  std::vector<std::string> remarks = {};  ///< sentences without full stop: what was passed over
};
Result<MachineFile> read_machine(std::string_view bytes);
Result<MachineFile> machine_from(const json::Value& value);

json::Value machine_value(const volumetric::MachineModel& machine);

/// JSON Schema of machine.json.
json::Value machine_schema();

}  // namespace axiometry::formats
