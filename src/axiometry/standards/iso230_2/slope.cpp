// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/slope.h"

#include <algorithm>
#include <cmath>

namespace axiometry::iso230_2 {

std::optional<Slope> slope_of_means(std::span<const PositionResult> positions) {
  const auto each = [&](auto&& visit) {
    for (const PositionResult& p : positions)
      for (const auto& mean : {p.mean_up, p.mean_down})
        if (mean) visit(p.target.in_native(), mean->in_native());
  };
  double n = 0.0, mean_p = 0.0, mean_x = 0.0, pp = 0.0, px = 0.0;
  each([&](double p, double x) { n += 1.0, mean_p += p, mean_x += x; });
  mean_p /= n;
  mean_x /= n;
  each([&](double p, double x) { pp += (p - mean_p) * (p - mean_p), px += (p - mean_p) * (x - mean_x); });
  const double slope = px / pp;
  if (!std::isfinite(slope)) return std::nullopt;
  double lowest = 0.0, highest = 0.0;
  each([&](double p, double x) {
    const double rest = x - mean_x - slope * (p - mean_p);
    lowest = std::min(lowest, rest);
    highest = std::max(highest, rest);
  });
  return Slope{slope, Deviation::native(highest - lowest)};
}

}  // namespace axiometry::iso230_2
