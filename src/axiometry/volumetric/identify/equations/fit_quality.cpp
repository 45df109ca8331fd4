// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/identify/equations/fit_quality.h"

#include "axiometry/numeric/distributions/f_distribution.h"

namespace axiometry::volumetric::detail {

double chance_of(const Gained& gained, const FitQuality& larger) {
  if (!(gained.chi_squared > 0.0 && gained.unknowns >= 1.0 && larger.chi_squared > 0.0)) return 1.0;
  if (!(larger.degrees_of_freedom >= 1.0)) return 1.0;
  return numeric::f_tail(gained.chi_squared / gained.unknowns / larger.ratio(),
                         {gained.unknowns, larger.degrees_of_freedom});
}

}  // namespace axiometry::volumetric::detail
