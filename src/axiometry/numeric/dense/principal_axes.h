// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace axiometry::numeric {

/// Eigenvalues of a symmetric matrix, ascending, and orthonormal eigenvectors, one after the other.
struct PrincipalAxes {
  std::vector<double> values;
  std::vector<double> vectors;

  std::span<const double> axis(std::size_t k) const {
    return std::span(vectors).subspan(k * values.size(), values.size());
  }
};

/// Contract: n × n numbers.
PrincipalAxes principal_axes(std::span<const double> symmetric, std::size_t n);

}  // namespace axiometry::numeric
