// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/plan.h"
#include "axiometry/simulation/timeline.h"

/// An axis whose error of motion is known, a straightness or a rotation, and an instrument that looks at it while a
/// plan is walked. Numbers are mm, s, and µm or µrad.
namespace axiometry::simulation {

struct VirtualMotion {
  double size = 5.0;    ///< size of the bow, above 0
  bool drifts = false;  ///< readings move by half the size over the time of the plan
};

/// What is true at a place: with s = (P − P_1)/(P_m − P_1) size · (4 s (1 − s) + 0.6 s), a bow over a slope, and
/// 0.15 · size more where the axis came ↓. Needs a plan of two targets or more.
double true_motion(const VirtualMotion& motion, const Plan& plan, double position_mm, Direction direction);

/// Where the axis is at a moment of its program, and what is read there.
class MotionWalk {
 public:
  /// Without the plan's warm-up. Fails on a plan of one target, and as Timeline::make() does. Needs a sound plan of a
  /// linear axis.
  static Result<MotionWalk> make(const Plan& plan, const VirtualMotion& motion, std::uint64_t seed);

  /// A rest at which a reading is taken.
  struct Rest {
    double from_s = 0.0;
    double to_s = 0.0;
    double middle_s() const { return 0.5 * (from_s + to_s); }
  };
  const std::vector<Rest>& rests() const { return rests_; }  ///< rests in the order of approaches()
  double duration_s() const { return timeline_.duration(); }

  struct Moment {
    double position_mm = 0.0;
    double value = 0.0;    ///< read: true, 0.03 · size · z of each approach, the drift, noise of each sample
    bool at_rest = false;  ///< whether a reading is taken there
    bool trigger = false;  ///< whether it is on: a tenth of a second, three tenths of the rest behind its beginning
  };
  /// The noise is min(0.02 · size, 1), three times that on the way, and depends on the number of the sample alone. What
  /// is shown of the position scatters by 0.05 µm.
  Moment at(double walked_s, std::uint64_t sample);

 private:
  MotionWalk(Plan plan, const VirtualMotion& motion, std::uint64_t seed, Timeline timeline);
  void draw(std::uint64_t sample);

  Plan plan_;
  VirtualMotion motion_;
  std::uint64_t seed_;
  Timeline timeline_;
  std::vector<Rest> rests_;
  std::vector<std::size_t> rest_of_leg_;  // the one that it leads to
  std::vector<double> scatter_;           // scatter of each rest
  std::vector<double> noise_;             // two for each sample of a block
  std::uint64_t block_ = UINT64_MAX;
};

}  // namespace axiometry::simulation
