// SPDX-License-Identifier: Apache-2.0
#pragma once

/// How well fits of different numbers of unknowns fit. Internal to identify().
namespace axiometry::volumetric::detail {

struct FitQuality {
  double chi_squared = 0.0;
  double degrees_of_freedom = 1.0;

  double excess() const { return chi_squared - degrees_of_freedom; }
  double ratio() const { return chi_squared / degrees_of_freedom; }
};

/// What more unknowns gain.
struct Gained {
  double chi_squared = 0.0;  ///< by which it falls
  double unknowns = 0.0;
};

/// By the F test of two fits of which the larger one holds the other, which needs no σ: the chance of as much or more
/// where the smaller one is true.
double chance_of(const Gained& gained, const FitQuality& larger);

}  // namespace axiometry::volumetric::detail
