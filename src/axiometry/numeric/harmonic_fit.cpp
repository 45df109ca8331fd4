// SPDX-License-Identifier: Apache-2.0
#include "axiometry/numeric/harmonic_fit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "axiometry/base/contract.h"
#include "axiometry/numeric/dense/dense.h"

namespace axiometry::numeric {
namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;
// Columns of entries up to 1 that depend on each other to this degree: coefficients would have lost nine digits.
constexpr double dependent = 1e-9;

struct Solution {
  Eigen::VectorXd coefficients;
  Eigen::MatrixXd cofactor;  ///< (JᵀJ)⁻¹
  Eigen::VectorXd residuals;
};

/// Least squares. Nothing when the columns depend on each other.
std::optional<Solution> solve(const Eigen::MatrixXd& columns, const Eigen::VectorXd& values) {
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(columns);
  qr.setThreshold(dependent);
  if (qr.rank() < columns.cols()) return std::nullopt;
  Solution result;
  result.coefficients = qr.solve(values);
  result.residuals = values - columns * result.coefficients;
  result.cofactor = cofactor(qr);
  return result;
}

/// The problem with the line's columns centred and scaled; coefficients are brought back to x₀ at the end.
class Problem {
 public:
  Problem(const HarmonicData& data, std::span<const std::size_t> orders)
      : data_(data), orders_(orders.begin(), orders.end()) {
    AXIOMETRY_CONTRACT(data.places.size() == data.values.size() && data.places.size() >= 2 && !orders.empty());
    origin_ = data.places.front();
    half_ = (data.places.back() - data.places.front()) / 2.0;
    middle_ = origin_ + half_;
    values_ = Eigen::Map<const Eigen::VectorXd>(data.values.data(), static_cast<Eigen::Index>(data.values.size()));
  }

  std::size_t size() const { return data_.places.size(); }
  std::size_t linear_count() const { return 2 + 2 * orders_.size(); }

  std::optional<Solution> solve_at(double period) const { return solve(columns(period), values_); }

  /// The step of the period that the residuals ask for, and the whole solution's cofactors.
  std::optional<Solution> solve_with_period(double period, const Solution& linear) const {
    Eigen::MatrixXd all(static_cast<Eigen::Index>(size()), static_cast<Eigen::Index>(linear_count() + 1));
    all.leftCols(static_cast<Eigen::Index>(linear_count())) = columns(period);
    for (std::size_t k = 0; k < size(); ++k) {
      double derivative = 0.0;
      for (std::size_t h = 0; h < orders_.size(); ++h) {
        const double rate = two_pi * static_cast<double>(orders_[h]) / period;
        const double x = data_.places[k] - origin_;
        const auto at = static_cast<Eigen::Index>(2 + 2 * h);
        derivative -= rate * x / period *
                      (linear.coefficients[at] * std::cos(rate * x) - linear.coefficients[at + 1] * std::sin(rate * x));
      }
      all(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(linear_count())) = derivative;
    }
    // Its size is that of the amplitude over the period; the others have entries up to 1.
    const auto last = all.cols() - 1;
    const double size = all.col(last).norm();
    if (!(size > 0.0)) return std::nullopt;
    all.col(last) *= std::sqrt(static_cast<double>(this->size())) / size;
    auto solution = solve(all, linear.residuals);
    if (!solution) return std::nullopt;
    const double unit = std::sqrt(static_cast<double>(this->size())) / size;
    solution->coefficients[last] *= unit;
    solution->cofactor.row(last) *= unit;
    solution->cofactor.col(last) *= unit;
    return solution;
  }

  HarmonicFit fit(double period, const Solution& linear, const Solution* with_period) const {
    HarmonicFit result;
    result.origin = origin_;
    result.period = period;
    result.orders = orders_;
    result.period_fitted = with_period != nullptr;
    const std::size_t p = linear_count() + (result.period_fitted ? 1 : 0);
    result.degrees_of_freedom = size() - p;
    result.residuals.assign(linear.residuals.begin(), linear.residuals.end());
    result.sum_of_squares = linear.residuals.squaredNorm();
    // a + b (x − x₀) from a' + b' (x − middle)/half
    Eigen::MatrixXd back = Eigen::MatrixXd::Identity(static_cast<Eigen::Index>(p), static_cast<Eigen::Index>(p));
    back(0, 1) = (origin_ - middle_) / half_;
    back(1, 1) = 1.0 / half_;
    Eigen::VectorXd coefficients(static_cast<Eigen::Index>(p));
    coefficients.head(static_cast<Eigen::Index>(linear_count())) = linear.coefficients;
    if (result.period_fitted) coefficients[static_cast<Eigen::Index>(p - 1)] = period;
    coefficients = back * coefficients;
    const double variance = result.sum_of_squares / static_cast<double>(result.degrees_of_freedom);
    const Eigen::MatrixXd& cofactor = result.period_fitted ? with_period->cofactor : linear.cofactor;
    const Eigen::MatrixXd covariance = variance * (back * cofactor * back.transpose());
    result.coefficients.assign(coefficients.begin(), coefficients.end());
    for (Eigen::Index r = 0; r < covariance.rows(); ++r)
      for (Eigen::Index c = 0; c < covariance.cols(); ++c) result.covariance.push_back(covariance(r, c));
    return result;
  }

