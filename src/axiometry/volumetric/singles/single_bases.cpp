// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/singles/single_bases.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axiometry/volumetric/singles/single_places.h"

namespace axiometry::volumetric {

TravelBox SingleBases::ranges() const {
  TravelBox box;
  for (std::size_t a = 0; a < axis_count; ++a) {
    box.lowest_mm[a] = bases[a].lower_mm();
    box.highest_mm[a] = bases[a].upper_mm();
  }
  return box;
}

Result<SingleBases> bases_of_singles(const TravelBox& travel, const SingleErrors& errors) {
  SingleBases all;
  for (std::size_t a = 0; a < axis_count; ++a) {
    double lower = travel.lowest_mm[a], upper = travel.highest_mm[a];
    std::size_t nodes = single_nodes_most;
    bool any = false, cut = false;
    for (const SingleMotion& m : errors.motions) {
      if (m.error.axis != a) continue;
      const double first = m.positions_mm.front(), last = m.positions_mm.back();
      if (first < travel.lowest_mm[a] - single_travel_slack_mm || last > travel.highest_mm[a] + single_travel_slack_mm)
        return fail(fmt::format(
            "found readings of {} from {} to {} mm, expected them within the travel of {} from {} "
            "to {} mm",
            error_name(m.error), first, last, single_axis_letters[a], travel.lowest_mm[a], travel.highest_mm[a]));
      cut = cut || (any && (std::abs(first - lower) > 1e-6 || std::abs(last - upper) > 1e-6));
      lower = any ? std::max(lower, first) : first;
      upper = any ? std::min(upper, last) : last;
      nodes = std::min(nodes, m.positions_mm.size());
      any = true;
    }
    if (!(lower < upper))
      return fail(
          fmt::format("found errors of {} that have no range in common, expected readings of all of them over "
                      "one travel",
                      single_axis_letters[a]));
    all.cut[a] = cut;
    if (cut)
      all.findings.push_back({"single-common-range", false,
                              fmt::format("{}: only from {} to {} mm, where all its errors were read",
                                          single_axis_letters[a], lower, upper)});
    AXIOMETRY_TRY(const CurveBasis basis,
                  CurveBasis::make(CurveKind::nodes, lower, upper, any ? std::max<std::size_t>(nodes, 2) - 1 : 1));
    all.bases.push_back(basis);
  }
  return all;
}

}  // namespace axiometry::volumetric
