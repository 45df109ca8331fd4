// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "axiometry/base/time/moment.h"

/// Temperatures as sensors recorded them about a test.
namespace axiometry {

/// Longest gap between two readings, s: what lay between others farther apart nobody knows.
inline constexpr double longest_unrecorded_s = 1800.0;

/// What one sensor recorded, in order of time; °C lie within −60 … 100.
struct TemperatureCourse {
  std::string role;      ///< "machine", "equipment" or "air"
  std::string location;  ///< the sensor's name
  std::vector<double> times_s;
  std::vector<double> celsius;  ///< a temperature for each time
};

struct TemperatureLog {
  std::optional<Moment> begin;             ///< moment of time 0; absent where the log tells no date
  std::vector<TemperatureCourse> sensors;  ///< never empty; one at least has readings
  std::vector<std::string> remarks;        ///< what was assumed, left out or passed over; sentences without full stop
};

}  // namespace axiometry
