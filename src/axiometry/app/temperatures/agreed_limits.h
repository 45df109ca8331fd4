// SPDX-License-Identifier: Apache-2.0
#pragma once

/// What the parties may have agreed on the surroundings of a test (7), however it is stated: below and above this
/// nobody means a hall.
namespace axiometry::app {

inline constexpr double coldest_agreed_C = -60.0;  ///< °C
inline constexpr double most_agreed_C = 100.0;     ///< °C; also of °C/h and of a difference

}  // namespace axiometry::app
