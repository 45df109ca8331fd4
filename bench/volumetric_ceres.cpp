// SPDX-License-Identifier: Apache-2.0
#include <ceres/ceres.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

/// The 21 errors of a machine by Ceres, the problem of bench/compare_scipy_volumetric.py, which writes the lengths and
/// calls this: XFYZ, cubic B-splines of eight spans, ten virtual stations, analytic derivatives. The gauge holds the
/// first spline of each curve, and of straightness the last one too: 217 unknowns. DENSE_NORMAL_CHOLESKY with LAPACK,
/// its fastest here. Prints seconds, steps and χ²: squareness itself is in its slopes of straightness too.
namespace {

using Vector = std::array<double, 3>;

constexpr std::size_t spans = 8, functions = spans + 3, motions = 6, axes = 3;
constexpr Vector lowest = {0.0, 0.0, -500.0}, highest = {1000.0, 600.0, 0.0};
constexpr std::size_t active = 4;  // cubic B-splines at a place

/// As bench/compare_scipy_volumetric.py writes it: where the axes and the reflector are, where the station is said to
/// be, the weight 1/σ, the virtual station, the length.
struct Reading {
  Vector q{}, reflector{}, tool{}, station{};
  double weight = 0.0, length = 0.0;
  std::size_t virtual_station = 0;
};

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Parameters: four blocks of six motions for each axis, squareness, place and dead path of the station; µm, µrad.
class Length : public ceres::CostFunction {
 public:
  explicit Length(const Reading& reading) : reading_(reading) {
    set_num_residuals(1);
    for (std::size_t k = 0; k < axes * active; ++k) mutable_parameter_block_sizes()->push_back(motions);
    mutable_parameter_block_sizes()->push_back(3);
    mutable_parameter_block_sizes()->push_back(4);
    for (std::size_t a = 0; a < axes; ++a) {
      const double along = (reading.q[a] - lowest[a]) / (highest[a] - lowest[a]) * spans;
      first_[a] = static_cast<std::size_t>(std::clamp(std::floor(along), 0.0, spans - 1.0));
      const double t = along - static_cast<double>(first_[a]), s = 1.0 - t;
      values_[a] = {s * s * s / 6.0, (3 * t * t * t - 6 * t * t + 4) / 6.0,
                    (-3 * t * t * t + 3 * t * t + 3 * t + 1) / 6.0, t * t * t / 6.0};
    }
    const Vector &q = reading.q, &t = reading.tool;
    levers_ = {Vector{1e-3 * (q[0] + t[0]), 1e-3 * (q[1] + t[1]), 1e-3 * (q[2] + t[2])},
               Vector{1e-3 * t[0], 1e-3 * t[1], 1e-3 * (q[2] + t[2])}, Vector{1e-3 * t[0], 1e-3 * t[1], 1e-3 * t[2]}};
  }
  std::size_t first(std::size_t axis) const { return first_[axis]; }

