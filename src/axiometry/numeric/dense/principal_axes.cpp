// SPDX-License-Identifier: Apache-2.0
#include "axiometry/numeric/dense/principal_axes.h"

#include "axiometry/base/contract.h"
#include "axiometry/numeric/dense/dense.h"

namespace axiometry::numeric {

PrincipalAxes principal_axes(std::span<const double> symmetric, std::size_t n) {
  AXIOMETRY_CONTRACT(n > 0 && symmetric.size() == n * n);
  const auto size = static_cast<Eigen::Index>(n);
  const Eigen::MatrixXd matrix = Eigen::Map<const Eigen::MatrixXd>(symmetric.data(), size, size);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix);
  const auto& vectors = solver.eigenvectors();
  return {{solver.eigenvalues().begin(), solver.eigenvalues().end()},
          {vectors.data(), vectors.data() + vectors.size()}};
}

}  // namespace axiometry::numeric
