// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "axiometry/numeric/vector_target.h"

namespace axiometry::numeric {

/// Curves that are followed together, each with a ratio of variances of its own. Tables of them have a row of so many
/// numbers for each place.
inline constexpr std::size_t matern_lanes = 8;

/// From the place before to this one: the state is A times the one before, and noise of the covariance Q = C Cᵀ. For
/// the first place A = 0 and Q is the covariance of the process itself.
struct MaternStep {
  double transition[9];  ///< A, by rows
  double noise[6];       ///< Q: 00, 01, 02, 11, 12, 22
  double root[6];        ///< C: 00, 10, 11, 20, 21, 22
};

struct MaternCurve {
  const MaternStep* steps = nullptr;  ///< step to every place
  std::size_t places = 0;
  const double* trend[2] = {nullptr, nullptr};  ///< columns of so many numbers; zeros where there is one alone
};

/// Sums over the places of products of innovations over their variances: xᵀ(λK + 1)⁻¹ z.
struct MaternSums {
  double values[matern_lanes];           ///< sums of the values with themselves
  double values_trend[2][matern_lanes];  ///< sums of the values with each column of the trend
  double trend[3][matern_lanes];         ///< sums of the columns: 00, 01, 11
};

/// Places whose variances of innovations are multiplied before their logarithm is taken: λ up to 1e37 does not
/// overflow.
inline constexpr std::size_t matern_product = 8;
/// Numbers that the way back needs of each place and lane: innovations over their variance of values and of both
/// columns of the trend, and the gain.
inline constexpr std::size_t matern_kept = 6;

struct MaternKernel {
  /// Forward: `values` a row for each place. `products` a row for each `matern_product` places. `kept` nullptr, or
  /// `matern_kept` rows for each place.
  void (*filter)(const MaternCurve& curve, const double* ratios, const double* values, MaternSums& sums,
                 double* products, double* kept);
  /// Back: (λK + 1)⁻¹ (x − T β) to `results`, a row for each place; `factors` a row for each column of the trend.
  void (*smooth)(const MaternCurve& curve, const double* kept, const double* factors, double* results);
  /// Curves of the process from three rows of standard normal numbers for each place.
  void (*simulate)(const MaternCurve& curve, const double* normals, double* values);
};

/// The one for this target; contract: it is available.
const MaternKernel& matern_kernel_of(VectorTarget target);

}  // namespace axiometry::numeric
