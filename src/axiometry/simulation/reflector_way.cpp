// SPDX-License-Identifier: Apache-2.0
#include "axiometry/simulation/reflector_way.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axiometry/numeric/random/random.h"

namespace axiometry::simulation {
namespace {

constexpr double way_samples_most = 1e10;
constexpr std::size_t strip_of_samples = 4096;  // a multiple of RandomStream::group

}  // namespace

void ReflectorWay::go(Vector3 to, double feed_mm_per_min, double dwell_s) {
  const Vector3 way = legs_.empty() ? Vector3{} : to - legs_.back().to;
  carry(to, std::sqrt(dot(way, way)) / feed_mm_per_min * 60.0, dwell_s);
  legs_.back().lost_to = 0.0;
}

void ReflectorWay::carry(Vector3 to, double seconds, double dwell_s) {
  ReflectorLeg leg{.from = to, .to = to};
  if (legs_.empty()) {
    leg.leave_s = rest_s + dwell_s;
  } else {
    leg.from = legs_.back().to;
    leg.begin_s = legs_.back().leave_s;
    leg.arrive_s = leg.begin_s + seconds;
    leg.leave_s = leg.arrive_s + dwell_s;
    leg.lost_to = 1.0;
  }
  legs_.push_back(leg);
}

Result<ReflectorWay::Count> ReflectorWay::count(double rate) const {
  if (!(rate >= 0.001 && rate <= 1e7))
    return fail(fmt::format("found a rate of {} samples a second, expected 0.001 to 10000000", rate));
  const double total = std::floor(duration_s() * rate) + 1.0;
  if (total > way_samples_most)
    return fail(fmt::format("found a recording of {:.3g} samples, expected at most {:.3g}", total, way_samples_most));
  Count count;
  std::size_t leg = 0;
  for (std::size_t k = 0; k < static_cast<std::size_t>(total); ++k) {
    const double t = static_cast<double>(k) / rate;
    while (t > legs_[leg].leave_s && leg + 1 < legs_.size()) ++leg;
    ++(legs_[leg].is_lost(t) ? count.lost : count.arrived);
  }
  return count;
}

Result<void> ReflectorWay::record(double rate, std::uint64_t seed, std::uint64_t stream, const Shown& shown,
                                  const SampleSink& sink) const {
  AXIOMETRY_TRY(const Count count, this->count(rate));
  const std::size_t total = count.arrived + count.lost;
  numeric::RandomStream numbers({seed, stream, 0});
  std::vector<double> noise(strip_of_samples);
  std::vector<Sample> samples(strip_of_samples);
  std::size_t leg = 0;
  for (std::size_t first = 0; first < total; first += strip_of_samples) {
    numbers.fill_normal(noise);
    std::size_t arrived = 0;
    for (std::size_t k = 0; k < std::min(strip_of_samples, total - first); ++k) {
      const double t = static_cast<double>(first + k) / rate;
      while (t > legs_[leg].leave_s && leg + 1 < legs_.size()) ++leg;
      const ReflectorLeg& now = legs_[leg];
      if (now.is_lost(t)) continue;
      const double share = now.way_s() > 0.0 ? std::clamp((t - now.begin_s) / now.way_s(), 0.0, 1.0) : 1.0;
      const Vector3 at = now.from + share * share * (3.0 - 2.0 * share) * (now.to - now.from);
      samples[arrived++] = {t, shown(leg, share, at, noise[k])};
    }
    if (arrived > 0) AXIOMETRY_TRY_VOID(sink(std::span<const Sample>(samples).first(arrived)));
  }
  return {};
}

}  // namespace axiometry::simulation
