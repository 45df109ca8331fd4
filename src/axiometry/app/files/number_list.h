// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/base/vector3.h"

/// Several numbers in one option, separated by commas, with decimal points.
namespace axiometry::app {

/// "653.60,-27.13,262.18". Fails on other than three finite numbers.
Result<Vector3> parse_vector(std::string_view text);

/// Distances in mm: numbers, pieces from:to:step, and … (or ...), which goes on with the step of the two numbers before
/// it up to the one after it: "10,20,…,100,200:1100:100". Fails on what is none of these, a distance below
/// 1e-6 mm (1 nm) or above 1e9 mm, distances that do not ascend, a piece that does not end on its last number, and
/// beyond 100 000 of them.
Result<std::vector<double>> parse_distances(std::string_view text);

}  // namespace axiometry::app
