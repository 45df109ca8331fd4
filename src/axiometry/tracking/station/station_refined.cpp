// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "axiometry/base/contract.h"
#include "axiometry/model/station_bounds.h"
#include "axiometry/numeric/dense/dense.h"
#include "axiometry/numeric/distributions/chi_square.h"
#include "axiometry/tracking/station/station_fit.h"

namespace axiometry::tracking {
namespace {

constexpr double far_away = 1e6;  // in radii of the points: there the beams are parallel, and no start returns

Vector3 centre_of(std::span<const LocationPoint> points) {
  Vector3 centre;
  for (const LocationPoint& p : points) centre += 1.0 / static_cast<double>(points.size()) * p.at_mm;
  return centre;
}

double radius_of(std::span<const LocationPoint> points, Vector3 centre) {
  double squares = 0.0;
  for (const LocationPoint& p : points) squares += dot(p.at_mm - centre, p.at_mm - centre);
  return std::sqrt(squares / static_cast<double>(points.size()));
}

/// The unknowns s (about the centre of the points), L0 and, with a shape, its step; weights of one station.
class Descent {
 public:
  Descent(std::span<const LocationPoint> points, std::span<const double> shape)
      : points_(points), shape_(shape), centre_(centre_of(points)), radius_(radius_of(points, centre_)) {
    AXIOMETRY_CONTRACT(shape.empty() || shape.size() == points.size());
  }

  Eigen::Index unknowns() const { return shape_.empty() ? 4 : 5; }
  Vector3 station(const Eigen::VectorXd& z) const { return centre_ + Vector3{z[0], z[1], z[2]}; }

  void weigh(const StationOptions& options, Vector3 station) {
    sigma_.clear();
    for (const LocationPoint& p : points_)
      sigma_.push_back(length_sigma_mm(options, std::min(distance(p.at_mm, station), far_away * radius_)));
  }

  /// L0 as the mean demands it.
  Eigen::VectorXd start(Vector3 station) const {
    Eigen::VectorXd z = Eigen::VectorXd::Zero(unknowns());
    const Vector3 local = station - centre_;
    for (Eigen::Index k = 0; k < 3; ++k) z[k] = local[static_cast<std::size_t>(k)];
    for (const LocationPoint& p : points_)
      z[3] += (distance(p.at_mm, station) - p.length_difference_mm) / static_cast<double>(points_.size());
    return z;
  }

  double chi_squared(const Eigen::VectorXd& z) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const double r = residual(z, i) / sigma_[i];
      sum += r * r;
    }
    return sum;
  }

  /// Down from z; returns the iterations, negative when they did not end by themselves.
  int descend(Eigen::VectorXd& z) const {
    constexpr int most = 200;
    double lambda = 1e-3;
    double cost = chi_squared(z);
    Eigen::VectorXd right;
    for (int iteration = 1; iteration <= most; ++iteration) {
      const Eigen::MatrixXd rows = weighted_rows(z, right);
      bool fell = false;
      while (!fell && lambda < 1e12) {
        const Eigen::VectorXd step = damped_step(rows, right, lambda);
        // One more Gauss–Newton step squares the error: 1e-11 radii leave nothing that a double could hold.
        if (step.norm() <= 1e-13 * (radius_ + z.norm())) return iteration;
        const double trial = chi_squared(z + step);
        fell = trial < cost;
        if (fell) {
          z += step;
          cost = trial;
        }
        lambda = fell ? std::max(lambda / 10.0, 1e-15) : lambda * 10.0;
      }
      if (!fell) return iteration;
      if (z.head<3>().norm() > far_away * radius_) return -iteration;
    }
    return -most;
  }

 private:
  double residual(const Eigen::VectorXd& z, std::size_t i) const {
    return residual(z, i, distance(points_[i].at_mm, station(z)));
  }
  /// Where the length of the beam is known already.
  double residual(const Eigen::VectorXd& z, std::size_t i, double beam_mm) const {
    const double shift = shape_.empty() ? 0.0 : z[4] * shape_[i];
    return beam_mm - z[3] - shift - points_[i].length_difference_mm;
  }

