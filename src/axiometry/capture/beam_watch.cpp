// SPDX-License-Identifier: Apache-2.0
#include "axiometry/capture/beam_watch.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace axiometry::capture {
namespace {

constexpr std::size_t samples_to_judge = 3;

}  // namespace

bool BeamWatch::jumps(const Sample& from, const Sample& to) const {
  return std::abs(to.position - from.position) > limit_.least_mm + limit_.speed_mm_per_s * (to.time_s - from.time_s);
}

void BeamWatch::push(std::span<const Sample> samples, const Sink& sink) {
  while (!held_.empty() && !samples.empty()) {  // few samples are copied, until they can be judged
    held_.push_back(samples.front());
    samples = samples.subspan(1);
    if (held_.size() < samples_to_judge) continue;
    const std::vector<Sample> judged = std::exchange(held_, {});
    push(judged, sink);
  }
  std::size_t begun = 0;  // first of those not handed on
  for (std::size_t k = 0; k < samples.size(); ++k) {
    if (!sound_ || !jumps(*sound_, samples[k])) {
      sound_ = samples[k];
      continue;
    }
    const auto rest = samples.subspan(k);
    if (rest.size() < samples_to_judge) {
      if (k > begun) sink.samples(samples.subspan(begun, k - begun));
      held_.assign(rest.begin(), rest.end());
      return;
    }
    if (!std::ranges::all_of(rest.first(samples_to_judge), [&](const Sample& s) { return jumps(*sound_, s); }))
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