 private:
  Eigen::MatrixXd columns(double period) const {
    Eigen::MatrixXd all(static_cast<Eigen::Index>(size()), static_cast<Eigen::Index>(linear_count()));
    for (std::size_t k = 0; k < size(); ++k) {
      const auto row = static_cast<Eigen::Index>(k);
      all(row, 0) = 1.0;
      all(row, 1) = (data_.places[k] - middle_) / half_;
      for (std::size_t h = 0; h < orders_.size(); ++h) {
        const double angle = two_pi * static_cast<double>(orders_[h]) * (data_.places[k] - origin_) / period;
        all(row, static_cast<Eigen::Index>(2 + 2 * h)) = std::sin(angle);
        all(row, static_cast<Eigen::Index>(3 + 2 * h)) = std::cos(angle);
      }
    }
    return all;
  }

  HarmonicData data_;
  std::vector<std::size_t> orders_;
  double origin_ = 0.0;
  double middle_ = 0.0;
  double half_ = 1.0;
  Eigen::VectorXd values_;
};

}  // namespace

std::size_t HarmonicFit::place_of(std::size_t order) const {
  const auto found = std::ranges::find(orders, order);
  AXIOMETRY_CONTRACT(found != orders.end());
  return 2 + 2 * static_cast<std::size_t>(found - orders.begin());
}

double HarmonicFit::chance_of(std::size_t order) const {
  const std::size_t at = place_of(order);
  const double ss = covariance_of(at, at), cc = covariance_of(at + 1, at + 1), sc = covariance_of(at, at + 1);
  const double s = coefficients[at], c = coefficients[at + 1];
  const double determinant = ss * cc - sc * sc;
  if (!(determinant > 0.0)) return s == 0.0 && c == 0.0 ? 1.0 : 0.0;
  const double F = (s * s * cc - 2.0 * s * c * sc + c * c * ss) / determinant / 2.0;
  const double nu = static_cast<double>(degrees_of_freedom);
  return std::exp(-nu / 2.0 * std::log1p(2.0 * F / nu));
}

std::optional<HarmonicFit> fit_harmonics(const HarmonicData& data, double period, std::span<const std::size_t> orders) {
  AXIOMETRY_CONTRACT(period > 0.0);
  const Problem problem(data, orders);
  if (problem.size() <= problem.linear_count()) return std::nullopt;
  const auto solution = problem.solve_at(period);
  return solution ? std::optional(problem.fit(period, *solution, nullptr)) : std::nullopt;
}

std::optional<HarmonicFit> fit_harmonics_and_period(const HarmonicData& data, double start,
                                                    std::span<const std::size_t> orders) {
  AXIOMETRY_CONTRACT(start > 0.0);
  const Problem problem(data, orders);
  if (problem.size() <= problem.linear_count() + 1) return std::nullopt;
  double period = start;
  auto best = problem.solve_at(period);
  if (!best) return std::nullopt;
  for (int iteration = 0; iteration < 100; ++iteration) {
    const auto whole = problem.solve_with_period(period, *best);
    if (!whole) return std::nullopt;
    double step = whole->coefficients[whole->coefficients.size() - 1];
    bool fell = false;
    for (int halving = 0; halving < 40 && std::abs(step) > 1e-12 * period; ++halving, step /= 2.0) {
      const double next = period + step;
      if (!(next > start / 2.0 && next < 2.0 * start)) continue;
      const auto trial = problem.solve_at(next);
      if (!trial || trial->residuals.squaredNorm() >= best->residuals.squaredNorm()) continue;
      period = next;
      best = trial;
      fell = true;
      break;
    }
    if (!fell) return problem.fit(period, *best, &*whole);
  }
  const auto whole = problem.solve_with_period(period, *best);
  return whole ? std::optional(problem.fit(period, *best, &*whole)) : std::nullopt;
}

}  // namespace axiometry::numeric