  Eigen::MatrixXd weighted_rows(const Eigen::VectorXd& z, Eigen::VectorXd& right) const {
    const auto n = static_cast<Eigen::Index>(points_.size());
    Eigen::MatrixXd rows(n, unknowns());
    right.resize(n);
    const Vector3 s = station(z);
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      const Vector3 beam = points_[i].at_mm - s;
      const double length = norm(beam);
      const Vector3 u = length > 0.0 ? 1.0 / length * beam : Vector3{};
      rows(row, 0) = -u.x / sigma_[i];
      rows(row, 1) = -u.y / sigma_[i];
      rows(row, 2) = -u.z / sigma_[i];
      rows(row, 3) = -1.0 / sigma_[i];
      if (!shape_.empty()) rows(row, 4) = -shape_[i] / sigma_[i];
      right[row] = -residual(z, i, length) / sigma_[i];
    }
    return rows;
  }

  /// Levenberg–Marquardt, through an orthogonal decomposition: no squares of the condition.
  Eigen::VectorXd damped_step(const Eigen::MatrixXd& rows, const Eigen::VectorXd& right, double lambda) const {
    const Eigen::Index n = rows.rows(), k = rows.cols();
    Eigen::MatrixXd stacked(n + k, k);
    stacked.topRows(n) = rows;
    stacked.bottomRows(k) = Eigen::MatrixXd::Zero(k, k);
    for (Eigen::Index c = 0; c < k; ++c) stacked(n + c, c) = std::sqrt(lambda) * rows.col(c).norm();
    Eigen::VectorXd target = Eigen::VectorXd::Zero(n + k);
    target.head(n) = right;
    return stacked.colPivHouseholderQr().solve(target);
  }

  std::span<const LocationPoint> points_;
  std::span<const double> shape_;
  std::vector<double> sigma_;
  Vector3 centre_;
  double radius_;
};

/// Of many points as many as show where minima are.
constexpr std::size_t points_for_starts = 200;
constexpr double hopeless = 100.0;  // a start whose χ² is this many times the least is given up

struct Some {
  std::vector<LocationPoint> points;
  std::vector<double> shape;
};

/// Evenly, but in step with no grid (multiples of the golden section), and where the shape begins or ends.
Some some_of(std::span<const LocationPoint> points, std::span<const double> shape) {
  constexpr double golden = 0.61803398874989485;
  const double share = static_cast<double>(points_for_starts) / static_cast<double>(points.size());
  Some some;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool is_edge = !shape.empty() && i > 0 && shape[i] != shape[i - 1];
    const double turns = golden * static_cast<double>(i);
    if (turns - std::floor(turns) >= share && !is_edge) continue;
    some.points.push_back(points[i]);
    if (!shape.empty()) some.shape.push_back(shape[i]);
  }
  return some;
}

/// The different minima from all starts, the smallest χ² first.
std::vector<Minimum> minima_from(std::span<const LocationPoint> points, const StationOptions& options,
                                 std::span<const Vector3> starts, std::span<const double> shape) {
  const double radius = radius_of(points, centre_of(points));
  std::vector<Minimum> minima;
  for (const Vector3& start : starts) {
    const Minimum found = refine(points, options, start, shape);
    if (!is_finite(found.station_mm) || !std::isfinite(found.chi_squared)) continue;
    const auto same = std::ranges::find_if(
        minima, [&](const Minimum& m) { return distance(m.station_mm, found.station_mm) < 1e-4 * radius; });
    if (same == minima.end())
      minima.push_back(found);
    else if (found.chi_squared < same->chi_squared)
      *same = found;
  }
  std::ranges::stable_sort(minima, [](const Minimum& a, const Minimum& b) {
    return a.converged != b.converged ? a.converged : a.chi_squared < b.chi_squared;
  });
  return minima;
}

}  // namespace

double length_sigma_mm(const StationOptions& options, double distance_mm) {
  return std::hypot(options.ranging.standard_mm(distance_mm), options.machine_sigma_mm);
}

Minimum refine(std::span<const LocationPoint> points, const StationOptions& options, Vector3 start_mm,
               std::span<const double> shape) {
  Descent descent(points, shape);
  Eigen::VectorXd z = descent.start(start_mm);
  Minimum minimum;
  // σ depends weakly on the distance: what a round moves changes the weights of the next by 0.1 % of it at most
  for (int round = 0; round < 3; ++round) {
    descent.weigh(options, descent.station(z));
    const int iterations = descent.descend(z);
    minimum.iterations += static_cast<std::size_t>(std::abs(iterations));
    minimum.converged = iterations > 0;
    if (!minimum.converged) break;
  }
  descent.weigh(options, descent.station(z));
  minimum.station_mm = descent.station(z);
  minimum.L0_mm = z[3];
  minimum.step_mm = shape.empty() ? 0.0 : z[4];
  minimum.chi_squared = descent.chi_squared(z);
  return minimum;
}

