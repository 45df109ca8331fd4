// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace axiometry {

/// Whether the name of a sensor of temperature tells that its readings are the highest or the lowest of the time since
/// the reading before: "Air max", "T1_min", "Luft Maximum". When within that time it was nobody knows.
bool names_extremes(std::string_view sensor);

/// The same name without that, and without "mean" and the like: "t1" of "T1 max" and of "T1_avg".
std::string sensor_alone(std::string_view sensor);

}  // namespace axiometry
