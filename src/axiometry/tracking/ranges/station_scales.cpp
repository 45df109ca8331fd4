// SPDX-License-Identifier: Apache-2.0
#include "axiometry/tracking/ranges/station_scales.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "axiometry/base/text/number_text.h"
#include "axiometry/numeric/distributions/chi_square.h"
#include "axiometry/numeric/median.h"
#include "axiometry/tracking/ranges/multilateration_findings.h"

namespace axiometry::tracking::detail {
namespace {

constexpr double gain_least = 60.0;               // the same as for a break in look_for_breaks()
constexpr double by_chance = 1e-6;                // chance that m − 1 unknowns without an effect gain as much
constexpr double freedom_of_scales_least = 20.0;  // below it χ²/ν itself is too uncertain to measure by

/// ν + 2 √(2ν): by chance above it once in forty times.
bool larger_than_usual(const MultilaterationFit& fit) {
  const auto nu = static_cast<double>(fit.degrees_of_freedom);
  return fit.chi_squared > nu + 2.0 * std::sqrt(2.0 * nu);
}

Result<MultilaterationFit> with_free_scales(const RangeInput& input, const MultilaterationFit& fit) {
  std::vector<RangeReading> readings(input.readings.begin(), input.readings.end());
  for (std::size_t k = 0; k < readings.size(); ++k) readings[k].segment = fit.segments[k];
  MultilaterationOptions options = input.options;
  options.scale = ScaleModel::free;
  options.scale_prior = 0.0;
  options.find_breaks = false;
  options.point_covariances = false;
  return multilaterate(input.nominal_mm, input.stations, readings, options);
}

}  // namespace

std::optional<Finding> scale_finding(const RangeInput& input, const MultilaterationFit& fit) {
  if (input.options.scale == ScaleModel::free || fit.segments.size() != input.readings.size() ||
      !larger_than_usual(fit))
    return std::nullopt;
  const auto free = with_free_scales(input, fit);
  if (!free || static_cast<double>(free->degrees_of_freedom) < freedom_of_scales_least) return std::nullopt;
  const double share = std::max(1.0, free->chi_squared / static_cast<double>(free->degrees_of_freedom));
  const double gain = (fit.chi_squared - free->chi_squared) / share;
  const double chance = numeric::chi_square_quantile(1.0 - by_chance, static_cast<double>(input.stations - 1));
  if (gain < std::max(gain_least, chance)) return std::nullopt;
  const double usual = numeric::upper_median(free->scales);
  std::size_t worst = 0;
  for (std::size_t j = 1; j < free->scales.size(); ++j)
    if (std::abs(free->scales[j] - usual) > std::abs(free->scales[worst] - usual)) worst = j;
  const double um_per_m = 1e6 * (free->scales[worst] - usual);
  return Finding{"multilateration-scales-differ", true,
                 fmt::format("the lengths of station {} are too {} by {} µm/m against those of the others: its air or "
                             "wavelength is not theirs, or it was taken for another; what all have in common no length "
                             "tells",
                             station_name(input.options, worst), um_per_m > 0.0 ? "long" : "short",
                             format_fixed(std::abs(um_per_m), 1))};
}

}  // namespace axiometry::tracking::detail
