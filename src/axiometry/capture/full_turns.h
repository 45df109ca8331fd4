// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "axiometry/model/plan.h"
#include "axiometry/model/recording.h"

namespace axiometry::capture {

inline constexpr double full_turn_deg = 360.0;

/// What a rotary axis is taken never to turn by faster, °/s: 500, twice the plan's feed if that is more.
double fastest_turn(double feed_deg_per_min);

/// Counts the turns of an instrument of angles that shows the same again after each (0° to 360°, −180° to 180°), so
/// that positions go on where it rolls over. A step of one turn, give or take what the axis moves meanwhile, is a
/// rollover where half a turn is more than it can move between the two samples; a stream without any stays as it is,
/// to the last digit. Once three samples in a row lie behind a rollover, the instrument is one that rolls over: then of
/// what it shows behind a gap, too, that counts which lies next to where it was. Up to two false samples count for
/// nothing.
class FullTurns {
 public:
  explicit FullTurns(double fastest_deg_per_s) : fastest_deg_per_s_(fastest_deg_per_s) {}

  /// The samples (°, in order of time) as an axis has them that counts on; valid until the next call. The result does
  /// not depend on how a recording is cut into pieces.
  std::span<const Sample> follow(std::span<const Sample> shown);

  /// From when on the instrument is known to roll over, s; nothing while it has not.
  std::optional<double> rolls_from_s() const { return rolls_from_s_; }
  /// What the instrument shows where the axis, counted on, is at a position of its last turns, °: that of all a full
  /// turn apart which lies next to the middle of what it has shown. A mean of samples on both sides of a rollover may
  /// be less or more than anything it shows, by part of what the axis moved meanwhile.
  double shown_deg(double position_deg) const;

 private:
  double reach_deg(const Sample& shown) const;
  void take(const Sample& shown);
  void see(double shown_deg);

  double fastest_deg_per_s_;
  double turns_ = 0.0;       // whole turns that are added to what is shown
  double lowest_deg_ = 0.0;  // lowest and highest that was shown, of samples that were no false ones
  double highest_deg_ = 0.0;
  std::optional<Sample> last_;  // the last sample that was no false one, turns added
  double step_s_ = 0.0;         // last time between two samples that were not of one burst, s
  std::size_t doubtful_ = 0;    // samples in a row that the axis cannot have reached
  std::size_t rolled_ = 0;      // samples in a row behind a rollover, until it is believed
  double rolled_at_s_ = 0.0;    // time of the first of them
  std::optional<double> rolls_from_s_;
  std::vector<Sample> counted_on_;
};

}  // namespace axiometry::capture
