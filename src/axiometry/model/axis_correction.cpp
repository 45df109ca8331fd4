// SPDX-License-Identifier: Apache-2.0
#include "axiometry/model/axis_correction.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axiometry/base/text/rounded_text.h"

namespace axiometry {

std::string_view curves_name(TableCurves curves) {
  switch (curves) {
    case TableCurves::both_ways: return "both-ways";
    case TableCurves::with_backlash: return "with-backlash";
    case TableCurves::each_way: return "each-way";
  }
  return "";
}

Result<AxisCorrection> AxisCorrection::make(AxisKind kind, std::vector<double> positions, std::vector<double> up,
                                            std::vector<double> down) {
  if (positions.empty()) return fail("found no position in the table, expected at least one");
  if (positions.size() > nodes_max)
    return fail(fmt::format("found {} positions in the table, expected at most {}", positions.size(), nodes_max));
  if (up.size() != positions.size() || down.size() != positions.size())
    return fail(fmt::format("found {} positions with {} values of one direction and {} of the other, expected as many",
                            positions.size(), up.size(), down.size()));
  for (std::size_t k = 0; k < positions.size(); ++k) {
    if (!std::isfinite(positions[k]) || !std::isfinite(up[k]) || !std::isfinite(down[k]))
      return fail(fmt::format("found no finite number in row {} of the table, expected numbers alone", k + 1));
    if (k > 0 && !(positions[k] > positions[k - 1]))
      return fail(fmt::format("found position {} after {}, expected positions that ascend",
                              format_rounded(positions[k]), format_rounded(positions[k - 1])));
    for (const double value : {up[k], down[k]})
      if (std::abs(value) > largest_um)
        return fail(fmt::format("found a correction of {:.4g} {} at {}, expected at most {:.0f}", value,
                                deviation_unit(kind), format_rounded(positions[k]), largest_um));
  }
  return AxisCorrection(kind, std::move(positions), std::move(up), std::move(down));
}

double AxisCorrection::at(double position, Direction direction) const {
  const std::vector<double>& value = values(direction);
  const auto above = std::ranges::upper_bound(positions_, position);
  if (above == positions_.begin()) return value.front();
  if (above == positions_.end()) return value.back();
  const auto k = static_cast<std::size_t>(above - positions_.begin());
  const double share = (position - positions_[k - 1]) / (positions_[k] - positions_[k - 1]);
  return value[k - 1] + share * (value[k] - value[k - 1]);
}

}  // namespace axiometry
