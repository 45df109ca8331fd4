// SPDX-License-Identifier: Apache-2.0
#include "axiometry/base/text/rounded_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axiometry/base/text/number_text.h"

namespace axiometry {

std::string format_rounded(double x, int decimals) {
  const double unit = std::pow(10.0, decimals);
  const double rounded = std::round(x * unit) / unit;
  // Where x times the unit is beyond what doubles count one by one, x has no such decimals to round.
  if (!std::isfinite(rounded) || std::abs(x) * unit >= 9e15) return format_exact(x);
  return format_exact(rounded + 0.0);
}

std::string format_significant(double x, int digits) {
  const double unit = std::pow(10.0, std::max(0, decimals_for(std::abs(x), digits)));
  return format_shortest(std::round(x * unit) / unit);
}

std::string format_chance(double p) { return p < 1e-4 ? std::string("p < 0.0001") : fmt::format("p = {:.4f}", p); }

}  // namespace axiometry
