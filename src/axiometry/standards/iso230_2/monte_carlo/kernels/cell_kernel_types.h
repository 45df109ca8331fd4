// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "axiometry/numeric/vector_target.h"

namespace axiometry::iso230_2 {

// What posterior.h does for many trials, a number for each in every row; symbols as there. Rows lie a stride apart.

/// From μ to the mean of a cell's own approaches, and the machine's share of the scatter.
struct CellShare {
  std::size_t trials = 0;
  double observed_mean = 0.0;     ///< x̄
  double count = 0.0;             ///< n
  double noise_variance = 0.0;    ///< u²
  double own_variance = 0.0;      ///< variance that the direction has of its own
  const double* sds = nullptr;    ///< σ
  const double* shift = nullptr;  ///< δ with the sign that it has here; null where there is none
  const double* direction_normals = nullptr;
  const double* reading_normals = nullptr;
  double* means = nullptr;     ///< means, read and written
  double* machines = nullptr;  ///< out
};

/// The machine's part of the shifts of the runs.
struct RunShares {
  std::size_t trials = 0;
  std::size_t cells = 0;
  std::size_t runs = 0;
  double noise_variance = 0.0;  ///< u²
  double measured = 0.0;        ///< u_d² + u²/C
  double cells_per_run = 0.0;   ///< C
  const double* sds = nullptr;  ///< σ, a row for each cell
  const double* run_sds = nullptr;
  const double* observed = nullptr;  ///< shift of each run
  const double* normals = nullptr;   ///< a row for each run
  double* shifts = nullptr;          ///< out: a row for each run
};

/// The readings of one cell, of those runs that have one.
struct NoisyCell {
  std::size_t trials = 0;
  std::size_t count = 0;              ///< n
  double noise_sd = 0.0;              ///< u
  const double* residuals = nullptr;  ///< residual of each reading
  const double* means = nullptr;
  const double* machines = nullptr;
  const double* const* shifts = nullptr;  ///< a row for each reading
  const double* normals = nullptr;        ///< a row for each reading; not read without noise
  double* const* readings = nullptr;      ///< out: a row for each reading
};

/// x̄ (3.13) and s (3.18) of a cell whose readings lie a·e too low and b too high.
struct MovedCell {
  std::size_t trials = 0;
  std::size_t count = 0;                    ///< n ≥ 1
  const double* const* readings = nullptr;  ///< a row for each
  double position = 0.0;                    ///< a
  const double* length_errors = nullptr;    ///< e; null where there are none
  const double* position_errors = nullptr;  ///< b; null where there are none
  double* means = nullptr;
  double* estimators = nullptr;  ///< 0 for n = 1
};

struct CellKernel {
  void (*share)(const CellShare& cell);
  void (*run_shifts)(const RunShares& runs);
  void (*readings)(const NoisyCell& cell);
  void (*moments)(const MovedCell& cell);
};

/// The one for this target; contract: it is available.
const CellKernel& cell_kernel_of(numeric::VectorTarget target);

}  // namespace axiometry::iso230_2
