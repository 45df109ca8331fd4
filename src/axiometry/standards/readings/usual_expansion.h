// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <optional>
#include <string_view>

#include "axiometry/base/text/text.h"
#include "axiometry/model/metadata.h"

/// What stands for items of expansion and temperature that nobody gave (ISO 230-2:2014, Annex A), said once for Annex
/// A, the inputs of the other methods and the rules.
namespace axiometry::iso230_2 {

inline constexpr double expansion_usual = 12.0;        ///< α, µm/(m·°C), Table A.2
inline constexpr double expansion_range_usual = 2.0;   ///< R(α), µm/(m·°C), A.2.4.3
inline constexpr double reference_temperature = 20.0;  ///< °C
inline constexpr double strain_per_um_per_m = 1e-6;    ///< a strain of 1 µm/m as a number

/// The largest departure from 20 °C, in °C and with its sign, that the sensors of a role have shown at start or end,
/// the first of several that are alike. Absent without any.
inline std::optional<double> largest_sensor_difference(const Environment& environment, std::string_view role) {
  std::optional<double> largest;
  for (const TemperatureSensor& sensor : environment.sensors) {
    if (!text::equal_ignoring_case(sensor.role, role)) continue;
    for (const auto& temperature : {sensor.start, sensor.end}) {
      if (!temperature) continue;
      const double difference = temperature->in_celsius() - reference_temperature;
      if (!largest || std::abs(difference) > std::abs(*largest)) largest = difference;
    }
  }
  return largest;
}

}  // namespace axiometry::iso230_2
