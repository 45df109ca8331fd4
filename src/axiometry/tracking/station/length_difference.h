// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "axiometry/base/quantity.h"
#include "axiometry/base/vector3.h"
#include "axiometry/model/tracking.h"

/// What a station that is not where it was determined does to the lengths along a line (Lee et al., 4.1, eqs 16 to 23;
/// the signs of eqs 21 and 22 are corrected, see docs/theory/length-difference.md).
///
/// The line passes through the determined station. Δ = determined − actual (16); along the line Δ∥, across it Δ⊥. At a
/// nominal distance d the actual one is d̂ = √((Δ∥ + d)² + Δ⊥²), and relative to the last target n
///   Δd[k] = (d̂[k] − d̂[n]) − (d[k] − d[n]) = d̂[k](1 − cos α[k]) − d̂[n](1 − cos α[n])           (19)
/// with α = atan2(Δ⊥, Δ∥ + d) (18). Computed as d̂(1 − cos α) = Δ⊥²/(d̂ + Δ∥ + d), which does not cancel: each of
/// the two terms is within 1e-15 of itself. The same holds for a line of any direction.
namespace axiometry::tracking {

struct LengthDifference {
  Angle alpha;        ///< α[k] (18)
  Length difference;  ///< Δd[k] (19), relative to the reference
};

/// One per distance. `direction` is that of the line, of length 1, away from the station; distances above 0.
/// Needs reference < distances.size(). The difference at the reference is exactly 0.
std::vector<LengthDifference> length_differences(Vector3 station_error_mm, Vector3 direction,
                                                 std::span<const double> distances_mm, std::size_t reference);

/// The paper's eq. 23: the root of the sum of squares of Δd on the x, y and z lines at the same k. A figure for
/// bookkeeping; no path of the machine has that error.
std::vector<Length> combined_length_differences(Vector3 station_error_mm, std::span<const double> distances_mm,
                                                std::size_t reference);

/// What the uncertainty of the station does to a line: Δ⊥ has two principal components with standard uncertainties
/// u1 ≥ u2, from the covariance of s seen along the line.
struct OffsetUncertainty {
  double larger_mm = 0.0;
  double smaller_mm = 0.0;
};
OffsetUncertainty offset_uncertainty(const Matrix3& covariance_mm2, Vector3 direction);

/// The q with P(Δ⊥² ≤ q) = probability, in mm², for Δ⊥² = u1² z1² + u2² z2² (z standard normal): that of
/// standards/readings/station_offset.h, where the method and its error are told. The two uncertainties may stand in any
/// order. Contract: 0 < probability < 1.
double squared_offset_quantile_mm2(const OffsetUncertainty& offset, double probability);

/// Half width that holds |Δd| at each distance with 95 %, for Δ⊥ normal with these standard uncertainties: the 95 %
/// quantile of Δ⊥² times ½|1/d − 1/d_n|, which leaves out terms of the relative size Δ/d.
std::vector<Length> length_difference_bounds(const OffsetUncertainty& offset, std::span<const double> distances_mm,
                                             std::size_t reference);

/// From which distance on |Δd|, as above, is less than `fraction` of the instrument's expanded uncertainty at that
/// distance (one third makes it 5 % of the combined uncertainty), with the reference far away: where
/// q/(2d) = fraction·(a + b·d). 0 for a station known exactly; infinite for an instrument without uncertainty.
double negligible_from_mm(const OffsetUncertainty& offset, const RangingUncertainty& ranging, double fraction);

}  // namespace axiometry::tracking
