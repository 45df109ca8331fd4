// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "axiometry/model/recording.h"

namespace axiometry::capture {

/// Parts a recording of lengths where they jump from one sample to the next by more than any motion makes of them, and
/// stay: the beam was broken and found again while samples went on. Up to two false samples in a row are no break.
/// Tells where so many samples are missing that the beam may have been broken meanwhile, though no jump shows it: for
/// more than 0.1 s and ten times the longest step of the last seconds, if the length changed; the longest, since
/// samples that come in bursts have steps of 0. One pass; keeps three samples at most.
class BeamWatch {
 public:
  struct Limit {
    double speed_mm_per_s = 500.0;  ///< no reflector is faster
    double least_mm = 0.5;          ///< a smaller jump is none, whatever the time between the samples
    double resting_mm = 0.02;       ///< what a length changes by at most while the reflector rests
  };
  explicit BeamWatch(Limit limit) : limit_(limit) {}

  struct Sink {
    std::function<void(std::span<const Sample>)> samples;  ///< called with samples in their order
    std::function<void(double time_s)> broken;             ///< called at a break, before the samples behind it
    std::function<void(double time_s)> missing;            ///< called with the time of the first sample behind a gap
  };
  void push(std::span<const Sample> samples, const Sink& sink);
  /// Samples are missing here, or the recording ends.
  void interrupt(const Sink& sink);

 private:
  bool jumps(const Sample& from, const Sample& to) const;
  void take_sound(const Sample& sample, const Sink& sink);

  Limit limit_;
  std::optional<Sample> sound_;  // the last sample that is no false one
  double longest_step_s_ = 0.2;  // largest step of late, s; as slow as lengths come, until they are seen
  std::vector<Sample> held_;     // samples from one on that may be the first behind a break
};

}  // namespace axiometry::capture
