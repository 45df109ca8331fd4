// SPDX-License-Identifier: Apache-2.0
//
// Deviations from the source: the conditions of the last two rows of Table A.1 are printed in exchange, which the
// ranges beside them show; one expression here serves all rows.
#include "axiometry/standards/readings/thermal_expansion.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "axiometry/base/contract.h"

namespace axiometry {
namespace {

using uncertainty::Constant;
using uncertainty::Distribution;
using uncertainty::Uniform;

constexpr double per_m = 1e-6;          // µm/m as a number
constexpr double limit = 5e5;           // µm/m, half the length
constexpr std::size_t node_count = 12;  // per quantity; the integrand is nearly a polynomial of degree 2

struct Node {
  double place;   // −1 to 1
  double weight;  // all add up to 1
};

/// Gauss-Legendre: the zeros of P_n by Newton's method from the usual cosine estimate.
std::array<Node, node_count> gauss_nodes() {
  std::array<Node, node_count> nodes{};
  constexpr double n = node_count;
  for (std::size_t k = 0; k < node_count; ++k) {
    double x = std::cos(M_PI * (static_cast<double>(k) + 0.75) / (n + 0.5));
    double derivative = 0.0;
    for (int step = 0; step < 8; ++step) {
      double before = 1.0;
      double value = x;
      for (double j = 2.0; j <= n; j += 1.0) {
        const double next = ((2.0 * j - 1.0) * x * value - (j - 1.0) * before) / j;
        before = value;
        value = next;
      }
      derivative = n * (x * value - before) / (x * x - 1.0);
      x -= value / derivative;
    }
    nodes[k] = {x, 1.0 / ((1.0 - x * x) * derivative * derivative)};
  }
  return nodes;
}

/// A uniform distribution by its middle and half its width.
struct Band {
  double middle = 0.0;
  double half = 0.0;
};

Band band_of(const Uniform& u) { return {u.lower + (u.upper - u.lower) / 2.0, (u.upper - u.lower) / 2.0}; }

std::optional<Band> band_of(const Distribution& distribution) {
  if (const auto* uniform = std::get_if<Uniform>(&distribution.form())) return band_of(*uniform);
  if (const auto* constant = std::get_if<Constant>(&distribution.form())) return Band{constant->value, 0.0};
  return std::nullopt;
}

/// By how much f_t changes when αΔT does, from a state of departure `middle`: −f δ/(1 + f δ) · f with the f there.
double change(double f, double delta_um_per_m) {
  const double relative = f * delta_um_per_m * per_m;
  return -f * f * delta_um_per_m / (1.0 + relative);
}

/// Moments over a rectangle of α and ΔT. The change from the middle is computed as such, so that no width is too
/// small to be seen.
FactorMoments rectangle_moments(const Band& expansion, const Band& difference) {
  const std::array<Node, node_count> nodes = gauss_nodes();
  const ThermalState middle{expansion.middle, difference.middle};
  const double f = thermal_factor(middle);
  const auto change_at = [&](const Node& a, const Node& t) {
    const double d_alpha = expansion.half * a.place;
    const double d_T = difference.half * t.place;
    return change(f, d_alpha * middle.difference + d_T * middle.expansion + d_alpha * d_T);
  };
  const auto expectation = [&](const auto& function) {
    double sum = 0.0;
    for (const Node& a : nodes)
      for (const Node& t : nodes) sum += a.weight * t.weight * function(change_at(a, t));
    return sum;
  };
  const double mean = expectation([](double x) { return x; });
  const double variance = expectation([&](double x) { return (x - mean) * (x - mean); });
  return {thermal_departure(middle) + mean, std::sqrt(variance)};
}

bool sensible(double alpha_dT) { return std::abs(alpha_dT) < limit; }

}  // namespace

double thermal_departure(ThermalState state) {
  const double expansion = state.expansion * state.difference;
  AXIOMETRY_CONTRACT(sensible(expansion));
  return -expansion / (1.0 + expansion * per_m);
}

double thermal_factor(ThermalState state) { return 1.0 + thermal_departure(state) * per_m; }

ThermalState thermal_sensitivity(ThermalState state) {
  const double f = thermal_factor(state);
  return {-state.difference * f * f, -state.expansion * f * f};
}

double thermal_uncertainty(ThermalState state, ThermalState u) {
  const ThermalState c = thermal_sensitivity(state);
  return std::hypot(c.expansion * u.expansion, c.difference * u.difference);
}

FactorMoments thermal_moments(const Distribution& expansion, const Distribution& difference) {
  const auto alpha_band = band_of(expansion);
  const auto difference_band = band_of(difference);
  if (alpha_band && difference_band) return rectangle_moments(*alpha_band, *difference_band);
  const auto u_alpha = expansion.standard_deviation();
  const auto u_T = difference.standard_deviation();
  AXIOMETRY_CONTRACT(u_alpha && u_T);
  const ThermalState middle{expansion.mean(), difference.mean()};
  const double f = thermal_factor(middle);
  const double product = std::hypot(*u_alpha * middle.difference, *u_T * middle.expansion, *u_alpha * *u_T);
  // E(1/(1 + q)) = f + f³ Var q + …
  return {thermal_departure(middle) + f * f * f * product * product * per_m, f * f * product};
}

Result<ThermalFactorDistribution> ThermalFactorDistribution::make(Uniform expansion, Uniform difference) {
  if (!(0.0 < expansion.lower && expansion.lower < expansion.upper))
    return fail(
        fmt::format("found an expansion coefficient from {} to {} µm/(m·°C), expected positive limits that "
                    "ascend",
                    expansion.lower, expansion.upper));
  if (!(difference.lower < difference.upper))
    return fail(fmt::format("found a temperature from {} to {} °C, expected limits that ascend", difference.lower,
                            difference.upper));
  if (!sensible(expansion.upper * difference.lower) || !sensible(expansion.upper * difference.upper))
    return fail(fmt::format("found an expansion of {} µm/m, expected less than {:g}",
                            expansion.upper * std::max(std::abs(difference.lower), std::abs(difference.upper)), limit));
  return ThermalFactorDistribution(expansion, difference);
}

double ThermalFactorDistribution::density(double departure) const {
  const auto [least, greatest] = limits();
  if (!(departure > least && departure < greatest)) return 0.0;
  // q = αΔT of this departure; the density of q is the integral of dα/α over those α that some ΔT allows (A.2).
  const double f = 1.0 + departure * per_m;
  const double q = -departure / f;
  double from = expansion_.lower;
  double to = expansion_.upper;
  const double far = q > 0.0 ? difference_.upper : difference_.lower;   // the ΔT farthest from 0 on q's side
  const double near = q > 0.0 ? difference_.lower : difference_.upper;  // the one nearest to 0, or beyond it
  if (q != 0.0) from = std::max(from, q / far);
  if (q * near > 0.0) to = std::min(to, q / near);
  if (!(from < to)) return 0.0;
  const double area = (expansion_.upper - expansion_.lower) * (difference_.upper - difference_.lower);
  return std::log1p((to - from) / from) / (area * f * f);
}

std::pair<double, double> ThermalFactorDistribution::limits() const {
  std::array<double, 4> corners{};
  std::size_t k = 0;
  for (double alpha : {expansion_.lower, expansion_.upper})
    for (double dT : {difference_.lower, difference_.upper}) corners[k++] = thermal_departure({alpha, dT});
  return {*std::ranges::min_element(corners), *std::ranges::max_element(corners)};
}

FactorMoments ThermalFactorDistribution::moments() const {
  return rectangle_moments(band_of(expansion_), band_of(difference_));
}

}  // namespace axiometry
