// SPDX-License-Identifier: Apache-2.0
#include "axiometry/tracking/ranges/range_solution.h"

#include <cmath>
#include <limits>

#include "axiometry/numeric/dense/dense.h"
#include "axiometry/tracking/ranges/range_eigen.h"

namespace axiometry::tracking::detail {
namespace {

/// The stations' unknowns after a step.
RangeState moved(const RangeProblem& problem, const RangeState& state, std::span<const double> y) {
  const RangeLayout& layout = problem.layout;
  RangeState next = state;
  for (std::size_t j = 0; j < layout.stations; ++j) {
    const std::size_t at = layout.station_column(j);
    next.stations[j] += Vector3{y[at], y[at + 1], y[at + 2]};
    if (layout.free_scales) next.scales[j] += y[at + 3] / problem.weighting.scale_length_mm;
  }
  for (std::size_t k = 0; k < next.dead.size(); ++k) next.dead[k] += y[layout.segment_column(k)];
  return next;
}

Eigen::Vector3d mean_of(std::span<const Vector3> points) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Vector3& p : points) mean += eigen(p) / static_cast<double>(points.size());
  return mean;
}

}  // namespace

RangeIteration iterate(const RangeProblem& problem, RangeState& state) {
  const ReductionInput input = problem.input();
  const double still = 1e-10 * problem.weighting.scale_length_mm;
  const auto readings = static_cast<double>(problem.layout.readings());
  RangeIteration run{reduce(input, state, std::nullopt, 0.0)};
  double damping = 0.0;
  while (run.iterations < problem.iterations_most && !run.converged && !problem.stop.stop_requested()) {
    ++run.iterations;
    const std::vector<double> y = reduced_step(run.system, problem.gauge(state));
    RangeState next = moved(problem, state, y);
    const double damping_next = damping > 1e-6 ? 0.1 * damping : 0.0;
    ReducedSystem tried = reduce(input, next, ReducedStep{y, run.system.damping, state}, damping_next);
    // Weights follow the distances, so that χ² of the same residuals may change a little.
    const double before = run.system.chi_squared, after = tried.chi_squared;
    if (after <= 1.001 * before + 1e-9 * readings) {
      const bool quiet = std::abs(after - before) <= 1e-11 * after + 1e-14 * readings && run.iterations > 2;
      run.converged = damping == 0.0 && (tried.largest_move_mm <= still || quiet);
      state = std::move(next);
      run.system = std::move(tried);
      damping = damping_next;
    } else {
      damping = std::max(10.0 * damping, 1e-4);
      if (!(damping < 1e9)) break;
      run.system = reduce(input, state, std::nullopt, damping);
    }
  }
  if (run.system.damping > 0.0) run.system = reduce(input, state, std::nullopt, 0.0);
  return run;
}

StationSpread station_spread(std::span<const Vector3> stations) {
  const Eigen::Vector3d mean = mean_of(stations);
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  for (const Vector3& s : stations) {
    const Eigen::Vector3d off = eigen(s) - mean;
    moments += off * off.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(moments);
  StationSpread spread;
  for (const Vector3& s : stations) {
    const Eigen::Vector3d off = eigen(s) - mean;
    spread.off_plane_mm = std::max(spread.off_plane_mm, std::abs(off.dot(solver.eigenvectors().col(0))));
    spread.off_line_mm = std::max(spread.off_line_mm, off.cross(solver.eigenvectors().col(2)).norm());
  }
  return spread;
}

std::size_t coplanar_null_directions(std::size_t stations, bool free_scales) {
  const std::size_t enough = free_scales ? 8 : 6;
  return stations < enough ? enough - stations : 0;
}

bool align(RangeState& state, std::span<const Vector3> nominal, bool with_size) {
  const Eigen::Vector3d to = mean_of(nominal), from = mean_of(state.points);
  Eigen::Matrix3d product = Eigen::Matrix3d::Zero();
  double squares = 0.0;
  for (std::size_t i = 0; i < nominal.size(); ++i) {
    const Eigen::Vector3d p = eigen(state.points[i]) - from, q = eigen(nominal[i]) - to;
    product += q * p.transpose();
    squares += p.squaredNorm();
  }
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(product, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d turn = svd.matrixU() * svd.matrixV().transpose();
  Eigen::Vector3d gain = svd.singularValues();
  // Without a third extent nothing says which image it is: then a turn.
  const bool mirrored = turn.determinant() < 0.0 && gain[2] > 1e-9 * gain[0];
  if (turn.determinant() < 0.0 && !mirrored) {
    Eigen::Matrix3d u = svd.matrixU();
    u.col(2) = -u.col(2);
    turn = u * svd.matrixV().transpose();
    gain[2] = -gain[2];
  }
  const double size = with_size && squares > 0.0 ? gain.sum() / squares : 1.0;
  const auto put = [&](Vector3& v) { v = vector(to + size * (turn * (eigen(v) - from))); };
  for (Vector3& p : state.points) put(p);
  for (Vector3& s : state.stations) put(s);
  for (double& kappa : state.scales) kappa /= size;
  return mirrored;
}

}  // namespace axiometry::tracking::detail
