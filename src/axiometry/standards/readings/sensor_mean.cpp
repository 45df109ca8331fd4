// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/readings/sensor_mean.h"

#include "axiometry/base/text/text.h"

namespace axiometry {

std::optional<SensorMean> mean_of_sensors(const Environment& environment, std::string_view role) {
  double start = 0.0;
  double end = 0.0;
  std::size_t count = 0;
  for (const TemperatureSensor& sensor : environment.sensors) {
    if (!text::equal_ignoring_case(sensor.role, role) || !(sensor.start || sensor.end)) continue;
    start += (sensor.start ? *sensor.start : *sensor.end).in_celsius();
    end += (sensor.end ? *sensor.end : *sensor.start).in_celsius();
    ++count;
  }
  if (count == 0) return std::nullopt;
  const double n = static_cast<double>(count);
  return SensorMean{Temperature::celsius(start / n), Temperature::celsius(end / n), count};
}

}  // namespace axiometry
