// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "axiometry/base/vector3.h"

/// The axes X, Y and Z that move the reflector. Private to tracking/.
namespace axiometry::tracking {

inline constexpr std::array<char, 3> axis_names = {'X', 'Y', 'Z'};

/// Whether axis k moves along a line of this direction, of length 1; else the direction departs from 0 by rounding.
inline bool axis_moves(Vector3 direction, std::size_t k) { return std::abs(direction[k]) > 1e-9; }

/// As programs are written: to 0.001 mm. k/1000, not k·0.001, is the double that "12.345" reads as.
inline double rounded_to_um(double x_mm) { return std::round(x_mm * 1000.0) / 1000.0; }

}  // namespace axiometry::tracking
