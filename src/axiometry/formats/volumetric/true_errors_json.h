// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "axiometry/base/json/json.h"
#include "axiometry/base/result.h"
#include "axiometry/volumetric/machine/machine_model.h"
#include "axiometry/volumetric/simulate/true_errors.h"

/// Errors of a machine that are known, as JSON.
namespace axiometry::formats {

/// {"EXX": [{"position", "value"}, …], …, "C0Y": {"value"}, …} in mm, µm and µrad, as `volumetric identify` prints
/// them; of a curve with reversal also "up" and "down": {"value"}, where the axis came to rest moving up and moving
/// down, of which "value" is the mean.
json::Value true_errors_value(const volumetric::TrueErrors& errors);

/// Of the member "errors" of a file, which `volumetric simulate --truth` and `volumetric identify --out` write too. An
/// error that is not there is 0; one that has no value, as identify writes of what lengths do not tell, is refused, and
/// so is one of one direction alone.
/// Fails, with line and column, on names that are none, on tables as TrueCurve::make() does, on those that leave more
/// than a twentieth of the axis' travel out at an end, and on errors of a machine, where the file has one, of another
/// chain or of other functional points: the same numbers mean other errors there.
Result<volumetric::TrueErrors> read_true_errors(std::string_view bytes, const volumetric::MachineModel& machine);

}  // namespace axiometry::formats
