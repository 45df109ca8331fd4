// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/identify/findings/one_sided_places.h"

#include <fmt/format.h>

#include <algorithm>

#include "axiometry/base/text/number_text.h"

namespace axiometry::volumetric::detail {
namespace {

/// Of `given`, those on ways that `missing` leaves out. Both rising.
void add_left_out(const std::vector<double>& given, const std::vector<double>& missing, const RestPlaces& places,
                  double way_mm, bool is_up, std::vector<OneSidedPlaces>& found) {
  for (std::size_t k = 0; k <= missing.size(); ++k) {
    const bool is_first = k == 0, is_last = k == missing.size();
    const double begin = is_first ? places.lower_mm : missing[k - 1], end = is_last ? places.upper_mm : missing[k];
    if (!(end - begin > way_mm)) continue;
    const auto first = is_first ? given.begin() : std::ranges::upper_bound(given, begin);
    const auto last = is_last ? given.end() : std::ranges::lower_bound(given, end);
    if (first < last) found.push_back({*first, *std::prev(last), is_up});
  }
}

std::string one_sided_text(std::size_t axis, const OneSidedPlaces& p) {
  const std::string where = p.lowest_mm == p.highest_mm ? fmt::format("at {} mm", format_exact(p.lowest_mm))
                                                        : fmt::format("from {} to {} mm", format_exact(p.lowest_mm),
                                                                      format_exact(p.highest_mm));
  return fmt::format(
      "{} came to rest {} moving {} only: what it does there moving {}, and so the mean of both directions, is what "
      "its curves make of readings elsewhere",
      "XYZ"[axis], where, p.is_up ? "up" : "down", p.is_up ? "down" : "up");
}

}  // namespace

std::vector<OneSidedPlaces> one_sided_places(RestPlaces places, double way_mm) {
  std::ranges::sort(places.up_mm);
  std::ranges::sort(places.down_mm);
  std::vector<OneSidedPlaces> found;
  add_left_out(places.up_mm, places.down_mm, places, way_mm, true, found);
  add_left_out(places.down_mm, places.up_mm, places, way_mm, false, found);
  return found;
}

void add_one_sided_places(const Identifier& done, const VolumetricLengths& lengths,
                          std::vector<VolumetricFinding>& findings) {
  if (done.coefficients().reversal() != Reversal::curves) return;
  for (std::size_t a = 0; a < axis_count; ++a) {
    const CurveBasis& basis = done.coefficients().basis(a);
    RestPlaces places{{}, {}, basis.lower_mm(), basis.upper_mm()};
    for (std::size_t i = 0; i < lengths.readings.size(); ++i) {
      const double direction = done.approaches()[i][a];
      if (direction == 0.0 || done.weights()[i] == 0.0) continue;
      (direction > 0.0 ? places.up_mm : places.down_mm).push_back(lengths.readings[i].axes_mm[a]);
    }
    const double span_mm = (basis.upper_mm() - basis.lower_mm()) / static_cast<double>(basis.size());
    for (const OneSidedPlaces& p : one_sided_places(std::move(places), 0.5 * span_mm))
      findings.push_back({"volumetric-one-sided-places", false, one_sided_text(a, p)});
  }
}

}  // namespace axiometry::volumetric::detail
