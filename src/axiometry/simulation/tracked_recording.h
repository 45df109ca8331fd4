// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/recording.h"
#include "axiometry/model/tracking.h"
#include "axiometry/simulation/reflector_way.h"
#include "axiometry/simulation/tracked_machine.h"

/// What a tracking interferometer shows all the time while the lines of a plan are driven: the continuous recording
/// that belongs to simulate_lengths(). At every stop the reflector rests for the dwell where the simulated reading had
/// it; on the way it goes straight, with a smooth begin and end, in the time that the feed says. Noise is that of each
/// sample. A beam break that is told takes the samples of three fifths of the longest way before its reading, one that
/// is not lets the length jump in the middle of that way.
///
/// Deliberately absent: growth while the reflector rests, play on the way, corners that are rounded.
namespace axiometry::simulation {

class TrackedRecording {
 public:
  /// `lengths` are those that simulate_lengths() made of the same machine, tracker and plan. Fails on a rate outside
  /// 0.001 to 1e7 samples a second, and on more than 1e10 samples.
  static Result<TrackedRecording> make(const TrackedMachine& machine, const VirtualTracker& tracker,
                                       const TrackingPlan& plan, const SimulatedLineLengths& lengths, double rate,
                                       std::uint64_t seed);

  std::size_t samples() const { return count_.arrived; }
  std::size_t lost() const { return count_.lost; }
  double duration_s() const { return way_.duration_s(); }

  /// All samples in their order; sample k at k/rate. Fails as the sink does.
  Result<void> record(const SampleSink& sink) const;

 private:
  /// What happens to the length on a leg.
  struct LegLength {
    double jump_mm = 0.0;       // jump in the middle of the way
    double dead_path_mm = 0.0;  // dead path at its begin
  };
  TrackedRecording(const VirtualTracker& tracker, double rate, std::uint64_t seed)
      : tracker_(tracker), rate_(rate), seed_(seed) {}
  void break_beams(const std::vector<std::size_t>& stops);
  double shown_mm(const LegLength& leg, double share, Vector3 at, double normal) const;

  VirtualTracker tracker_;
  double rate_;
  std::uint64_t seed_;
  ReflectorWay way_;
  std::vector<LegLength> lengths_;  // length of each leg
  ReflectorWay::Count count_;
};

}  // namespace axiometry::simulation
