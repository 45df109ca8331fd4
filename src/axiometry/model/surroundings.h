// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "axiometry/base/quantity.h"

/// The surroundings of a test as a test states them, and what was agreed on them (4.1, 7).
namespace axiometry {

/// Of a hall, however it is stated: colder or hotter nobody means one.
inline constexpr double coldest_hall_C = -60.0;  ///< °C
inline constexpr double hottest_hall_C = 100.0;  ///< °C; also of °C/h and of a difference

/// The surroundings over the whole test, as who tested states them (4.1): what a log of temperatures would find.
struct StatedEnvironment {
  std::optional<Temperature> lowest;                      ///< lowest temperature of the air during the test
  std::optional<Temperature> highest;                     ///< highest temperature of the air during the test
  std::optional<double> rate;                             ///< °C/h, largest during the test
  std::optional<double> rate_before;                      ///< °C/h, largest in the twelve hours before it
  std::optional<TemperatureDifference> machine_gradient;  ///< largest between places on the machine
  std::optional<double> soaked_h;  ///< h that machine and equipment stood in the surroundings before the test

  friend bool operator==(const StatedEnvironment&, const StatedEnvironment&) = default;
};

/// What manufacturer or supplier and user agreed on the surroundings (7).
struct AgreedEnvironment {
  std::optional<Temperature> lowest;
  std::optional<Temperature> highest;
  std::optional<double> rate;  ///< °C/h, twelve hours before the test and during it
  std::optional<TemperatureDifference> machine_gradient;

  friend bool operator==(const AgreedEnvironment&, const AgreedEnvironment&) = default;
};

}  // namespace axiometry
