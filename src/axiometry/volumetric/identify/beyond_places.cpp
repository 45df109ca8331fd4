// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/identify/beyond_places.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "axiometry/volumetric/identify/curve_choice.h"

namespace axiometry::volumetric::detail {
namespace {

constexpr double unsuspicious_ratio = 1.1;  // χ²/ν
constexpr double gain_of_ratio = 0.05;
constexpr std::size_t places_looked_for = 100;

double chi_squared_per_dof(const Identifier& done) {
  const double left =
      static_cast<double>(done.count()) - static_cast<double>(done.fit().solution.told()) - done.taken_by_scales();
  return left > 0.0 ? done.fit().chi_squared / left : 1.0;
}

/// Spans of a spline with four functions for five places, where half as many as places hold it down; else 0.
std::size_t spans_beyond_places(std::size_t functions, std::vector<double> positions) {
  const std::size_t places = different_places(std::move(positions), places_looked_for);
  const std::size_t wanted = 4 * places / 5;
  const bool is_held_down = places < places_looked_for && places_for_function * (functions + 1) > places;
  return is_held_down && wanted > functions ? wanted - 3 : 0;
}

std::size_t set_aside(const Identifier& done) {
  return static_cast<std::size_t>(std::ranges::count(done.set_aside(), true));
}

}  // namespace

std::optional<IdentifyOptions> options_beyond_places(const Identifier& done, const VolumetricLengths& lengths,
                                                     const IdentifyOptions& options) {
  const bool is_suspicious = !done.breaks().empty() || done.drift() || chi_squared_per_dof(done) > unsuspicious_ratio;
  if (options.curves != CurveKind::spline || !is_suspicious) return std::nullopt;
  IdentifyOptions finer = options;
  bool is_any_finer = false;
  for (std::size_t a = 0; a < axis_count; ++a) {
    if (options.sizes[a] > 0) continue;
    const std::size_t functions = done.coefficients().basis(a).functions();
    std::vector<double> positions;
    for (const VolumetricReading& reading : lengths.readings) positions.push_back(reading.axes_mm[a]);
    const std::size_t spans = spans_beyond_places(functions, std::move(positions));
    is_any_finer = is_any_finer || spans > 0;
    finer.sizes[a] = spans > 0 ? spans : functions - 3;
  }
  return is_any_finer ? std::optional(finer) : std::nullopt;
}

bool leaves_less(const Identifier& finer, const Identifier& done) {
  return chi_squared_per_dof(finer) < (1.0 - gain_of_ratio) * chi_squared_per_dof(done) &&
         finer.breaks().size() <= done.breaks().size() && set_aside(finer) <= set_aside(done) &&
         std::ranges::includes(done.fit().solution.unseen_errors(), finer.fit().solution.unseen_errors());
}

}  // namespace axiometry::volumetric::detail
