// SPDX-License-Identifier: Apache-2.0
#include "axiometry/numeric/sine_beside_curve.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "axiometry/base/contract.h"
#include "axiometry/numeric/dense/dense.h"

namespace axiometry::numeric {
namespace {

constexpr double whole_turn = 2.0 * std::numbers::pi;
constexpr std::size_t degree_most = 8, freedom_least = 4, places_least = 8;
// Columns of entries up to 1 that depend on each other to this degree leave coefficients that noise makes a thousand
// times as large as values.
constexpr double nearly_dependent = 1e-3;

/// Legendre polynomials up to `degree`, then sine and cosine.
Eigen::MatrixXd columns_of(const HarmonicData& data, double period, std::size_t degree) {
  const auto n = static_cast<Eigen::Index>(data.places.size()), curve = static_cast<Eigen::Index>(degree + 1);
  const double first = data.places.front(), half = 0.5 * (data.places.back() - first);
  Eigen::MatrixXd columns(n, curve + 2);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double x = data.places[static_cast<std::size_t>(i)] - first, u = x / half - 1.0;
    columns(i, 0) = 1.0;
    columns(i, 1) = u;
    for (Eigen::Index k = 2; k < curve; ++k) {
      const auto order = static_cast<double>(k);
      columns(i, k) = ((2.0 * order - 1.0) * u * columns(i, k - 1) - (order - 1.0) * columns(i, k - 2)) / order;
    }
    columns(i, curve) = std::sin(whole_turn * x / period);
    columns(i, curve + 1) = std::cos(whole_turn * x / period);
  }
  return columns;
}

struct Tried {
  SineBesideCurve fit;
  double criterion = 0.0;  ///< AICc
};

std::optional<Tried> tried(const HarmonicData& data, double period, std::size_t degree) {
  const auto n = static_cast<Eigen::Index>(data.places.size()), curve = static_cast<Eigen::Index>(degree + 1);
  const Eigen::MatrixXd columns = columns_of(data, period, degree);
  const Eigen::VectorXd values = Eigen::Map<const Eigen::VectorXd>(data.values.data(), n);
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(columns);
  qr.setThreshold(nearly_dependent);
  if (qr.rank() < columns.cols()) return std::nullopt;
  const Eigen::VectorXd coefficients = qr.solve(values);
  // What doubles hold of the values bounds what a sum of squares can tell.
  const double floor = static_cast<double>(n) * std::pow(1e-14 * (1.0 + values.cwiseAbs().maxCoeff()), 2);
  const double left = std::max(floor, (values - columns * coefficients).squaredNorm());
  const Eigen::MatrixXd alone = columns.leftCols(curve);
  const Eigen::VectorXd without = values - alone * alone.colPivHouseholderQr().solve(values);
  const double left_without = std::max(left, without.squaredNorm());
  const auto freedom = static_cast<double>(n - curve - 2);

  Tried result;
  SineBesideCurve& fit = result.fit;
  fit.origin = data.places.front();
  fit.period = period;
  fit.sine = coefficients[curve];
  fit.cosine = coefficients[curve + 1];
  fit.amplitude = std::hypot(fit.sine, fit.cosine);
  fit.chance = std::pow(left / left_without, 0.5 * freedom);
  fit.degree = degree;
  fit.degrees_of_freedom = static_cast<std::size_t>(freedom);
  const Eigen::MatrixXd inverse = cofactor(qr);
  const double s = fit.amplitude > 0.0 ? fit.sine / fit.amplitude : 1.0;
  const double c = fit.amplitude > 0.0 ? fit.cosine / fit.amplitude : 0.0;
  const double along =
      s * s * inverse(curve, curve) + 2.0 * s * c * inverse(curve, curve + 1) + c * c * inverse(curve + 1, curve + 1);
  fit.amplitude_u = std::sqrt(along * left / freedom);
  const double q = static_cast<double>(degree) + 4.0, count = static_cast<double>(n);
  result.criterion = count * std::log(left / count) + 2.0 * q + 2.0 * q * (q + 1.0) / (count - q - 1.0);
  return result;
}

}  // namespace

double SineBesideCurve::at(double x) const {
  const double angle = whole_turn * (x - origin) / period;
  return sine * std::sin(angle) + cosine * std::cos(angle);
}

std::optional<SineBesideCurve> fit_sine_beside_curve(const HarmonicData& data, double period) {
  AXIOMETRY_CONTRACT(data.places.size() == data.values.size() && period > 0.0);
  if (data.places.size() < places_least) return std::nullopt;
  const double travel = data.places.back() - data.places.front();
  if (!(travel >= 2.0 * period)) return std::nullopt;
  const double half_periods = std::min(2.0 * travel / period, 1e6);
  const std::size_t most =
      std::min({degree_most, static_cast<std::size_t>(half_periods) - 2, data.places.size() - 3 - freedom_least});
  std::optional<Tried> best;
  for (std::size_t degree = 1; degree <= most; ++degree) {
    const auto now = tried(data, period, degree);
    if (now && (!best || now->criterion < best->criterion)) best = now;
  }
  if (!best) return std::nullopt;
  return best->fit;
}

}  // namespace axiometry::numeric
