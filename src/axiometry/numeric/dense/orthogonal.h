// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/numeric/dense/dense.h"

/// Equations by orthogonal transformations of their rows: what they tell is known to the digits of a double, where the
/// squares of normal equations leave half of these.
namespace axiometry::numeric {

/// P R⁻¹ of A P = Q R: times its transpose it is (AᵀA)⁻¹. A has full rank and no more columns than rows.
Eigen::MatrixXd inverse_of_triangle(const Eigen::ColPivHouseholderQR<Eigen::MatrixXd>& decomposed);

/// Qᵀ v of it.
Eigen::VectorXd turned_right(const Eigen::ColPivHouseholderQR<Eigen::MatrixXd>& decomposed, const Eigen::VectorXd& v);

/// R of A = Q R: as many rows as columns. A has no fewer rows than columns.
Eigen::MatrixXd triangle_of(const Eigen::MatrixXd& rows);

/// Rows after the reflections that leave 0 below the diagonal of the first columns.
Eigen::MatrixXd first_columns_eliminated(const Eigen::MatrixXd& rows, Eigen::Index columns);

}  // namespace axiometry::numeric
