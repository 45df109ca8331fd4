// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/base/vector3.h"

/// Figures printed in Lee et al., Sensors 16 (2016) 482, and set-ups that stand in for those it does not print.
namespace axiometry::app::lee {

inline constexpr Vector3 station_mm = {653.60, -27.13, 262.18};  ///< 2.2

/// Axes to which an error was given, and its sign: the rows of Tables 2 and 3.
struct Row {
  std::string_view name;  ///< "x and y, +"
  Vector3 given;          ///< +1, −1 or 0 of each axis
  Vector3 table2_mm;      ///< printed differences of coordinates, for an offset of 1 mm
  Vector3 table3_mm;      ///< printed, for a proportional error of "1.01" or "0.99"
};
inline constexpr std::size_t row_count = 12;
std::span<const Row, row_count> rows();

/// In Table 3 the z difference of the row "z-axis, 0.99" is printed 0.40. The rows with z and another axis are sums of
/// those of one axis, and want 0.04.
inline constexpr std::size_t misprinted_row = 5;
inline constexpr double misprinted_mm = 0.04;
Vector3 table3_corrected_mm(std::size_t row);

/// Six points about the station that see it well (largest amplification 1.3 µm per µm of length), where the paper
/// prints none.
std::vector<Vector3> points_mm();

/// Points, size and origin of the scale error for which Table 3 comes out within its scatter. The paper prints neither;
/// none with a true error of 1 % and an ordinary arrangement does (docs/studies/lee-proportional-error.md).
struct Fixture {
  std::string name;
  double error = 0.0;  ///< e where the paper's row says 1.01
  Vector3 station_mm;
  Vector3 origin_mm;     ///< origin of the scale
  bool refined = false;  ///< which estimator it belongs to
  std::vector<Vector3> points_mm;
};
std::vector<Fixture> fixtures();

}  // namespace axiometry::app::lee
