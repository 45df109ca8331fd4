// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/monte_carlo/environment_modes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "axiometry/base/contract.h"
#include "axiometry/numeric/dense/principal_axes.h"

namespace axiometry {
namespace {

constexpr double trend_weight = 0.3;
constexpr double period_step = 0.5;      // over the test: half a period, one, …
constexpr double periods_per_run = 1.2;  // … to more than one in every run, …
constexpr double most_periods = 7.0;     // … since what repeats from run to run is all but hidden; all alike likely
constexpr std::size_t walk_modes = 24;
constexpr double walk_range = 1.5957691216057308;  // √(8/π): the mean range of Brownian motion of σ = 1 over time 1
constexpr double negligible_mode = 1e-4;           // modes below this share of the largest eigenvalue are left out

template <typename Shape>
void add_mode(EnvironmentModes& modes, std::span<const double> shares, const Shape& shape) {
  for (double share : shares) modes.values.push_back(std::isnan(share) ? 0.0 : shape(share));
}

EnvironmentModes drift_modes(std::span<const double> shares, std::size_t runs) {
  const auto count = static_cast<std::size_t>(std::min(most_periods, periods_per_run * double(runs)) / period_step);
  EnvironmentModes modes{shares.size(), {}};
  add_mode(modes, shares, [](double t) { return std::sqrt(trend_weight) * (t - 0.5); });
  for (std::size_t k = 1; k <= count; ++k) {
    const double f = period_step * double(k);
    const double size = std::sqrt((1.0 - trend_weight) / double(8 * count));  // range² is 4 (a² + b²) of both
    add_mode(modes, shares, [&](double t) { return size * std::cos(2.0 * std::numbers::pi * f * t); });
    add_mode(modes, shares, [&](double t) { return size * std::sin(2.0 * std::numbers::pi * f * t); });
  }
  return modes;
}

EnvironmentModes walk(std::span<const double> shares) {
  EnvironmentModes modes{shares.size(), {}};
  for (std::size_t k = 1; k <= walk_modes; ++k) {
    const double frequency = (double(k) - 0.5) * std::numbers::pi;
    add_mode(modes, shares,
             [&](double t) { return std::numbers::sqrt2 * std::sin(frequency * t) / (frequency * walk_range); });
  }
  return modes;
}

}  // namespace

EnvironmentModes environment_modes(EnvironmentKind kind, std::span<const double> shares, std::size_t runs) {
  AXIOMETRY_CONTRACT(kind == EnvironmentKind::drift || kind == EnvironmentKind::random_walk);
  return kind == EnvironmentKind::drift ? drift_modes(shares, runs) : walk(shares);
}

EnvironmentModes trend_mode(std::span<const double> shares) {
  EnvironmentModes modes{shares.size(), {}};
  add_mode(modes, shares, [](double t) { return t - 0.5; });
  return modes;
}

EnvironmentModes single_errors(std::span<const std::size_t> readings, std::size_t places) {
  EnvironmentModes modes{places, std::vector<double>(readings.size() * places, 0.0)};
  for (std::size_t k = 0; k < readings.size(); ++k) modes.values[k * places + readings[k]] = 1.0;
  return modes;
}

EnvironmentModes modes_of_covariance(std::span<const double> covariance, std::span<const double> shares) {
  const std::size_t nodes = covariance.size();
  AXIOMETRY_CONTRACT(nodes >= 2);
  std::vector<double> matrix(nodes * nodes);
  for (std::size_t i = 0; i < nodes; ++i)
    for (std::size_t j = 0; j < nodes; ++j) matrix[i * nodes + j] = covariance[i > j ? i - j : j - i];
  const numeric::PrincipalAxes axes = numeric::principal_axes(matrix, nodes);
  EnvironmentModes modes{shares.size(), {}};
  for (std::size_t k = nodes; k-- > 0 && modes.count() < walk_modes;) {
    const double size = axes.values[k];
    if (!(size > negligible_mode * axes.values[nodes - 1])) break;
    const auto axis = axes.axis(k);
    add_mode(modes, shares, [&](double t) {
      const double place = t * double(nodes - 1);
      const std::size_t left = std::min(nodes - 2, static_cast<std::size_t>(place));
      const double part = place - double(left);
      return std::sqrt(size) * ((1.0 - part) * axis[left] + part * axis[left + 1]);
    });
  }
  return modes;
}

}  // namespace axiometry
