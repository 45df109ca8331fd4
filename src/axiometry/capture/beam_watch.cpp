// SPDX-License-Identifier: Apache-2.0
#include "axiometry/capture/beam_watch.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace axiometry::capture {
namespace {

constexpr std::size_t samples_to_confirm = 3;
constexpr double missing_steps = 10.0;
constexpr double missing_least_s = 0.1;
constexpr double believed_share = 0.2;
constexpr double forgotten_s = 1.0;  // in which a long step falls to 1/e

}  // namespace

/// Samples of one time came in one burst: they lie anywhere within the longest step.
bool BeamWatch::jumps(const Sample& from, const Sample& to) const {
  const double apart_s = to.time_s > from.time_s ? to.time_s - from.time_s : longest_step_s_;
  return std::abs(to.position - from.position) > limit_.least_mm + limit_.speed_mm_per_s * apart_s;
}

/// Of a step that is too long only a part is believed to be usual, so that samples that come rarely are met soon.
void BeamWatch::take_sound(const Sample& sample, const Sink& sink) {
  if (sound_) {
    const double step_s = sample.time_s - sound_->time_s;
    const bool too_long = step_s > std::max(missing_least_s, missing_steps * longest_step_s_);
    if (too_long && std::abs(sample.position - sound_->position) > limit_.resting_mm) sink.missing(sample.time_s);
    longest_step_s_ =
        std::max(too_long ? believed_share * step_s : step_s, longest_step_s_ / (1.0 + step_s / forgotten_s));
  }
  sound_ = sample;
}

void BeamWatch::push(std::span<const Sample> samples, const Sink& sink) {
  while (!held_.empty() && !samples.empty()) {  // few samples are copied, until they can be judged
    held_.push_back(samples.front());
    samples = samples.subspan(1);
    if (held_.size() < samples_to_confirm) continue;
    const std::vector<Sample> judged = std::exchange(held_, {});
    push(judged, sink);
  }
  std::size_t begun = 0;  // first of those not handed on
  for (std::size_t k = 0; k < samples.size(); ++k) {
    if (!sound_ || !jumps(*sound_, samples[k])) {
      take_sound(samples[k], sink);
      continue;
    }
    const auto rest = samples.subspan(k);
    if (rest.size() < samples_to_confirm) {
      if (k > begun) sink.samples(samples.subspan(begun, k - begun));
      held_.assign(rest.begin(), rest.end());
      return;
    }
    if (!std::ranges::all_of(rest.first(samples_to_confirm), [&](const Sample& s) { return jumps(*sound_, s); }))
      continue;  // a false sample; it goes on, and the detector leaves it out
    if (k > begun) sink.samples(samples.subspan(begun, k - begun));
    sink.broken(samples[k].time_s);
    begun = k;
    sound_ = samples[k];
  }
  if (samples.size() > begun) sink.samples(samples.subspan(begun));
}

void BeamWatch::interrupt(const Sink& sink) {
  if (!held_.empty()) sink.samples(std::exchange(held_, {}));
  sound_.reset();
}

}  // namespace axiometry::capture
