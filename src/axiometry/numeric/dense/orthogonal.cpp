// SPDX-License-Identifier: Apache-2.0
#include "axiometry/numeric/dense/orthogonal.h"

namespace axiometry::numeric {

using Eigen::MatrixXd;

MatrixXd inverse_of_triangle(const Eigen::ColPivHouseholderQR<MatrixXd>& decomposed) {
  const Eigen::Index p = decomposed.cols();
  const MatrixXd inverse =
      decomposed.matrixR().topLeftCorner(p, p).triangularView<Eigen::Upper>().solve(MatrixXd::Identity(p, p));
  return decomposed.colsPermutation() * inverse;  // rows back in their order
}

Eigen::VectorXd turned_right(const Eigen::ColPivHouseholderQR<MatrixXd>& decomposed, const Eigen::VectorXd& v) {
  return decomposed.householderQ().adjoint() * v;
}

MatrixXd triangle_of(const MatrixXd& rows) {
  const Eigen::HouseholderQR<MatrixXd> qr(rows);
  return qr.matrixQR().topRows(rows.cols()).triangularView<Eigen::Upper>();
}

MatrixXd first_columns_eliminated(const MatrixXd& rows, Eigen::Index columns) {
  const Eigen::HouseholderQR<MatrixXd> qr(rows.leftCols(columns));
  MatrixXd turned = rows;
  turned.applyOnTheLeft(qr.householderQ().adjoint());
  return turned;
}

}  // namespace axiometry::numeric
