// SPDX-License-Identifier: Apache-2.0
#include "axiometry/simulation/motion_walk.h"

#include <algorithm>
#include <utility>

#include "axiometry/numeric/random/random.h"

namespace axiometry::simulation {
namespace {

constexpr std::uint64_t stream_motion_approach = 68, stream_motion_sample = 69;
constexpr double slope_share = 0.6, reversal_share = 0.15, drift_share = 0.5, approach_share = 0.03;
constexpr double sample_share = 0.02, sample_noise_most = 1.0;  // µm or µrad: what rest is recognised under
constexpr double noise_on_the_way = 3.0;                        // times that at rest
constexpr double position_noise_mm = 5e-5;
constexpr double trigger_share = 0.3, trigger_s = 0.1;
constexpr std::size_t block_of_samples = 2048;

Plan without_warm_up(Plan plan) {
  plan.warm_up_runs = 0;
  return plan;
}

}  // namespace

double true_motion(const VirtualMotion& motion, const Plan& plan, double position_mm, Direction direction) {
  const double first = plan.targets.front().in_native(), last = plan.targets.back().in_native();
  const double s = (position_mm - first) / (last - first);
  const double shape = 4.0 * s * (1.0 - s) + slope_share * s;
  return motion.size * (shape + (direction == Direction::down ? reversal_share : 0.0));
}

MotionWalk::MotionWalk(Plan plan, const VirtualMotion& motion, std::uint64_t seed, Timeline timeline)
    : plan_(std::move(plan)), motion_(motion), seed_(seed), timeline_(std::move(timeline)) {
  for (const Leg& leg : timeline_.legs()) {
    rest_of_leg_.push_back(rests_.size());
    if (leg.approach) rests_.push_back({leg.arrive, leg.arrive + plan_.dwell.in_s()});
  }
  scatter_.resize(rests_.size() + 1);  // behind the last, the way back
  numeric::fill_normal({seed_, stream_motion_approach, 0}, scatter_);
  noise_.resize(2 * block_of_samples);
}

Result<MotionWalk> MotionWalk::make(const Plan& plan, const VirtualMotion& motion, std::uint64_t seed) {
  if (plan.targets.size() < 2)
    return fail("found a plan of one target, expected two at least: the simulator spans the error between them");
  Plan walked = without_warm_up(plan);
  AXIOMETRY_TRY(Timeline timeline, Timeline::make(walked, VirtualAxis{}, {}));
  return MotionWalk(std::move(walked), motion, seed, std::move(timeline));
}

void MotionWalk::draw(std::uint64_t sample) {
  const std::uint64_t block = sample / block_of_samples;
  if (block == block_) return;
  numeric::fill_normal({seed_, stream_motion_sample, block}, noise_);
  block_ = block;
}

MotionWalk::Moment MotionWalk::at(double walked_s, std::uint64_t sample) {
  draw(sample);
  const auto legs = timeline_.legs();
  const auto found = std::ranges::lower_bound(legs, walked_s, {}, &Leg::leave);
  const Leg& leg = found == legs.end() ? legs.back() : *found;
  const std::size_t rest = rest_of_leg_[static_cast<std::size_t>(&leg - legs.data())];
  const double z = noise_[2 * (sample % block_of_samples)], along_z = noise_[2 * (sample % block_of_samples) + 1];
  const double t = std::min(walked_s, leg.leave);
  Moment moment;
  moment.position_mm = Timeline::command(leg, Timeline::phase_at(leg, t), t);
  moment.at_rest = leg.approach && t >= leg.arrive;
  const Direction direction = leg.approach        ? leg.approach->direction
                              : leg.towards() < 0 ? Direction::down
                                                  : Direction::up;
  const double noise = std::min(sample_share * motion_.size, sample_noise_most);
  moment.value = true_motion(motion_, plan_, moment.position_mm, direction) +
                 approach_share * motion_.size * scatter_[rest] +
                 (motion_.drifts ? drift_share * motion_.size * t / duration_s() : 0.0) +
                 noise * (moment.at_rest ? 1.0 : noise_on_the_way) * z;
  const double since_trigger = t - leg.arrive - trigger_share * plan_.dwell.in_s();
  moment.trigger = moment.at_rest && since_trigger >= 0.0 && since_trigger < trigger_s;
  moment.position_mm += position_noise_mm * along_z;
  return moment;
}

}  // namespace axiometry::simulation
