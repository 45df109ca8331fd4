// SPDX-License-Identifier: Apache-2.0
#include "axiometry/capture/way_speed.h"

#include <algorithm>
#include <cmath>

namespace axiometry::capture {
namespace {

constexpr std::size_t places_of_a_cell = 8;
constexpr std::size_t most_places = 512;
constexpr double fewest_steps = 3.0;    // steps in time within the middle quarter
constexpr double even_to = 0.02;        // a speed that is the same within that is even
constexpr double steps_share = 0.1;     // of a step in time, between which places are interpolated
constexpr double most_uneven = 0.1;     // whatever the steps in time
constexpr double slowest_start = 20.0;  // mm/s² or °/s²: no axis that is still to become faster is slower
constexpr double half_a_quarter = 0.125, half_a_half = 0.25;

double middle_one(double a, double b, double c) { return std::max(std::min(a, b), std::min(std::max(a, b), c)); }

}  // namespace

/// The middle one of three neighbours, so that a false sample is no place.
void WaySpeed::move_along(std::span<const Sample> samples) {
  const std::size_t every = stride_ * ((samples.size() + places_of_a_cell - 1) / places_of_a_cell);
  for (const Sample& sample : samples) {
    if (before_.size() == 2 && passed_++ % every == 0)
      places_.push_back({before_[1].time_s, middle_one(before_[0].position, before_[1].position, sample.position)});
    if (before_.size() == 2) before_.erase(before_.begin());
    before_.push_back(sample);
  }
  if (places_.size() < most_places) return;
  for (std::size_t k = 0; 2 * k < places_.size(); ++k) places_[k] = places_[2 * k];
  places_.resize((places_.size() + 1) / 2);
  stride_ *= 2;
}

/// The last place that lies farthest against the direction.
std::size_t WaySpeed::farthest_behind(Direction direction) const {
  std::size_t farthest = 0;
  for (std::size_t k = 1; k < places_.size(); ++k) {
    const double ahead = places_[k].position - places_[farthest].position;
    if (direction == Direction::up ? ahead <= 0.0 : ahead >= 0.0) farthest = k;
  }
  return farthest;
}

void WaySpeed::turned(Direction now) {
  if (places_.empty()) return;
  places_.erase(places_.begin(), places_.begin() + static_cast<std::ptrdiff_t>(farthest_behind(now)));
  stride_ = 1;
}

void WaySpeed::forget() {
  places_.clear();
  before_.clear();
  stride_ = 1;
}

std::optional<Speed> WaySpeed::speed(Direction direction, double to) const {
  if (places_.empty()) return std::nullopt;
  const auto way = std::span(places_).subspan(farthest_behind(direction));
  const double from = way.front().position, length = std::abs(to - from);
  double longest_step_s = 0.0;
  /// The time at which that share of the way was behind the axis.
  const auto time_at = [&](double share) -> std::optional<double> {
    for (std::size_t k = 1; k < way.size(); ++k) {
      const double before = std::abs(way[k - 1].position - from), now = std::abs(way[k].position - from);
      if (now < share * length || !(now > before)) continue;
      const double step_s = way[k].time_s - way[k - 1].time_s;
      longest_step_s = std::max(longest_step_s, step_s);
      return way[k - 1].time_s + step_s * std::max(0.0, share * length - before) / (now - before);
    }
    return std::nullopt;
  };
  const auto quarter_begin = time_at(0.5 - half_a_quarter), quarter_end = time_at(0.5 + half_a_quarter);
  const auto half_begin = time_at(0.5 - half_a_half), half_end = time_at(0.5 + half_a_half);
  if (!quarter_begin || !quarter_end || !half_begin || !half_end) return std::nullopt;
  const double quarter_s = *quarter_end - *quarter_begin, half_s = *half_end - *half_begin;
  if (!(quarter_s > 0.0 && quarter_s >= fewest_steps * longest_step_s)) return std::nullopt;
  const double known_to = longest_step_s / quarter_s;
  const double ratio = half_s / (2.0 * quarter_s);
  const double per_s = 2.0 * half_a_quarter * length / quarter_s;
  const bool even = std::abs(ratio - 1.0) <= std::min(most_uneven, even_to + steps_share * known_to);
  return Speed{per_s, known_to, even || per_s * per_s < slowest_start * length};
}

}  // namespace axiometry::capture
