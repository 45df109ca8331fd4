// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "axiometry/base/quantity.h"
#include "axiometry/model/metadata.h"

/// Private to standards/.
namespace axiometry {

struct SensorMean {
  Temperature start;
  Temperature end;
  std::size_t sensors = 0;
};

/// The mean of the sensors of a role, in any case, at the start and the end of a test. A sensor read only once counts
/// as constant; nothing without one that was read.
std::optional<SensorMean> mean_of_sensors(const Environment& environment, std::string_view role);

}  // namespace axiometry
