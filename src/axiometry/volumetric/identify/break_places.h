// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "axiometry/volumetric/identify/equations/normal_equations.h"

/// Before which reading the beam was broken, once it is known that it was. Internal to identify().
namespace axiometry::volumetric::detail {

/// All of them readings of the stretch that a break cuts.
struct BreakPlace {
  std::size_t before = 0;    ///< the likeliest
  std::size_t earliest = 0;  ///< first and last that are no less than a thousandth as likely
  std::size_t latest = 0;

  bool is_certain() const { return earliest == latest; }
  bool operator==(const BreakPlace&) const = default;
};

/// The place c of each break that makes
///   Σ_{i<c} ρ(z_i) + Σ_{i≥c} ρ(z_i),  ρ(z) = min(z², L² + 2 ln 1000),
/// least over the readings of the two stretches beside it. Stations and errors are held as they were fitted; the dead
/// path of each side, and its drift, are those that fit best for every c. L is outlier_limit(): what lies within it of
/// one side and far from the other belongs to the one, and what is far from both has no say. Two readings stay on
/// either side, also of what lies between two breaks. All places of a break in one pass: running sums, the readings
/// that enter those of a side being the ones that ρ does not cut off there as it was fitted. `breaks` rise;
/// `everything` has the weight of every reading, those that are left out included.
std::vector<BreakPlace> break_places(const Problem& everything, const State& state,
                                     std::span<const double> residuals_um, std::span<const std::size_t> breaks);

}  // namespace axiometry::volumetric::detail