std::vector<Vector3> starts_around(std::span<const LocationPoint> points, std::span<const Vector3> first) {
  std::vector<Vector3> starts(first.begin(), first.end());
  const Vector3 centre = centre_of(points);
  const double radius = radius_of(points, centre);
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const LocationPoint& p : points) {
    const Vector3 d = p.at_mm - centre;
    const Eigen::Vector3d e(d.x, d.y, d.z);
    spread += e * e.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);
  for (Eigen::Index k = 0; k < 3; ++k)
    for (const double side : {-2.0, 2.0}) {
      const Eigen::Vector3d e = axes.eigenvectors().col(k);
      starts.push_back(centre + side * radius * Vector3{e[0], e[1], e[2]});
    }
  return starts;
}

std::vector<Minimum> refine_from_all(std::span<const LocationPoint> points, const StationOptions& options,
                                     std::span<const Vector3> starts, std::span<const double> shape,
                                     double chi_squared_most) {
  if (points.size() <= 2 * points_for_starts) return minima_from(points, options, starts, shape);
  const Some some = some_of(points, shape);
  const std::vector<Minimum> rough = minima_from(some.points, options, starts, some.shape);
  if (std::isfinite(chi_squared_most) && !rough.empty() &&
      (rough.front().chi_squared > chi_squared_most || !rough.front().converged))
    return {};
  std::vector<Vector3> promising;
  for (const Minimum& m : rough)
    if (m.chi_squared <= hopeless * (rough.front().chi_squared + static_cast<double>(some.points.size())))
      promising.push_back(m.station_mm);
  return minima_from(points, options, promising.empty() ? starts : promising, shape);
}

RefinedSolution describe(std::span<const LocationPoint> points, const StationOptions& options, const Minimum& minimum) {
  RefinedSolution solution;
  RefinedFit& fit = solution.fit;
  fit.station_mm = minimum.station_mm;
  fit.L0_mm = minimum.L0_mm;
  fit.iterations = minimum.iterations;
  fit.converged = minimum.converged;
  const auto n = static_cast<Eigen::Index>(points.size());
  Eigen::MatrixXd rows(n, 4), weighted(n, 4);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector3 beam = points[i].at_mm - fit.station_mm;
    const double length = norm(beam);
    const Vector3 u = length > 0.0 ? 1.0 / length * beam : Vector3{};
    const double sigma = length_sigma_mm(options, length);
    const double residual = length - fit.L0_mm - points[i].length_difference_mm;
    const auto row = static_cast<Eigen::Index>(i);
    rows.row(row) << -u.x, -u.y, -u.z, -1.0;
    weighted.row(row) = rows.row(row) / sigma;
    solution.distances_mm.push_back(length);
    fit.sigma_mm.push_back(sigma);
    fit.residuals_mm.push_back(residual);
    fit.chi_squared += residual / sigma * (residual / sigma);
  }
  const Eigen::VectorXd values = rows.jacobiSvd().singularValues();
  fit.singular_values.assign(values.begin(), values.end());
  fit.condition = values[0] / std::max(values[3], epsilon * values[0]);

  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(weighted, Eigen::ComputeThinU | Eigen::ComputeThinV);
  const Eigen::VectorXd floored = svd.singularValues().cwiseMax(epsilon * svd.singularValues()[0]);
  const Eigen::MatrixXd half = svd.matrixV() * floored.cwiseInverse().asDiagonal();
  const Eigen::Matrix4d covariance = half * half.transpose();
  const Eigen::MatrixXd inverse = half * svd.matrixU().transpose();  // s per change of ΔL_i/σ_i, sign reversed twice
  for (Eigen::Index i = 0; i < n; ++i) {
    const double sigma = fit.sigma_mm[static_cast<std::size_t>(i)];
    solution.gain.push_back({inverse(0, i) / sigma, inverse(1, i) / sigma, inverse(2, i) / sigma});
  }
  const Eigen::Matrix3d of_place = covariance.topLeftCorner<3, 3>();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(of_place);
  const Eigen::Vector3d weakest = axes.eigenvectors().col(2);
  solution.weakest = {weakest[0], weakest[1], weakest[2]};
  solution.weakest_u_mm = std::sqrt(std::max(axes.eigenvalues()[2], 0.0));

  fit.degrees_of_freedom = points.size() - 4;
  fit.chance = numeric::chi_square_tail(fit.chi_squared, fit.degrees_of_freedom);
  fit.inflation = inflation_of(fit.chi_squared, fit.degrees_of_freedom);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      fit.covariance_stated_mm2[i][k] = covariance(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k));
      fit.covariance_mm2[i][k] = fit.inflation * fit.covariance_stated_mm2[i][k];
    }
  fit.L0_variance_mm2 = fit.inflation * covariance(3, 3);
  return solution;
}

}  // namespace axiometry::tracking
