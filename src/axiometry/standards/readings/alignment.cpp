// SPDX-License-Identifier: Apache-2.0
//
// Deviations from the source: eq. 20 as a power series.
#include "axiometry/standards/readings/alignment.h"

#include <cmath>
#include <numbers>
#include <vector>

#include "axiometry/base/contract.h"

namespace axiometry {
namespace {

using uncertainty::Constant;
using uncertainty::Distribution;
using uncertainty::Uniform;

constexpr double um_per_m = 1e6;
constexpr double rad_per_deg = std::numbers::pi / 180.0;
// At 2θ = π the terms of both series fall below 1e-17 of the first one from here on.
constexpr int last_term = 16;

/// (1 − sin θ/θ)/θ² = 1/3! − θ²/5! + …, by Horner's rule from the last term.
double mean_series(double squared) {
  double sum = 0.0;
  for (int k = last_term; k >= 1; --k) sum = 1.0 - squared / ((2.0 * k + 2.0) * (2.0 * k + 3.0)) * sum;
  return sum / 6.0;
}

/// u²/θ⁴ = Σ (−1)^k (k − 1) 4^k θ^(2k−4)/(2k + 2)!, k ≥ 2: the first term is 1/45. With t_k the term without (k − 1),
/// t_(k+1)/t_k = −4θ²/((2k + 3)(2k + 4)).
double variance_series(double squared) {
  double term = 1.0 / 45.0;
  double sum = 0.0;
  for (int k = 2; k <= last_term; ++k) {
    sum += (k - 1) * term;
    term *= -4.0 * squared / ((2.0 * k + 3.0) * (2.0 * k + 4.0));
  }
  return sum;
}

FactorMoments uniform_moments(double angle_rad) {
  const double squared = angle_rad * angle_rad;
  return {-um_per_m * squared * mean_series(squared), um_per_m * squared * std::sqrt(variance_series(squared))};
}

/// cos θ − 1 without a difference of numbers near 1.
double departure(double angle_deg) {
  const double s = std::sin(angle_deg * rad_per_deg / 2.0);
  return -2.0 * s * s * um_per_m;
}

}  // namespace

FactorMoments alignment_moments(Angle angle_max) {
  const double angle_rad = angle_max.in_deg() * rad_per_deg;
  AXIOMETRY_CONTRACT(angle_rad >= 0.0 && angle_rad <= std::numbers::pi / 2.0 * (1.0 + 1e-12));
  return uniform_moments(angle_rad);
}

FactorMoments alignment_moments(const Distribution& angle_deg) {
  if (const auto* uniform = std::get_if<Uniform>(&angle_deg.form()); uniform && uniform->lower == -uniform->upper)
    return alignment_moments(Angle::deg(uniform->upper));
  if (const auto* constant = std::get_if<Constant>(&angle_deg.form())) return {departure(constant->value), 0.0};
  AXIOMETRY_CONTRACT(angle_deg.standard_deviation().has_value());
  constexpr double step = 1.0 / 256.0;
  constexpr int reach = 9 * 256;  // φ(9) is 1e-18
  std::vector<double> weights;
  std::vector<double> values;
  double total = 0.0;
  for (int k = -reach; k <= reach; ++k) {
    const double z = step * k;
    weights.push_back(std::exp(-z * z / 2.0));
    values.push_back(departure(angle_deg.from_normal(z)));
    total += weights.back();
  }
  FactorMoments moments;
  for (std::size_t k = 0; k < weights.size(); ++k) moments.mean += weights[k] / total * values[k];
  double variance = 0.0;
  for (std::size_t k = 0; k < weights.size(); ++k) {
    const double difference = values[k] - moments.mean;
    variance += weights[k] / total * difference * difference;
  }
  moments.standard_deviation = std::sqrt(variance);
  return moments;
}

}  // namespace axiometry
