// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/scatter/variance_ratio.h"

#include "axiometry/numeric/distributions/f_distribution.h"

namespace axiometry::iso230_2::scatter {

double ratio_tail(const Sum& part, const Sum& rest, const Rounding& rounding, double level) {
  if (part.degrees <= 0.5 || rest.degrees <= 0.5) return 1.0;
  const double below = std::max(rest.variance(), rounding.variance());
  if (below <= 0.0) return part.variance() > 0.0 ? 0.0 : 1.0;
  const double ratio = part.variance() / below;
  const numeric::RatioDegrees degrees{part.degrees, rest.degrees};
  return numeric::f_tail_is_above(level, ratio, degrees) ? 1.0 : numeric::f_tail(ratio, degrees);
}

}  // namespace axiometry::iso230_2::scatter
