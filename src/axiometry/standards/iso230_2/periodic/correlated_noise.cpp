// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/periodic/correlated_noise.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "axiometry/base/contract.h"

namespace axiometry::iso230_2 {

double NoiseCorrelation::power_beside_white(double targets_per_period) const {
  const double turn = 2.0 * std::numbers::pi / targets_per_period;
  const double cosine = std::cos(turn);
  if (cosine <= 0.0) return 1.0;  // at periods below four targets such noise has less than white noise
  const double worst = (1.0 - std::abs(std::sin(turn))) / cosine;
  const double rho = std::min(most, worst);
  return std::max(1.0, (1.0 - rho * rho) / (1.0 - 2.0 * rho * cosine + rho * rho));
}

double NoiseCorrelation::uncertain_beside_white(double targets_per_period) const {
  return told ? std::sqrt(power_beside_white(targets_per_period)) : 1.0;
}

double NoiseCorrelation::white_reduction(double reduction, double targets_per_period) const {
  const double rest = power_beside_white(targets_per_period) * (1.0 - reduction);
  return reduction > 0.0 ? reduction / (reduction + rest) : 0.0;
}

NoiseCorrelation noise_correlation(std::span<const double> residuals, std::size_t degrees_of_freedom) {
  AXIOMETRY_CONTRACT(residuals.size() > degrees_of_freedom);
  constexpr double one_in_twenty = 1.6449;  // lies above, of a normal distribution
  double squares = 0.0, products = 0.0;
  for (std::size_t k = 0; k < residuals.size(); ++k) {
    squares += residuals[k] * residuals[k];
    if (k > 0) products += residuals[k - 1] * residuals[k];
  }
  if (!(squares > 0.0)) return {};
  const double n = static_cast<double>(residuals.size());
  const double fitted = n - static_cast<double>(degrees_of_freedom);
  const double seen = products / squares;
  NoiseCorrelation found;
  found.lag_one = std::clamp(seen + (1.0 + seen) * (fitted - 1.0) / n, -1.0, 1.0);
  found.most = std::clamp(found.lag_one + 2.0 * std::sqrt((1.0 - seen * seen) / n), 0.0, 1.0);
  found.told = found.lag_one > one_in_twenty / std::sqrt(n);
  return found;
}

}  // namespace axiometry::iso230_2
