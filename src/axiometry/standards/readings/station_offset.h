// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/model/metadata.h"
#include "axiometry/uncertainty/distribution.h"

/// What a test along a line gets from a tracking interferometer whose station is not where it was determined: the
/// length difference of Lee et al., Sensors 16 (2016) 482, eqs 17 to 23, as an error of readings. Derivation:
/// docs/theory/uncertainty.md, "The station".
///
/// The station lies beside the line by Δ⊥. At the distance d = |P − P_s| the length shown is √(d² + Δ⊥²), which is
///   δ(d) = √(d² + Δ⊥²) − d = Δ⊥²/(√(d² + Δ⊥²) + d)
/// more than d; this form does not cancel. Deviations count along the line, from a fixed target r, the one farthest
/// from the station: a reading at P has the error ± (δ(d) − δ(d_r)), + where the distance grows with the position. It
/// is the same in all runs and both directions. An error of the station along the line only moves the zero (and d
/// within δ, by Δ∥/d of it) and is left out.
namespace axiometry {

/// The items of TrackingInputs where they make sense.
struct StationOffset {
  Position at;              ///< P_s
  double larger_mm = 0.0;   ///< u1 ≥ u2: standard uncertainties of Δ⊥ in its principal directions
  double smaller_mm = 0.0;  ///< u2 ≥ 0
};

/// Said where a misalignment was given as well.
inline constexpr std::string_view followed_beam_note =
    "The beam of a tracking interferometer follows the reflector: the uncertainty of its station takes the place of "
    "the "
    "misalignment, which is left out";

/// Absent when nothing was given, or what was given is not enough (station_offset_problem()).
std::optional<StationOffset> station_offset(const Metadata& metadata);

/// Why the items are not used: a position without uncertainties or the reverse, not two finite numbers of at least 0
/// and at most 1e6 mm, a rotary axis. Empty when they are used, are both 0, or none was given. A clause for notes.
std::string station_offset_problem(const Metadata& metadata);

/// The errors of readings at the targets of a series.
class StationErrors {
 public:
  /// Needs at least one target.
  StationErrors(std::span<const Position> targets, Position station);

  /// Error of a reading at a target, µm, for Δ⊥² in mm² (at least 0).
  double error_um(std::size_t target, double offset_squared_mm2) const;
  /// Its derivative by Δ⊥², µm/mm². Infinite on the station itself for Δ⊥ = 0.
  double slope_um_per_mm2(std::size_t target, double offset_squared_mm2) const;
  /// The largest error_um(k) − error_um(l).
  double range_um(double offset_squared_mm2) const;

  std::size_t count() const { return distances_mm_.size(); }
  double nearest_mm() const;
  double farthest_mm() const { return distances_mm_[reference_]; }

 private:
  std::vector<double> distances_mm_;
  std::vector<double> signs_;
  std::size_t reference_ = 0;
};

/// The value that Δ⊥² = (u1 z1)² + (u2 z2)², z1 and z2 standard normal, stays below with probability p, mm². From
/// 1 − (2/π) ∫ exp(−q/2w) dφ, w = u1² cos² φ + u2² sin² φ, a periodic integral that 64 points give within 1e-15; the
/// quantile is within 1e-13 of itself. Needs 0 < p < 1 and finite u ≥ 0.
double offset_squared_quantile(const StationOffset& offset, double p);

/// Mean and standard deviation of x² for x of this distribution; of a normal one exact, else by the trapezoidal rule on
/// the normal scale, to a relative 1e-4. Of a t distribution with ν ≤ 4 the square has no standard deviation.
struct SquareMoments {
  double mean = 0.0;
  std::optional<double> standard_deviation;
};
SquareMoments square_moments(const uncertainty::Distribution& distribution);

}  // namespace axiometry
