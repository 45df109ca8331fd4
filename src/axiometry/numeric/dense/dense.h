// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Dense>

/// Eigen for matrices whose size is known when the program runs. Its decompositions and the kernels of its products are
/// compiled once, in dense.cpp, and only declared elsewhere: they are most of what a source that decomposes a matrix is
/// compiled for. Include this in place of Eigen's own headers; what it computes is the same to the last bit.
///
/// What is not declared here (other types, other right-hand sides) works too and is compiled where it stands.
namespace axiometry::numeric {

/// An orthonormal basis of what the columns span, by Householder's reflections in their order.
/// Columns that depend on each other are no basis: then some directions are arbitrary.
Eigen::MatrixXd orthonormal_basis(const Eigen::MatrixXd& columns);

/// Likewise, the longest column that is left first.
Eigen::MatrixXd pivoted_orthonormal_basis(const Eigen::MatrixXd& columns);

/// An orthonormal basis of the whole space, whose first vectors span what the columns span.
Eigen::MatrixXd completed_orthonormal_basis(const Eigen::MatrixXd& columns);

/// (RᵀR)⁻¹ of A P = Q R, in the order of the columns of A: (AᵀA)⁻¹. A has full rank and no more columns than rows.
Eigen::MatrixXd cofactor(const Eigen::ColPivHouseholderQR<Eigen::MatrixXd>& decomposed);

/// Of a square matrix of full rank.
Eigen::MatrixXd inverse(const Eigen::MatrixXd& matrix);

}  // namespace axiometry::numeric

#define AXIOMETRY_DENSE extern template
#include "axiometry/numeric/dense/dense_instances.h"
