// SPDX-License-Identifier: Apache-2.0
//
// Deviations from the paper: centred and scaled columns, a singular value decomposition in place of normal equations,
// and the quadratic ψ = |s|² − L0² along the weakest direction, which the paper leaves unused.
#include <algorithm>
#include <cmath>

#include "axiometry/base/contract.h"
#include "axiometry/numeric/dense/dense.h"
#include "axiometry/tracking/station/station_fit.h"

namespace axiometry::tracking {
namespace {

using Vector5 = Eigen::Matrix<double, 5, 1>;

/// Points and lengths about their means, in units of the rms radius.
struct Scaled {
  Vector3 centre_mm;
  double length_centre_mm = 0.0;
  double scale_mm = 1.0;
  Eigen::MatrixXd matrix;  ///< rows [2p, 2ΔL, −1]
  Eigen::VectorXd right;   ///< |p|² − ΔL²
};

Scaled scaled(std::span<const LocationPoint> points) {
  Scaled s;
  const double n = static_cast<double>(points.size());
  for (const LocationPoint& p : points) {
    s.centre_mm += 1.0 / n * p.at_mm;
    s.length_centre_mm += p.length_difference_mm / n;
  }
  double squares = 0.0;
  for (const LocationPoint& p : points) squares += dot(p.at_mm - s.centre_mm, p.at_mm - s.centre_mm);
  s.scale_mm = std::sqrt(squares / n);
  AXIOMETRY_CONTRACT(s.scale_mm > 0.0);
  s.matrix.resize(static_cast<Eigen::Index>(points.size()), 5);
  s.right.resize(static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector3 p = 1.0 / s.scale_mm * (points[i].at_mm - s.centre_mm);
    const double length = (points[i].length_difference_mm - s.length_centre_mm) / s.scale_mm;
    const auto row = static_cast<Eigen::Index>(i);
    s.matrix.row(row) << 2.0 * p.x, 2.0 * p.y, 2.0 * p.z, 2.0 * length, -1.0;
    s.right[row] = dot(p, p) - length * length;
  }
  return s;
}

Vector3 station_of(const Vector5& x, const Scaled& s) { return s.centre_mm + s.scale_mm * Vector3{x[0], x[1], x[2]}; }

/// Stations x0 + t v with ψ = |s|² − L0²: a quadratic in t.
std::vector<Vector3> candidates_along(const Vector5& x0, const Vector5& v, const Scaled& s) {
  const auto form = [](const Vector5& a, const Vector5& b) { return a.head<3>().dot(b.head<3>()) - a[3] * b[3]; };
  const double a = form(v, v);
  const double half_b = form(x0, v) - v[4] / 2.0;
  const double c = form(x0, x0) - x0[4];
  std::vector<double> roots;
  // b t² of a parabola: beyond 1e8 radii a root is no station
  if (std::abs(a) < 1e-12) {
    if (half_b != 0.0) roots = {-c / (2.0 * half_b)};
  } else {
    const double root = std::sqrt(std::max(half_b * half_b - a * c, 0.0));
    const double far = half_b > 0.0 ? -half_b - root : -half_b + root;
    roots = {far / a};
    if (far != 0.0) roots.push_back(c / far);
  }
  std::vector<Vector3> stations;
  for (double t : roots)
    if (const Vector3 station = station_of(x0 + t * v, s); is_finite(station)) stations.push_back(station);
  return stations;
}

void describe_solution(LinearEstimate& result, const Vector5& x, const Eigen::MatrixXd& inverse, const Scaled& s,
                       std::span<const LocationPoint> points) {
  LinearFit& fit = result.fit;
  const double r = s.scale_mm;
  const Vector3 local = r * Vector3{x[0], x[1], x[2]};  // relative to the centre
  const double local_L0 = r * x[3];
  fit.station_mm = s.centre_mm + local;
  fit.L0_mm = local_L0 - s.length_centre_mm;
  fit.misclosure_mm2 = r * r * (x[4] - x.head<3>().squaredNorm() + x[3] * x[3]);
  fit.psi_mm2 = fit.misclosure_mm2 + dot(fit.station_mm, fit.station_mm) - fit.L0_mm * fit.L0_mm;
  const Eigen::VectorXd misfit = r * r * (s.matrix * x - s.right);
  fit.equation_residuals_mm2.assign(misfit.begin(), misfit.end());
  fit.redundant_residual_mm2 = misfit.norm();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double length = distance(points[i].at_mm, fit.station_mm);
    fit.residuals_mm.push_back(length - fit.L0_mm - points[i].length_difference_mm);
    // d(row · x − right)/dΔL = 2 (L0 + ΔL) = 2 L: x changes by −M⁺ of it
    const double slope = -2.0 * (fit.L0_mm + points[i].length_difference_mm) / r;
    const auto column = static_cast<Eigen::Index>(i);
    const Vector3 gain{slope * inverse(0, column), slope * inverse(1, column), slope * inverse(2, column)};
    result.gain.push_back(gain);
    result.misclosure_gain.push_back(slope * r * inverse(4, column) - 2.0 * dot(local, gain) +
                                     2.0 * local_L0 * slope * inverse(3, column));
  }
}

}  // namespace

