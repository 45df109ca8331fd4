// SPDX-License-Identifier: Apache-2.0
#include "axiometry/numeric/curve_posterior.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace axiometry::numeric {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double least_in_noise = 0.05;  // amplitudes from a twentieth of the noise …
constexpr double most_in_seen = 4.0;     // … to four times what was seen beside the trend
constexpr std::size_t grid_size_max = 24;
constexpr std::size_t lengths_max = 4;

/// Correlation of the smooth part at a distance of r lengths: Matérn with ν = 5/2.
double matern(double r) {
  const double x = std::sqrt(5.0) * r;
  return (1.0 + x + x * x / 3.0) * std::exp(-x);
}

/// An orthonormal basis whose first columns span the polynomials of the trend.
MatrixXd trend_and_rest(std::span<const double> places, std::size_t terms) {
  const auto m = static_cast<Eigen::Index>(places.size());
  const double middle = 0.5 * (places.front() + places.back());
  const double half = 0.5 * (places.back() - places.front());
  MatrixXd trend(m, static_cast<Eigen::Index>(terms));
  for (Eigen::Index i = 0; i < m; ++i) {
    trend(i, 0) = 1.0;
    if (terms == 2) trend(i, 1) = (places[i] - middle) / half;
  }
  return MatrixXd(Eigen::HouseholderQR<MatrixXd>(trend).householderQ());
}

/// Lengths of the smooth part, halving from over half the range down to the spacing.
std::vector<double> lengths(std::span<const double> places) {
  const double range = places.back() - places.front();
  if (places.size() <= 2) return {1.0};  // there is nothing but the trend
  const double spacing = range / static_cast<double>(places.size() - 1);
  std::vector<double> found;
  for (double length = 0.6 * range; length > 1.4 * spacing && found.size() < lengths_max; length /= 2)
    found.push_back(length);
  if (found.empty()) found.push_back(0.6 * range);
  return found;
}

/// 0, then octaves from `least` to `most`.
std::vector<double> octaves(double least, double most) {
  std::vector<double> grid = {0.0};
  const double count = std::clamp(std::ceil(std::log2(most / least)) + 1.0, 2.0, double(grid_size_max));
  for (double k = 0.0; k < count; ++k) grid.push_back(least * std::pow(most / least, k / (count - 1.0)));
  return grid;
}

}  // namespace

CurvePosterior::CurvePosterior(const NoisyCurve& data)
    : values_(data.values.begin(), data.values.end()), noise_variance_(data.noise_variance) {
  AXIOMETRY_CONTRACT(data.places.size() == data.values.size() && !data.values.empty());
  AXIOMETRY_CONTRACT(noise_variance_ >= 0.0);
  trend_terms_ = std::min(data.trend_terms, size());
  if (noise_variance_ == 0.0) return;
  const auto m = static_cast<Eigen::Index>(size());
  const auto terms = static_cast<Eigen::Index>(trend_terms_);
  const MatrixXd frame = trend_and_rest(data.places, trend_terms_);
  const Eigen::Map<const VectorXd> y(values_.data(), m);
  for (double length : lengths(data.places)) {
    MatrixXd covariance(m, m);
    for (Eigen::Index i = 0; i < m; ++i)
      for (Eigen::Index j = 0; j < m; ++j)
        covariance(i, j) = matern(std::abs(data.places[i] - data.places[j]) / length);
    MatrixXd basis = frame;
    VectorXd smooth = VectorXd::Zero(m);
    if (m > terms) {
      const MatrixXd rest = frame.rightCols(m - terms);
      const Eigen::SelfAdjointEigenSolver<MatrixXd> axes(rest.transpose() * covariance * rest);
      basis.rightCols(m - terms) = rest * axes.eigenvectors();
      smooth.tail(m - terms) = axes.eigenvalues().cwiseMax(0.0);
    }
    const VectorXd coordinates = basis.transpose() * y;
    Basis& own = bases_.emplace_back();
    own.columns.resize(size() * size());
    for (Eigen::Index i = 0; i < m; ++i)
      for (Eigen::Index k = 0; k < m; ++k) own.columns[k * m + i] = basis(i, k);
    own.coordinates.assign(coordinates.begin(), coordinates.end());
    own.smooth.assign(smooth.begin(), smooth.end());
  }
  consider_hypotheses();
}

void CurvePosterior::consider_hypotheses() {
  double squares = 0.0;
  const auto& coordinates = bases_.front().coordinates;
  for (std::size_t k = trend_terms_; k < size(); ++k) squares += coordinates[k] * coordinates[k];
  const std::size_t count = std::max<std::size_t>(1, size() - std::min(size(), trend_terms_));
  const double noise = std::sqrt(noise_variance_);
  const double seen = std::max(std::sqrt(squares / static_cast<double>(count)), 3.0 * noise);
  const std::vector<double> amplitudes = octaves(least_in_noise * noise, most_in_seen * seen);
  std::vector<double> log_weights;
  for (std::size_t basis = 0; basis < bases_.size(); ++basis) {
    for (double smooth : amplitudes) {
      if (smooth == 0.0 && basis > 0) continue;  // without a smooth part its length means nothing
      const double log_prior = smooth == 0.0 ? 0.0 : -std::log(static_cast<double>(bases_.size()));
      for (double rough : amplitudes) {
        const Hypothesis hypothesis{basis, smooth * smooth, rough * rough};
        log_weights.push_back(log_prior + log_likelihood(hypothesis));
        hypotheses_.push_back(hypothesis);
      }
    }
  }
  choice_ = WeightedChoice::from_log_weights(log_weights);
}

/// Of the coordinates beside the trend, up to a constant.
double CurvePosterior::log_likelihood(const Hypothesis& hypothesis) const {
  const Basis& basis = bases_[hypothesis.basis];
  double sum = 0.0;
  for (std::size_t k = trend_terms_; k < size(); ++k) {
    const double variance = hypothesis.smooth_variance * basis.smooth[k] + hypothesis.rough_variance + noise_variance_;
    sum -= 0.5 * (std::log(variance) + basis.coordinates[k] * basis.coordinates[k] / variance);
  }
  return sum;
}

void CurvePosterior::draw(double choice, std::span<const double> normals, std::span<double> curve) const {
  if (noise_variance_ == 0.0) {
    std::ranges::copy(values_, curve.begin());
    return;
  }
  const Hypothesis& hypothesis = hypotheses_[choice_(choice)];
  const Basis& basis = bases_[hypothesis.basis];
  const std::size_t m = size();
  std::ranges::fill(curve.first(m), 0.0);
  for (std::size_t k = 0; k < m; ++k) {
    const double prior = hypothesis.smooth_variance * basis.smooth[k] + hypothesis.rough_variance;
    const double shrink = k < trend_terms_ ? 1.0 : prior / (prior + noise_variance_);
    const double coordinate = shrink * basis.coordinates[k] + std::sqrt(shrink * noise_variance_) * normals[k];
    const double* column = basis.columns.data() + k * m;
    for (std::size_t i = 0; i < m; ++i) curve[i] += coordinate * column[i];
  }
}

}  // namespace axiometry::numeric
