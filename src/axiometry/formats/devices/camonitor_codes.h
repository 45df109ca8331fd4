// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/series.h"

/// Test numbers of the ISO 230 scripts of ecmc: direction, cycle and target in one number.
namespace axiometry::formats {

struct TestCode {
  Direction direction = Direction::up;
  std::size_t cycle = 0;   ///< number of the cycle, from 1
  std::size_t target = 0;  ///< number of the target, from 1
};

/// Whether a value can be such a number: at least three digits, the first 1 (↑) or 2 (↓).
bool is_test_code(std::string_view value);

/// What the numbers of one test mean. Their digits are D C…C P…P; how many belong to the cycle is not written anywhere,
/// so that split is taken which gives the fullest grid of cycles and targets, both counting from 1. `codes` hold
/// is_test_code() values. Fails when they differ in length, and when no split gives such a grid.
Result<std::vector<TestCode>> test_codes(std::span<const std::string_view> codes);

}  // namespace axiometry::formats
