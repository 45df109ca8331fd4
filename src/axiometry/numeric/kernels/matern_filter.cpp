// SPDX-License-Identifier: Apache-2.0
#include "axiometry/numeric/kernels/matern_filter.h"

#include <cmath>

#include "axiometry/base/contract.h"
#include "axiometry/numeric/kernels/kernel_table.h"

namespace axiometry::numeric {

AXIOMETRY_KERNEL_TABLE(matern_kernel, MaternKernel);

const MaternKernel& matern_kernel_of(VectorTarget target) { return matern_kernel_table.of(target); }

namespace {

const MaternKernel& best_matern_kernel() {
  static const MaternKernel& kernel = matern_kernel_of(best_vector_target());
  return kernel;
}

/// ∫₀ᵘ tᵏ e^{−2t} dt = uᵏ⁺¹ e^{−2u} Σ (2u)ⁿ / ((k + 1) … (k + 1 + n)): positive terms, exact also where u is small.
double decaying_moment(double u, int k) {
  double term = 1.0 / (k + 1), sum = term;
  for (int n = 1; term > 1e-17 * sum; ++n) sum += term *= 2.0 * u / (k + 1 + n);
  return sum * std::pow(u, k + 1) * std::exp(-2.0 * u);
}

/// Beyond this many κ nothing is left of the state before: e^{−2u} u⁴ is below 1e-28.
constexpr double forgotten = 40.0;

/// Q for a distance u; its differences do not cancel, since the terms of the lowest power of u stand alone.
void set_noise(MaternStep& step, double u) {
  double moment[5];
  for (int k = 0; k < 5; ++k) moment[k] = decaying_moment(u, k);
  const auto [i0, i1, i2, i3, i4] = moment;
  const double q[6] = {0.25 * i4,
                       0.5 * i3 - 0.25 * i4,
                       0.5 * i2 - i3 + 0.25 * i4,
                       i2 - i3 + 0.25 * i4,
                       i1 - 2.5 * i2 + 1.5 * i3 - 0.25 * i4,
                       i0 - 4.0 * i1 + 5.0 * i2 - 2.0 * i3 + 0.25 * i4};
  for (std::size_t k = 0; k < 6; ++k) step.noise[k] = 16.0 / 3.0 * q[k];
}

void set_transition(MaternStep& step, double u) {
  const double e = std::exp(-u), h = 0.5 * u * u;
  const double a[9] = {1.0 + u + h, u + 2.0 * h,       h,      //
                       -h,          1.0 + u - 2.0 * h, u - h,  //
                       h - u,       2.0 * h - 3.0 * u, 1.0 - 2.0 * u + h};
  for (std::size_t k = 0; k < 9; ++k) step.transition[k] = e * a[k];
}

/// Q = C Cᵀ (Cholesky).
void set_root(MaternStep& step) {
  const double* const q = step.noise;
  double* const c = step.root;
  c[0] = std::sqrt(q[0]);
  c[1] = q[1] / c[0];
  c[2] = std::sqrt(q[3] - c[1] * c[1]);
  c[3] = q[2] / c[0];
  c[4] = (q[4] - c[3] * c[1]) / c[2];
  c[5] = std::sqrt(q[5] - c[3] * c[3] - c[4] * c[4]);
}

constexpr MaternStep anywhere() { return {{}, {1.0, 0.0, -1.0 / 3.0, 1.0 / 3.0, 0.0, 1.0}, {}}; }

std::size_t product_rows(std::size_t places) { return (places + matern_product - 1) / matern_product; }

/// The inverse of Tᵀ S T of one lane applied to both sums of values and trend.
std::array<double, 2> trend_factors(const MaternSums& sums, std::size_t lane, std::size_t terms) {
  const double a = sums.trend[0][lane], b = sums.trend[1][lane], c = sums.trend[2][lane];
  const double x = sums.values_trend[0][lane], y = sums.values_trend[1][lane];
  if (terms == 1) return {x / a, 0.0};
  const double determinant = a * c - b * b;
  return {(c * x - b * y) / determinant, (a * y - b * x) / determinant};
}

}  // namespace

MaternFilter::MaternFilter(std::span<const double> places, double length)
    : steps_(places.size()), no_trend_(places.size(), 0.0) {
  AXIOMETRY_CONTRACT(!places.empty() && length > 0.0);
  steps_.front() = anywhere();
  set_root(steps_.front());
  for (std::size_t i = 1; i < places.size(); ++i) {
    const double u = std::sqrt(5.0) * (places[i] - places[i - 1]) / length;
    AXIOMETRY_CONTRACT(u > 0.0);
    if (u > forgotten) {
      steps_[i] = steps_.front();
      continue;
    }
    set_transition(steps_[i], u);
    set_noise(steps_[i], u);
    set_root(steps_[i]);
  }
}

MaternCurve MaternFilter::curve(const Trend& trend) const {
  AXIOMETRY_CONTRACT((trend.terms == 1 || trend.terms == 2) && trend.columns.size() == trend.terms * size());
  const double* const first = trend.columns.data();
  return {steps_.data(), size(), {first, trend.terms == 2 ? first + size() : no_trend_.data()}};
}

std::array<MaternFilter::BesideTrend, matern_lanes> MaternFilter::beside_trend(std::span<const double> values,
                                                                               const Trend& trend,
                                                                               const Ratios& ratios) const {
  AXIOMETRY_CONTRACT(values.size() == size());
  std::vector<double> rows(size() * lanes);
  for (std::size_t i = 0; i < size(); ++i)
    for (std::size_t k = 0; k < lanes; ++k) rows[i * lanes + k] = values[i];
  std::vector<double> products(product_rows(size()) * lanes);
  MaternSums sums;
  best_matern_kernel().filter(curve(trend), ratios.data(), rows.data(), sums, products.data(), nullptr);
  std::array<BesideTrend, lanes> found;
  for (std::size_t i = 0; i < products.size(); ++i) found[i % lanes].log_determinant += std::log(products[i]);
  for (std::size_t k = 0; k < lanes; ++k) {
    const double own = sums.trend[0][k];
    const double both = trend.terms == 1 ? own : own * sums.trend[2][k] - sums.trend[1][k] * sums.trend[1][k];
    found[k].log_determinant += std::log(both);
    const auto factors = trend_factors(sums, k, trend.terms);
    found[k].squares = sums.values[k] - factors[0] * sums.values_trend[0][k] - factors[1] * sums.values_trend[1][k];
  }
  return found;
}

void MaternFilter::weigh(const Trend& trend, const Ratios& ratios, std::span<double> values,
                         Workspace& workspace) const {
  AXIOMETRY_CONTRACT(values.size() == size() * lanes);
  const MaternCurve own = curve(trend);
  workspace.products.resize(product_rows(size()) * lanes);
  workspace.kept.resize(size() * matern_kept * lanes);
  MaternSums sums;
  best_matern_kernel().filter(own, ratios.data(), values.data(), sums, workspace.products.data(),
                              workspace.kept.data());
  std::array<double, 2 * lanes> factors;
  for (std::size_t k = 0; k < lanes; ++k) {
    const auto of_lane = trend_factors(sums, k, trend.terms);
    factors[k] = of_lane[0];
    factors[lanes + k] = of_lane[1];
  }
  best_matern_kernel().smooth(own, workspace.kept.data(), factors.data(), values.data());
}

void MaternFilter::simulate(std::span<const double> normals, std::span<double> curves) const {
  AXIOMETRY_CONTRACT(normals.size() == 3 * size() * lanes && curves.size() == size() * lanes);
  const MaternCurve own{steps_.data(), size(), {no_trend_.data(), no_trend_.data()}};
  best_matern_kernel().simulate(own, normals.data(), curves.data());
}

}  // namespace axiometry::numeric
