// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/base/quantity.h"
#include "axiometry/base/time/moment.h"
#include "axiometry/model/temperatures.h"

/// What recorded temperatures tell of the surroundings of a test (clauses 4.1 and 7).
///
/// Between two readings at most half an hour apart a temperature is taken to go straight; what lies farther apart is
/// not recorded. The rate in °C/h is the greatest change within an hour, the later of both moments in the test. Without
/// an hour in one piece it is the range of a piece of ten minutes or more, divided by its length; of shorter ones there
/// is none, and pieces that end before the test count for none of it. Of several sensors of the air the extremes and
/// the largest rate count, and the shortest recording. Of extremes between readings (sensor_extremes.h) there is no
/// rate.
namespace axiometry {

/// Absent means not measured.
struct AmbientTemperatures {
  std::optional<Temperature> lowest;  ///< lowest temperature of the air during the test
  std::optional<Temperature> highest;
  std::optional<double> rate;                             ///< °C/h, during the test
  bool rate_of_every_sensor = true;                       ///< whether every sensor of the air tells its rate
  std::optional<double> rate_before;                      ///< °C/h, in the twelve hours before it
  std::optional<TemperatureDifference> machine_gradient;  ///< largest, between places on the machine at one moment
};

/// In seconds from the beginning of a log.
struct TimeStretch {
  double begin_s = 0.0;
  double end_s = 0.0;
  bool end_told = true;  ///< else it may have lasted longer

  double length_s() const { return end_s - begin_s; }
};

inline constexpr double hours_before_test = 12.0;  ///< hours before the test of which clause 4.1 asks
inline constexpr double shortest_for_a_rate_s = 600.0;

/// Of the sensors of role "air" within the test; machine_gradient of those of role "machine", of which it takes two.
/// Without a test all that was recorded counts as it, and nothing is known of before. For its rate a test is looked at
/// together with the hour before it.
AmbientTemperatures ambient_of(std::span<const TemperatureCourse> sensors, const std::optional<TimeStretch>& test);

struct LeastRecorded {
  double recorded_s = 0.0;
  std::string sensor{};  ///< its name, where another one of the role recorded more
};

/// How much of a stretch the sensor of that role recorded that recorded least; nothing where there is none.
LeastRecorded least_recorded(std::span<const TemperatureCourse> sensors, std::string_view role,
                             const TimeStretch& stretch);

/// °C
struct TemperatureExtremes {
  double low = 0.0;
  double high = 0.0;
};
/// Of all readings of a sensor; nothing where it has none.
std::optional<TemperatureExtremes> extremes_of(const TemperatureCourse& course);

/// Of the sensors of a role at one moment; nothing where none of them is known then.
std::optional<TemperatureExtremes> extremes_at(std::span<const TemperatureCourse> sensors, std::string_view role,
                                               double time_s);

/// From the first to the last reading of any sensor.
TimeStretch stretch_of(std::span<const TemperatureCourse> sensors);

/// A test that began and ended at these moments in a log; without an end to the end of the log, and of no length where
/// that lies before the beginning. Nothing where the beginning of either is not told, where only one of two moments
/// tells its zone, and where the end does not lie behind the beginning.
std::optional<TimeStretch> test_in_log(const std::optional<Moment>& began, const std::optional<Moment>& ended,
                                       const TemperatureLog& log);

}  // namespace axiometry
