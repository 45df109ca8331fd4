// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/periodic/enlarged_uncertainties.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <type_traits>

namespace axiometry::iso230_2 {
namespace {

template <typename Quantity>
void enlarge(Estimate<Quantity>& estimate, double times) {
  if constexpr (std::is_same_v<Quantity, double>)
    estimate.u *= times;
  else if constexpr (std::is_same_v<Quantity, Angle>)
    estimate.u = Angle::deg(std::min(times * estimate.u.in_deg(), nothing_known_deg));
  else
    estimate.u = Quantity::native(times * estimate.u.in_native());
}

template <typename Quantity>
void add_to(Estimate<Quantity>& estimate, double u) {
  if constexpr (std::is_same_v<Quantity, double>)
    estimate.u = std::hypot(estimate.u, u);
  else if constexpr (std::is_same_v<Quantity, Angle>)
    estimate.u = Angle::deg(std::min(std::hypot(estimate.u.in_deg(), u), nothing_known_deg));
  else
    estimate.u = Quantity::native(std::hypot(estimate.u.in_native(), u));
}

}  // namespace

// An estimate Σ c_i y_i has at most √(Σ c²) √(Σ e²) of errors e_i of its values: √2 of their rms for an amplitude, √12
// over the travel for a slope, twice it for the line at the first target.
void hold_shifts(PeriodicDirection& result, double u_means, double travel) {
  constexpr double deg = 180.0 / std::numbers::pi, least = std::numeric_limits<double>::min();
  const double of_amplitude = std::numbers::sqrt2 * u_means;
  const double amplitude = result.harmonics.front().amplitude.value.in_native();
  const double phase = of_amplitude / std::max(amplitude, least), period = result.period.value.in_native();
  for (PeriodicHarmonic& h : result.harmonics) {
    add_to(h.phase, deg * of_amplitude / std::max(h.amplitude.value.in_native(), least));
    add_to(h.amplitude, of_amplitude);
  }
  add_to(result.peak_to_valley, 2.0 * of_amplitude);
  add_to(result.phase_at_zero, deg * phase * (1.0 + 2.0 * std::abs(result.origin.in_native()) / travel));
  if (!result.period_known) add_to(result.period, period * period / (std::numbers::pi * travel) * phase);
  add_to(result.slope_native, std::sqrt(12.0) / travel * u_means);
  add_to(result.offset, 2.0 * u_means);
  if (!(u_means > 0.0)) return;
  const double by_shifts = std::erfc(amplitude / (std::numbers::sqrt2 * of_amplitude));
  result.false_alarm_correlated = std::max(result.false_alarm_correlated, by_shifts);
  result.significant = result.false_alarm_correlated < periodic_significance;
  result.harmonics.front().significant = result.significant;
}

void enlarge_uncertainties(PeriodicDirection& result, std::size_t targets) {
  const NoiseCorrelation& noise = result.residual_correlation;
  result.curve_times = noise.uncertain_beside_white(result.targets_per_period);
  result.line_times = noise.uncertain_beside_white(2.0 * static_cast<double>(targets));
  enlarge(result.offset, result.line_times);
  enlarge(result.slope_native, result.line_times);
  enlarge(result.period, result.curve_times);
  enlarge(result.phase_at_zero, result.curve_times);
  enlarge(result.peak_to_valley, result.curve_times);
  for (PeriodicHarmonic& h : result.harmonics) {
    const double times = noise.uncertain_beside_white(result.targets_per_period / static_cast<double>(h.order));
    enlarge(h.amplitude, times);
    enlarge(h.phase, times);
  }
}

}  // namespace axiometry::iso230_2
