// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/base/vector3.h"
#include "axiometry/model/recording.h"

/// Where a reflector is, sample by sample, that is driven along straight ways and rests between them: with a smooth
/// begin and end, in the time that the feed says.
namespace axiometry::simulation {

/// A way and the rest behind it.
struct ReflectorLeg {
  double begin_s = 0.0, arrive_s = 0.0, leave_s = 0.0;
  Vector3 from, to;
  double lost_from = 0.0, lost_to = 0.0;  ///< shares of the time of the way between which the beam is lost

  double way_s() const { return arrive_s - begin_s; }
  bool is_lost(double t_s) const {
    const double share = (t_s - begin_s) / way_s();
    return share > lost_from && share < lost_to;
  }
};

class ReflectorWay {
 public:
  /// At rest before the first move, and what after_last() adds.
  static constexpr double rest_s = 2.0;

  void go(Vector3 to, double feed_mm_per_min, double dwell_s);
  /// Begins there; or is carried there in that time, while nothing is seen.
  void carry(Vector3 to, double seconds, double dwell_s);
  void after_last() { legs_.back().leave_s += rest_s; }

  std::vector<ReflectorLeg>& legs() { return legs_; }
  std::span<const ReflectorLeg> legs() const { return legs_; }
  double duration_s() const { return legs_.back().leave_s; }

  struct Count {
    std::size_t arrived = 0, lost = 0;
  };
  /// Fails on a rate outside 0.001 to 1e7 samples a second, and on more than 1e10 samples. Needs a leg.
  Result<Count> count(double rate) const;

  /// What is shown on a leg at the share of its time, 0 to 1, where the reflector is; `normal` is noise of σ = 1.
  using Shown = std::function<double(std::size_t leg, double share, Vector3 at, double normal)>;
  /// All samples in their order; sample k at k/rate, with noise out of that stream. Fails as the sink does.
  Result<void> record(double rate, std::uint64_t seed, std::uint64_t stream, const Shown& shown,
                      const SampleSink& sink) const;

 private:
  std::vector<ReflectorLeg> legs_;
};

}  // namespace axiometry::simulation
