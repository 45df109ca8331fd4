// SPDX-License-Identifier: Apache-2.0
#include "axiometry/numeric/curve_axes.h"

#include <cmath>

#include "axiometry/base/contract.h"
#include "axiometry/numeric/dense/dense.h"

namespace axiometry::numeric {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Correlation of the smooth part at a distance of r lengths: Matérn with ν = 5/2.
double matern(double r) {
  const double x = std::sqrt(5.0) * r;
  return (1.0 + x + x * x / 3.0) * std::exp(-x);
}

MatrixXd trend_of(std::span<const double> places, std::size_t terms) {
  const auto m = static_cast<Eigen::Index>(places.size());
  const double middle = 0.5 * (places.front() + places.back());
  const double half = 0.5 * (places.back() - places.front());
  MatrixXd trend(m, static_cast<Eigen::Index>(terms));
  for (Eigen::Index i = 0; i < m; ++i) {
    trend(i, 0) = 1.0;
    if (terms == 2) trend(i, 1) = (places[i] - middle) / half;
  }
  return trend;
}

}  // namespace

std::vector<double> trend_columns(std::span<const double> places, std::size_t terms) {
  const MatrixXd trend = trend_of(places, terms);
  const MatrixXd columns = orthonormal_basis(trend);
  return {columns.data(), columns.data() + columns.size()};
}

CurveAxes::CurveAxes(std::span<const double> places, std::size_t terms_, double length) {
  AXIOMETRY_CONTRACT((terms_ == 1 || terms_ == 2) && places.size() >= terms_);
  const auto m = static_cast<Eigen::Index>(places.size());
  const auto terms = static_cast<Eigen::Index>(terms_);
  // The first columns span the polynomials of the trend.
  MatrixXd basis = completed_orthonormal_basis(trend_of(places, terms_));
  VectorXd variances = VectorXd::Zero(m);
  if (m > terms) {
    MatrixXd covariance(m, m);
    for (Eigen::Index i = 0; i < m; ++i)
      for (Eigen::Index j = 0; j < m; ++j) covariance(i, j) = matern(std::abs(places[i] - places[j]) / length);
    const MatrixXd rest = basis.rightCols(m - terms);
    const MatrixXd beside_trend = rest.transpose() * covariance * rest;
    const Eigen::SelfAdjointEigenSolver<MatrixXd> axes(beside_trend);
    basis.rightCols(m - terms) = rest * axes.eigenvectors();
    variances.tail(m - terms) = axes.eigenvalues().cwiseMax(0.0);
  }
  columns.assign(basis.data(), basis.data() + basis.size());
  smooth.assign(variances.begin(), variances.end());
}

std::vector<double> CurveAxes::coordinates(std::span<const double> values) const {
  const auto m = static_cast<Eigen::Index>(smooth.size());
  AXIOMETRY_CONTRACT(values.size() == smooth.size());
  const MatrixXd basis = Eigen::Map<const MatrixXd>(columns.data(), m, m);
  const VectorXd found = basis.transpose() * Eigen::Map<const VectorXd>(values.data(), m);
  return {found.begin(), found.end()};
}

}  // namespace axiometry::numeric
