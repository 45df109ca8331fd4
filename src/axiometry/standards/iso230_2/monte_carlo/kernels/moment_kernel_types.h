// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "axiometry/numeric/vector_target.h"

namespace axiometry::iso230_2 {

// Mean and estimator of what perfect instruments would have read of one cell, for many trials: no reading is made.
//
// About their mean the perfect readings of a cell are v_j + c z_j, v_j = q_j − q̄ + w r_j, c = √w u, z normal beside
// the mean. Turned so that one axis lies along v, their squares are
//
//   S = |v|² + 2 |v| c √L cos θ + c² L                                                                    (1a)
//
// with L the squared length of n − 1 normal numbers and θ the angle of their direction to v:
// docs/theory/monte-carlo.md. Of five readings L = −2 ln(U₁ U₂) and cos θ = √U₃ cos(π U₄). Of any other number √L cos θ
// is a normal number z₁, and L = z₁² + χ² of n − 2 degrees of freedom: −2 ln of a product of uniform numbers, one for
// every two of them, and the square of a normal number where one is left.

/// How many rows of random numbers a draw takes.
struct MomentNumbers {
  std::size_t normals = 0;
  std::size_t bits = 0;  ///< whole numbers, all 64 bits random
};
inline constexpr std::size_t standard_approaches = 5;  ///< 5.3.2
inline constexpr MomentNumbers moment_numbers(std::size_t count) {
  if (count < 2) return {0, 0};
  if (count == standard_approaches) return {0, 4};
  return {1 + count % 2, (count - 2) / 2};
}

/// Shifts of the readings of a cell, parted into their mean and what is about it. Contract: so many trials that whole
/// registers hold them, a multiple of 8, here and below.
struct CellShifts {
  std::size_t trials = 0;
  std::size_t count = 0;                  ///< n ≥ 1
  const double* const* shifts = nullptr;  ///< q_j, a row for each reading
  double* const* about = nullptr;         ///< out: q_j − q̄; may be the same rows
  double* mean = nullptr;                 ///< out: q̄
};

struct MomentsInNoise {
  std::size_t trials = 0;
  std::size_t count = 0;                 ///< n ≥ 1
  double noise_variance = 0.0;           ///< u²
  const double* residuals = nullptr;     ///< r_j of each reading, together 0
  const double* machines = nullptr;      ///< w
  const double* const* about = nullptr;  ///< q_j − q̄, a row for each reading
  const double* shift = nullptr;         ///< q̄
  const double* normals = nullptr;       ///< moment_numbers().normals rows
  const std::uint64_t* bits = nullptr;   ///< moment_numbers().bits rows
  const double* own_means = nullptr;     ///< means without q̄
  double* means = nullptr;               ///< out: with q̄
  double* estimators = nullptr;          ///< out: √(S/(n − 1)), 0 for n = 1
};

struct MomentKernel {
  void (*about_mean)(const CellShifts& cell);
  void (*in_noise)(const MomentsInNoise& cell);
};

/// The one for this target; contract: it is available.
const MomentKernel& moment_kernel_of(numeric::VectorTarget target);

}  // namespace axiometry::iso230_2
