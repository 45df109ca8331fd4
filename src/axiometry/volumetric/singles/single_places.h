// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "axiometry/base/result.h"
#include "axiometry/volumetric/singles/single_errors.h"

/// Where the axes stood while errors were measured singly, and along which lines.
namespace axiometry::volumetric {

inline constexpr std::array<char, 3> single_axis_letters = {'X', 'Y', 'Z'};
inline constexpr double single_travel_slack_mm = 0.02;

/// Squareness = sign of the slopes of two straightness errors, seen as what adds to what is read of it: C0Y = rotation
/// of Y about Z less that of X, −slope(EXY) − slope(EYX); B0Z = slope(EXZ) + slope(EZX); A0Z = −slope(EYZ) −
/// slope(EZY).
struct SquareLines {
  ErrorMotion first, second;
  double sign = 1.0;
};
inline constexpr std::array<SquareLines, 3> square_lines = {
    SquareLines{{1, 0}, {0, 1}, -1.0}, SquareLines{{2, 0}, {0, 2}, 1.0}, SquareLines{{2, 1}, {1, 2}, -1.0}};

/// Fails on displacements or squareness of an axis without a place, and on a place beyond the travel.
Result<void> check_single_places(const MachineModel& machine, const SingleErrors& errors);

}  // namespace axiometry::volumetric