LinearEstimate solve_linear(std::span<const LocationPoint> points) {
  AXIOMETRY_CONTRACT(points.size() >= 4);
  const Scaled s = scaled(points);
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(s.matrix, Eigen::ComputeThinU | Eigen::ComputeFullV);
  const Eigen::VectorXd& values = svd.singularValues();
  LinearEstimate result;
  result.count = points.size();
  result.scale_mm = s.scale_mm;
  LinearFit& fit = result.fit;
  fit.singular_values.assign(values.begin(), values.end());
  fit.singular_values.resize(5, 0.0);
  const double rounding = static_cast<double>(points.size()) * epsilon * values[0];
  fit.numerical_rank =
      static_cast<std::size_t>(std::ranges::count_if(fit.singular_values, [&](double x) { return x > rounding; }));
  fit.condition = values[0] / std::max(fit.singular_values[4], epsilon * values[0]);
  for (Eigen::Index k = 0; k < 5; ++k)
    for (Eigen::Index row = 0; row < 5; ++row)
      result.directions[static_cast<std::size_t>(k)][static_cast<std::size_t>(row)] = svd.matrixV()(row, k);

  Vector5 without_last = Vector5::Zero();
  for (Eigen::Index k = 0; k < 4; ++k)
    if (values[k] > rounding) without_last += svd.matrixV().col(k) * (svd.matrixU().col(k).dot(s.right) / values[k]);
  const Vector5 last = svd.matrixV().col(4);
  result.candidates = candidates_along(without_last, last, s);
  if (fit.numerical_rank == 5) {
    const Eigen::MatrixXd inverse = svd.matrixV() * values.cwiseInverse().asDiagonal() * svd.matrixU().transpose();
    const Vector5 x = without_last + last * (svd.matrixU().col(4).dot(s.right) / values[4]);
    describe_solution(result, x, inverse, s, points);
  }
  return result;
}

void judge_rank(LinearEstimate& solution, const MatrixNoise& noise) {
  LinearFit& fit = solution.fit;
  const double n = static_cast<double>(solution.count);
  const auto tolerance = [&](std::size_t k) {
    const auto& v = solution.directions[k];
    const double along = std::hypot(std::hypot(v[0], v[1], v[2]) * noise.point_mm, v[3] * noise.length_mm);
    return 3.0 * std::sqrt(n) * 2.0 / solution.scale_mm * along + n * epsilon * fit.singular_values[0];
  };
  fit.rank = 0;
  for (std::size_t k = 0; k < 5; ++k) fit.rank += fit.singular_values[k] > tolerance(k) ? 1 : 0;
  fit.rank_tolerance = tolerance(4);
}

}  // namespace axiometry::tracking
