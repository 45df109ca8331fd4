// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "axiometry/model/recording.h"
#include "axiometry/model/series.h"

namespace axiometry::capture {

/// Where an axis has been and which way it went last. A change of direction counts once the axis has come back by
/// `turn`, so that noise, vibration and overshoot are none; of samples in motion the median of three neighbours counts,
/// so that a single false sample is none either. mm or °.
class Travel {
 public:
  explicit Travel(double turn) : turn_(turn) {}

  void move_to(double position);
  void move_along(std::span<const Sample> samples);
  /// Samples are missing: which way the axis went is not known any more.
  void forget();
  /// lowest() and highest() count from here.
  void begin_stretch(double position) { lowest_ = highest_ = position; }
  /// The places where it began to move, or changed its direction, since the last call: the first 20 000 of them.
  std::vector<double> take_turns();

  std::optional<Direction> direction() const { return direction_; }
  double lowest() const { return lowest_; }
  double highest() const { return highest_; }
  /// How far beyond that position it was in the direction in which it went last; 0 where that is not known.
  double beyond(double position) const;

 private:
  void go_to(double position);

  double turn_;
  bool anywhere_ = false;
  std::optional<Direction> direction_;
  double turn_low_ = 0.0, turn_high_ = 0.0;  // extremes since the last change of direction
  double lowest_ = 0.0, highest_ = 0.0;
  double before_[2] = {};  // the last samples along which it moved
  std::size_t befores_ = 0;
  std::vector<double> turns_;
};

}  // namespace axiometry::capture
