// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "axiometry/simulation/slow_process.h"
#include "axiometry/simulation/timeline.h"

namespace axiometry::simulation {

/// The true deviations of one axis on its way: what virtual_axis.h describes, in µm or ″ over mm or ° and s.
class AxisErrors {
 public:
  /// Both must outlive it. Needs a sound axis.
  AxisErrors(const VirtualAxis& axis, const Plan& plan, const Timeline& timeline, std::uint64_t seed);

  /// What does not change while the axis rests at the end of this leg: all but in_time().
  double rest(std::size_t leg) const { return rest_[leg]; }

  /// What changes with time where the command is c: growth, and at rest hunting.
  double in_time(std::size_t leg, double c, double t) const;

  /// All but in_time() where the command is c on its way.
  double on_the_way(std::size_t leg, double c) const;

  /// What of rest() is random in each approach (stick-slip), and its expectation.
  double stick(std::size_t leg) const { return stick_[leg]; }
  double stick_expected(const Leg& leg) const;
  double hunting(std::size_t leg, double t) const;
  /// Variance of stick-slip and hunting.
  double variance(const Leg& leg) const;

 private:
  /// Where play and wind-up are when a leg begins.
  struct Reversal {
    double play = 0.0;  ///< table minus drive, µm or ″
    double wind = 0.0;  ///< r, −1 to 1
  };

  double curve(double p) const;
  double gap(double p) const;
  Reversal reversal(std::size_t leg, double c) const;

  const VirtualAxis& axis_;
  std::span<const Leg> legs_;
  double per_position_;  ///< µm in a mm, ″ in a °
  double first_, travel_, fixed_;
  SlowProcess walk_;
  std::vector<Reversal> begins_;
  std::vector<double> stick_;      ///< what sticks at each leg's end
  std::vector<double> quantised_;  ///< likewise: to the axis's resolution
  std::vector<double> phase_;      ///< phase of hunting, turns
  std::vector<double> rest_;
};

}  // namespace axiometry::simulation
