// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "axiometry/model/plan.h"
#include "axiometry/model/recording.h"

/// An axis that is driven after a plan while something is read that is no position.
namespace axiometry::testing_support {

/// Three targets, 0, 100 and 200 mm, two runs there and back; 10 s from stop to stop, 4.6 s where the axis turns.
inline Plan straightness_plan() {
  Plan plan;
  plan.axis.name = "X";
  plan.errors = {*motion_name("EYX")};
  plan.targets = {Position::native(0.0), Position::native(100.0), Position::native(200.0)};
  plan.runs = 2;
  plan.overrun = Position::native(5.0);
  plan.feed = 1000.0;
  plan.dwell = Duration::s(4.0);
  return plan;
}

/// µm: a line, a bend, what differs from run to run and on the way back.
inline double true_straightness_um(const Plan& plan, const Approach& a) {
  const double x = plan.targets[a.target].in_native();
  return 0.02 * x + 1e-4 * x * (200.0 - x) + (a.direction == Direction::down ? 0.5 : 0.0) +
         0.1 * static_cast<double>(a.run);
}

struct DrivenSample {
  double time_s = 0.0;
  double position_mm = 0.0;
  double value_um = 0.0;
  bool trigger = false;
};

struct Stop {
  Approach approach;
  double begin_s = 0.0;
  double end_s = 0.0;
};

/// All samples of the program at 50 Hz. The reading follows the place, and is noisier on the way; the trigger is on for
/// a tenth of a second from half the dwell on.
class DrivenAxis {
 public:
  explicit DrivenAxis(const Plan& plan) : plan_(plan) {
    for (const PlannedMove& move : moves(plan)) drive(move);
  }
  const std::vector<DrivenSample>& samples() const { return samples_; }
  const std::vector<Stop>& stops() const { return stops_; }

 private:
  static constexpr double step_s = 0.02;

  void drive(const PlannedMove& move) {
    const double to = move.to.in_native();
    const double speed = plan_.feed / 60.0;
    while (std::abs(to - at_) > speed * step_s) {
      at_ += (to > at_ ? speed : -speed) * step_s;
      add(3.0 * noise(), false);
    }
    at_ = to;
    if (!move.approach) return;
    level_ = true_straightness_um(plan_, *move.approach);
    const double begin_s = time_s();
    const auto count = static_cast<int>(std::lround(plan_.dwell.in_s() / step_s));
    for (int k = 0; k < count; ++k) add(0.2 * noise(), k >= count / 2 && k < count / 2 + 5);
    stops_.push_back({*move.approach, begin_s, time_s()});
  }

  double time_s() const { return step_s * static_cast<double>(samples_.size()); }
  void add(double error, bool trigger) { samples_.push_back({time_s(), at_, level_ + error, trigger}); }
  /// The same in every run, even between −1 and 1.
  double noise() {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<double>(static_cast<std::int64_t>(state_)) / 9.3e18;
  }

  Plan plan_;
  double at_ = -5.0;
  double level_ = 0.0;
  std::uint64_t state_ = 7;
  std::vector<DrivenSample> samples_;
  std::vector<Stop> stops_;
};

}  // namespace axiometry::testing_support
