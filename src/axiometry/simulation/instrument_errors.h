// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "axiometry/simulation/slow_process.h"
#include "axiometry/simulation/timeline.h"

namespace axiometry::simulation {

/// What the instrument and its surroundings add to true positions, white noise and rounding aside: virtual_axis.h, in
/// µm or ″ over mm or ° and s.
class InstrumentErrors {
 public:
  /// The instrument and the plan must outlive it. Needs sound ones; fails when the test lasts more than 1e7 steps of a
  /// random quantity (of a second for the drift, an eighth of its correlation time for the air).
  static Result<InstrumentErrors> make(const VirtualInstrument& instrument, const Plan& plan, const Timeline& timeline,
                                       std::uint64_t seed);

  /// At the position p in this leg, at rest or moving.
  double at(std::size_t leg, double p, double t) const;

  bool is_outlier(std::size_t leg) const { return outlier_[leg] != 0.0; }

  /// What is shown for target or command p and a deviation from it: the deviation after rounding.
  double shown(double p, double deviation) const;

 private:
  InstrumentErrors(const VirtualInstrument& instrument, const Plan& plan, std::span<const Leg> legs,
                   std::uint64_t seed);

  const VirtualInstrument* instrument_;
  std::span<const Leg> legs_;
  double per_position_;
  double first_;
  double expansion_ = 0.0;                          ///< relative
  double air_phase_ = 0.0, vibration_phase_ = 0.0;  ///< turns
  bool air_ = false;
  SlowProcess drift_, air_random_;
  std::vector<double> slipped_;  ///< shift since the beginning of each leg, all slips so far
  std::vector<double> outlier_;
};

}  // namespace axiometry::simulation