  bool Evaluate(double const* const* x, double* residual, double** jacobian) const override {
    const double *square = x[axes * active], *own = x[axes * active + 1];
    const double y = 1e-3 * reading_.q[1], z = 1e-3 * reading_.q[2];
    Vector delta = {-square[0] * y + square[1] * z, -square[2] * z, 0.0};
    for (std::size_t a = 0; a < axes; ++a) {
      std::array<double, motions> e{};
      for (std::size_t k = 0; k < active; ++k)
        for (std::size_t m = 0; m < motions; ++m) e[m] += values_[a][k] * x[a * active + k][m];
      const Vector turned = cross({e[3], e[4], e[5]}, levers_[a]);
      for (std::size_t c = 0; c < 3; ++c) delta[c] += e[c] + turned[c];
    }
    Vector u{};
    double squared = 0.0;
    for (std::size_t c = 0; c < 3; ++c) {
      u[c] = reading_.reflector[c] + 1e-3 * delta[c] - (reading_.station[c] + 1e-3 * own[c]);
      squared += u[c] * u[c];
    }
    const double far = std::sqrt(squared), w = reading_.weight;
    for (double& c : u) c /= far;
    residual[0] = w * (1e3 * (far - reading_.length) - own[3] - 300e3);
    if (jacobian == nullptr) return true;
    for (std::size_t a = 0; a < axes; ++a) {
      const Vector turn = cross(levers_[a], u);
      for (std::size_t k = 0; k < active; ++k)
        if (double* to = jacobian[a * active + k])
          for (std::size_t m = 0; m < motions; ++m) to[m] = w * values_[a][k] * (m < 3 ? u[m] : turn[m - 3]);
    }
    if (double* to = jacobian[axes * active]) {
      to[0] = -w * u[0] * y;
      to[1] = w * u[0] * z;
      to[2] = -w * u[1] * z;
    }
    if (double* to = jacobian[axes * active + 1]) {
      for (std::size_t c = 0; c < 3; ++c) to[c] = -w * u[c];
      to[3] = -w;
    }
    return true;
  }

 private:
  Reading reading_;
  std::array<std::size_t, axes> first_{};
  std::array<std::array<double, active>, axes> values_{};
  std::array<Vector, axes> levers_{};
};

std::vector<Reading> read(const char* path) {
  std::vector<Reading> readings;
  std::ifstream in(path);
  for (Reading r; in >> r.q[0] >> r.q[1] >> r.q[2] >> r.tool[0] >> r.tool[1] >> r.tool[2] >> r.station[0] >>
                  r.station[1] >> r.station[2] >> r.weight >> r.length >> r.virtual_station;) {
    for (std::size_t c = 0; c < 3; ++c) r.reflector[c] = r.q[c] + r.tool[c];
    readings.push_back(r);
  }
  return readings;
}

}  // namespace

int main(int count, char** arguments) {
  const std::vector<Reading> readings = count == 3 ? read(arguments[1]) : std::vector<Reading>{};
  if (readings.empty()) {
    std::fputs(
        "found no readings, expected: volumetric_ceres READINGS THREADS (see bench/compare_scipy_volumetric.py)\n",
        stderr);
    return 2;
  }
  std::vector<std::array<double, motions>> curves(axes * functions, std::array<double, motions>{});
  Vector square{};
  std::array<std::array<double, 4>, 10> stations{};
  ceres::Problem problem;
  for (const Reading& reading : readings) {
    auto cost = std::make_unique<Length>(reading);
    std::vector<double*> blocks;
    for (std::size_t a = 0; a < axes; ++a)
      for (std::size_t k = 0; k < active; ++k) blocks.push_back(curves[a * functions + cost->first(a) + k].data());
    blocks.push_back(square.data());
    blocks.push_back(stations.at(reading.virtual_station).data());
    problem.AddResidualBlock(cost.release(), nullptr, blocks);
  }
  for (std::size_t a = 0; a < axes; ++a) {
    problem.SetParameterBlockConstant(curves[a * functions].data());
    std::vector<int> straightness;
    for (std::size_t m = 0; m < axes; ++m)
      if (m != a) straightness.push_back(static_cast<int>(m));
    problem.SetManifold(curves[a * functions + spans + 2].data(), new ceres::SubsetManifold(motions, straightness));
  }
  ceres::Solver::Options options;
  options.dense_linear_algebra_library_type = ceres::LAPACK;
  options.linear_solver_type = ceres::DENSE_NORMAL_CHOLESKY;
  options.num_threads = std::max(1, std::atoi(arguments[2]));
  options.function_tolerance = 1e-10;
  options.initial_trust_region_radius = 1e12;  // Gauss–Newton steps from the first on
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  std::printf("%.6f %d %.9g\n", summary.total_time_in_seconds, static_cast<int>(summary.iterations.size()) - 1,
              2.0 * summary.final_cost);
  return summary.IsSolutionUsable() ? 0 : 1;
}
