// SPDX-License-Identifier: Apache-2.0
#include "axiometry/numeric/dense/dense.h"

#define AXIOMETRY_DENSE template
#include "axiometry/numeric/dense/dense_instances.h"

namespace axiometry::numeric {

using Eigen::MatrixXd;

MatrixXd orthonormal_basis(const MatrixXd& columns) {
  return Eigen::HouseholderQR<MatrixXd>(columns).householderQ() * MatrixXd::Identity(columns.rows(), columns.cols());
}

MatrixXd pivoted_orthonormal_basis(const MatrixXd& columns) {
  return columns.colPivHouseholderQr().householderQ() * MatrixXd::Identity(columns.rows(), columns.cols());
}

MatrixXd completed_orthonormal_basis(const MatrixXd& columns) {
  return Eigen::HouseholderQR<MatrixXd>(columns).householderQ();
}

MatrixXd cofactor(const Eigen::ColPivHouseholderQR<MatrixXd>& decomposed) {
  const Eigen::Index p = decomposed.cols();
  const MatrixXd inverse =
      decomposed.matrixR().topLeftCorner(p, p).triangularView<Eigen::Upper>().solve(MatrixXd::Identity(p, p));
  const MatrixXd ordered = decomposed.colsPermutation() * inverse;  // rows back in their order
  return ordered * ordered.transpose();
}

MatrixXd inverse(const MatrixXd& matrix) { return matrix.inverse(); }

}  // namespace axiometry::numeric
