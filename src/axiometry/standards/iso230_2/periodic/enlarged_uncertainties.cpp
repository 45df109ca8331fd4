// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/periodic/enlarged_uncertainties.h"

#include <algorithm>
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

}  // namespace

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
