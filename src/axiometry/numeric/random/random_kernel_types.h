// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "axiometry/numeric/vector_target.h"

namespace axiometry::numeric {

/// Numbers that one step of the generator gives: xoshiro256++ in eight lanes side by side.
inline constexpr std::size_t random_lanes = 8;

/// State word by state word, each of all lanes.
struct RandomState {
  std::uint64_t words[4][random_lanes];
};

/// Each function makes `groups` groups of numbers, one after the other, and moves the state on.
struct RandomKernel {
  static constexpr std::size_t bits_group = random_lanes;
  static constexpr std::size_t uniform_group = random_lanes;
  static constexpr std::size_t normal_group = 2 * random_lanes;
  static constexpr std::size_t normal_single_group = 4 * random_lanes;

  void (*bits)(RandomState& state, std::uint64_t* numbers, std::size_t groups);
  void (*uniform)(RandomState& state, double* numbers, std::size_t groups);
  void (*normal)(RandomState& state, double* numbers, std::size_t groups);
  void (*normal_single)(RandomState& state, float* numbers, std::size_t groups);
};

/// The one for this target; contract: it is available.
const RandomKernel& random_kernel_of(VectorTarget target);

}  // namespace axiometry::numeric
