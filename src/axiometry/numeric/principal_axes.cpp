// SPDX-License-Identifier: Apache-2.0
#include "axiometry/numeric/principal_axes.h"

#include <Eigen/Dense>

#include "axiometry/base/contract.h"

namespace axiometry::numeric {

PrincipalAxes principal_axes(std::span<const double> symmetric, std::size_t n) {
  AXIOMETRY_CONTRACT(n > 0 && symmetric.size() == n * n);
  const auto size = static_cast<Eigen::Index>(n);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(
      Eigen::Map<const Eigen::MatrixXd>(symmetric.data(), size, size));
  const auto& vectors = solver.eigenvectors();
  return {{solver.eigenvalues().begin(), solver.eigenvalues().end()},
          {vectors.data(), vectors.data() + vectors.size()}};
}

}  // namespace axiometry::numeric
