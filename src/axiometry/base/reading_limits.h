// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

/// What no reading, plan or result goes beyond: larger numbers are none of a machine, and sums of their squares stay
/// exact enough to be told from rounding.
namespace axiometry {

/// Of positions in mm and °, of deviations in µm and ″, of every other number that is stated.
inline constexpr double largest_stated = 1e9;

/// Readings of one plan: as many as the page shows and a capture follows.
inline constexpr std::size_t most_planned_readings = 100'000;

}  // namespace axiometry
