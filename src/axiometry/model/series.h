// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/axis.h"

namespace axiometry {

/// Direction of approach (3.7): up (↑) is positive along or around the axis.
enum class Direction { up = 0, down = 1 };

std::string_view arrow(Direction direction);  ///< "↑" or "↓"

/// One reading: the positioning deviation x_ij (3.6) of approach j to target i from one direction.
struct Reading {
  std::size_t target = 0;  ///< index i − 1
  Direction direction = Direction::up;
  std::size_t run = 0;  ///< index j − 1
  Deviation deviation;
};

/// The measured deviations of one axis: m targets (3.4) in ascending order, up to n approaches to
/// each from either direction, any of which may be missing. Immutable.
///
/// Invariants: m ≥ 2; targets strictly ascending, |P| ≤ 1e9; every target has a reading; every reading
/// is finite and |x| ≤ 1e9 (a kilometre or 277 778°, beyond which a file is wrong, not a machine).
class Series {
 public:
  /// Fails, naming the offending target or reading, when an invariant above is broken, when a reading
  /// is given twice, when its target index is out of range or its run index beyond any test (2·m·runs
  /// above 2²⁸).
  static Result<Series> make(std::vector<Position> targets, std::span<const Reading> readings);

  /// The dense form for machines: deviations in native units, ordered direction, target, run (run
  /// fastest), NaN where missing; `deviations.size()` is 2·m·runs. Same invariants and failures.
  static Result<Series> make_dense(std::vector<Position> targets, std::size_t runs, std::vector<double> deviations);

  std::size_t target_count() const { return targets_.size(); }  ///< m
  std::size_t run_count() const { return runs_; }               ///< n, the largest run number
  std::span<const Position> targets() const { return targets_; }

  std::optional<Deviation> reading(std::size_t target, Direction direction, std::size_t run) const;

  /// All runs of one target and direction in native units (µm or ″), NaN where missing; length
  /// run_count(). For kernels.
  std::span<const double> cell(std::size_t target, Direction direction) const {
    return {deviations_.data() + (static_cast<std::size_t>(direction) * targets_.size() + target) * runs_, runs_};
  }

  /// Number of readings of one target and direction.
  std::size_t count(std::size_t target, Direction direction) const;
  /// Whether any target was approached in this direction.
  bool has(Direction direction) const;
  /// Whether it is a bidirectional test.
  bool has_both_directions() const { return has(Direction::up) && has(Direction::down); }
  /// Number of readings in all.
  std::size_t reading_count() const;
  /// Whether every target has a reading of every run from both directions.
  bool complete() const { return reading_count() == deviations_.size(); }

  /// Measured travel: last minus first target, mm or °.
  double travel_native() const { return targets_.back().in_native() - targets_.front().in_native(); }

 private:
  Series(std::vector<Position> targets, std::size_t runs, std::vector<double> deviations)
      : targets_(std::move(targets)), runs_(runs), deviations_(std::move(deviations)) {}

  std::vector<Position> targets_;
  std::size_t runs_ = 0;
  std::vector<double> deviations_;
};

}  // namespace axiometry
