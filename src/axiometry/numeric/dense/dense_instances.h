// SPDX-License-Identifier: Apache-2.0
// No #pragma once: dense.h declares with it what dense.cpp defines with it, by AXIOMETRY_DENSE.

namespace Eigen {

// Members that no class defines in its body: the others are small, and are compiled where they are called.
AXIOMETRY_DENSE ColPivHouseholderQR<MatrixXd>& ColPivHouseholderQR<MatrixXd>::compute(const EigenBase<MatrixXd>&);
AXIOMETRY_DENSE void ColPivHouseholderQR<MatrixXd>::computeInPlace();
AXIOMETRY_DENSE void ColPivHouseholderQR<MatrixXd>::_solve_impl(const VectorXd&, VectorXd&) const;
AXIOMETRY_DENSE void ColPivHouseholderQR<MatrixXd>::_solve_impl(
    const CwiseNullaryOp<internal::scalar_identity_op<double>, MatrixXd>&, MatrixXd&) const;

AXIOMETRY_DENSE LDLT<MatrixXd>& LDLT<MatrixXd>::compute(const EigenBase<MatrixXd>&);
AXIOMETRY_DENSE void LDLT<MatrixXd>::_solve_impl(const VectorXd&, VectorXd&) const;
AXIOMETRY_DENSE void LDLT<MatrixXd>::_solve_impl(const MatrixXd&, MatrixXd&) const;
AXIOMETRY_DENSE void LDLT<MatrixXd>::_solve_impl(const CwiseNullaryOp<internal::scalar_identity_op<double>, MatrixXd>&,
                                                 MatrixXd&) const;
AXIOMETRY_DENSE LDLT<Matrix3d>& LDLT<Matrix3d>::compute(const EigenBase<Matrix3d>&);
AXIOMETRY_DENSE void LDLT<Matrix3d>::_solve_impl(const Vector3d&, Vector3d&) const;

AXIOMETRY_DENSE SelfAdjointEigenSolver<MatrixXd>& SelfAdjointEigenSolver<MatrixXd>::compute(const EigenBase<MatrixXd>&,
                                                                                            int);
AXIOMETRY_DENSE SelfAdjointEigenSolver<Matrix3d>& SelfAdjointEigenSolver<Matrix3d>::compute(const EigenBase<Matrix3d>&,
                                                                                            int);

AXIOMETRY_DENSE JacobiSVD<MatrixXd>& JacobiSVD<MatrixXd>::compute(const MatrixXd&, unsigned);
AXIOMETRY_DENSE JacobiSVD<Matrix3d>& JacobiSVD<Matrix3d>::compute(const Matrix3d&, unsigned);

// The kernels of products are Eigen's own business; these are those of its version 3.4.
#if EIGEN_WORLD_VERSION == 3 && EIGEN_MAJOR_VERSION == 4
namespace internal {

using DenseTraits = gebp_traits<double, double>;
template <int order>
using DenseRead = const_blas_data_mapper<double, Index, order>;
using DenseWritten = blas_data_mapper<double, Index, ColMajor>;

AXIOMETRY_DENSE struct gebp_kernel<double, double, Index, DenseWritten, DenseTraits::mr, DenseTraits::nr, false, false>;

#define AXIOMETRY_DENSE_PACK(order)                                                                                \
  AXIOMETRY_DENSE struct gemm_pack_lhs<double, Index, DenseRead<order>, DenseTraits::mr, DenseTraits::LhsProgress, \
                                       DenseTraits::LhsPacket4Packing, order>;                                     \
  AXIOMETRY_DENSE struct gemm_pack_rhs<double, Index, DenseRead<order>, DenseTraits::nr, order>
AXIOMETRY_DENSE_PACK(ColMajor);
AXIOMETRY_DENSE_PACK(RowMajor);
#undef AXIOMETRY_DENSE_PACK

AXIOMETRY_DENSE struct general_matrix_matrix_product<Index, double, ColMajor, false, double, ColMajor, false, ColMajor,
                                                     1>;
AXIOMETRY_DENSE struct general_matrix_matrix_product<Index, double, ColMajor, false, double, RowMajor, false, ColMajor,
                                                     1>;
AXIOMETRY_DENSE struct general_matrix_matrix_product<Index, double, RowMajor, false, double, ColMajor, false, ColMajor,
                                                     1>;

#define AXIOMETRY_DENSE_TIMES_VECTOR(order, vector_order, version)                                            \
  AXIOMETRY_DENSE struct general_matrix_vector_product<Index, double, DenseRead<order>, order, false, double, \
                                                       DenseRead<vector_order>, false, version>
AXIOMETRY_DENSE_TIMES_VECTOR(ColMajor, ColMajor, 0);
AXIOMETRY_DENSE_TIMES_VECTOR(ColMajor, RowMajor, 0);
AXIOMETRY_DENSE_TIMES_VECTOR(RowMajor, ColMajor, 0);
AXIOMETRY_DENSE_TIMES_VECTOR(RowMajor, RowMajor, 0);
AXIOMETRY_DENSE_TIMES_VECTOR(RowMajor, RowMajor, 1);
#undef AXIOMETRY_DENSE_TIMES_VECTOR

}  // namespace internal
#endif

}  // namespace Eigen

#undef AXIOMETRY_DENSE
