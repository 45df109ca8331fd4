// SPDX-License-Identifier: Apache-2.0
#include "axiometry/capture/standstill.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "axiometry/numeric/median.h"

namespace axiometry::capture {
namespace {

constexpr std::size_t cells_per_window = 4;
constexpr std::size_t fewest_samples = 4;  // of a cell
constexpr std::size_t noise_memory = 5;
constexpr std::size_t steps_looked_at = 64;
constexpr double noise_factor = 6.0;
constexpr double quantum_factor = 1.5;
constexpr double gap_steps = 10.0;
constexpr double feed_share = 0.02;
constexpr double unlimited = std::numeric_limits<double>::max();
constexpr double rotary_smallest = 1.0 / 3600.0, linear_smallest = 0.001;

}  // namespace

StandstillOptions standstill_options(const Plan& plan) {
  const double dwell_s = plan.dwell.in_s();
  const double window_s = dwell_s > 0.0 ? std::clamp(dwell_s / 4, 0.1, 1.0) : 0.25;
  const double smallest = plan.axis.kind == AxisKind::linear ? linear_smallest : rotary_smallest;
  return {.window = Duration::s(window_s),
          .settling = Duration::s(window_s),
          .shortest = Duration::s(std::max(dwell_s / 2, 2 * window_s)),
          .smallest = Position::native(smallest),
          .greatest = Position::native(feed_share * plan.feed / 60.0 * window_s),
          .threshold = {},
          .turn = Position::native(plan.overrun.in_native() / 4)};
}

StandstillDetector::StandstillDetector(const StandstillOptions& options)
    : options_(options), travel_(options.turn.in_native()) {}

void StandstillDetector::Average::add(const Cell& cell, double origin_s, double origin) {
  const auto n = static_cast<double>(cell.count);
  const double d = cell.mean - origin;
  const double inside = cell.standard_deviation * cell.standard_deviation * (n - 1.0);
  squares += inside + (d - mean) * (d - mean) * count * n / (count + n);
  mean += (d - mean) * n / (count + n);
  if (count == 0.0) from_s = cell.begin_s;
  to_s = cell.end_s;
  count += n;
  const double time = cell.mean_time_s - origin_s;
  weight += n;
  t += n * time;
  x += n * d;
  tt += n * time * time;
  tx += n * time * d;
  rejected += cell.rejected;
}

double StandstillDetector::Average::slope() const {
  const double spread = weight * tt - t * t;
  return spread > 0.0 ? (weight * tx - t * x) / spread : 0.0;
}

/// A cell ends before the first sample from here on, when it has samples enough.
double StandstillDetector::cell_edge_s(const Sample& first) const {
  return first.time_s + options_.window.in_s() / cells_per_window;
}

std::vector<Standstill> StandstillDetector::push(std::span<const Sample> samples) {
  std::vector<Standstill> found;
  while (!samples.empty()) {
    const std::size_t before = begun_.size();
    const double edge_s = cell_edge_s(before > 0 ? begun_.front() : samples.front());
    const auto edge = std::ranges::lower_bound(samples, edge_s, {}, &Sample::time_s);
    const std::size_t least = fewest_samples - std::min(before, fewest_samples);
    const std::size_t end = std::max(static_cast<std::size_t>(edge - samples.begin()), least);
    const bool whole = end < samples.size();
    const auto part = samples.first(std::min(end, samples.size()));
    if (whole && before == 0) {
      take(part, found);
    } else {  // a cell that goes on over the end of a piece is put together
      begun_.insert(begun_.end(), part.begin(), part.end());
      if (whole) take(std::exchange(begun_, {}), found);
    }
    samples = samples.subspan(part.size());
  }
  return found;
}

std::vector<Standstill> StandstillDetector::interrupt() {
  std::vector<Standstill> found;
  const std::vector<Sample> rest = std::exchange(begun_, {});
  const bool enough = rest.size() >= fewest_samples &&
                      rest.back().time_s - rest.front().time_s > options_.window.in_s() / cells_per_window / 2;
  if (enough) take(rest, found);
  gap(found);
  return found;
}

std::optional<StandstillDetector::Now> StandstillDetector::now() const {
  if (!now_) return std::nullopt;
  return Now{Position::native(now_->mean), at_rest_};
}

/// The samples of one cell, perhaps with gaps before and within it.
void StandstillDetector::take(std::span<const Sample> samples, std::vector<Standstill>& found) {
  const double longest_s =
      usual_step_s_ > 0.0 ? std::max(options_.window.in_s(), gap_steps * usual_step_s_) : unlimited;
  if (last_ && samples.front().time_s - last_->time_s > longest_s) gap(found);
  const CellSums sums = sums_of(samples);
  std::size_t end = samples.size();
  if (sums.longest_step_s > longest_s)
    for (end = 1; samples[end].time_s - samples[end - 1].time_s <= longest_s;) ++end;
  const auto before_gap = samples.first(end);
  last_ = before_gap.back();
  if (end >= fewest_samples) take_cell(before_gap, end == samples.size() ? sums : sums_of(before_gap), found);
  if (end < samples.size()) take(samples.subspan(end), found);
}

void StandstillDetector::take_cell(std::span<const Sample> samples, const CellSums& sums,
                                   std::vector<Standstill>& found) {
  const double noise = noises_.size() < noise_memory ? 0.0 : numeric::median({noises_.begin(), noises_.end()});
  const double floor = std::max(quantum_, 0.5 * options_.smallest.in_native());
  const Cell cell = maker_.make(samples, sums, noise, floor);
  learn(samples, cell);
  travel(samples, cell);
  window_.push_back(cell);
  if (window_.size() > cells_per_window) window_.pop_front();
  now_ = cell;
  const double limit = threshold();
  const bool rests = settled(limit);
  if (at_rest_ && !rests) found.push_back(end_rest(false));
  if (at_rest_) add_to_rest(cell);
  if (!at_rest_ && rests) begin_rest(limit);
}

void StandstillDetector::learn(std::span<const Sample> samples, const Cell& cell) {
  noises_.push_back(cell.scale);
  if (noises_.size() > noise_memory) noises_.pop_front();
  usual_step_s_ = (cell.end_s - cell.begin_s) / static_cast<double>(samples.size() - 1);
  for (std::size_t k = 1; k < std::min(samples.size(), steps_looked_at); ++k) {
    const double step = std::abs(samples[k].position - samples[k - 1].position);
    if (step > 0.0 && (quantum_ == 0.0 || step < quantum_)) quantum_ = step;
  }
}

void StandstillDetector::travel(std::span<const Sample> samples, const Cell& cell) {
  if (cell.highest - cell.lowest > options_.turn.in_native() / 8)
    travel_.move_along(samples);
  else
    travel_.move_to(cell.mean);
}

void StandstillDetector::gap(std::vector<Standstill>& found) {
  if (at_rest_) found.push_back(end_rest(true));
  window_.clear();
  travel_.forget();
  gap_behind_ = true;
}

double StandstillDetector::threshold() const {
  if (options_.threshold) return options_.threshold->in_native();
  std::vector<double> noises;
  for (const Cell& c : window_) noises.push_back(c.standard_deviation);
  const double adaptive = std::max(
      {options_.smallest.in_native(), quantum_factor * quantum_, noise_factor * numeric::median(std::move(noises))});
  return std::min(options_.greatest.in_native(), adaptive);
}

bool StandstillDetector::settled(double threshold) const {
  if (window_.size() < cells_per_window) return false;
  const auto [lowest, highest] = std::ranges::minmax_element(window_, {}, &Cell::mean);
  return highest->mean - lowest->mean <= threshold;
}

void StandstillDetector::begin_rest(double threshold) {
  origin_ = window_.front().mean;
  rest_ = {.begin_s = window_.front().begin_s,
           .threshold = Position::native(threshold),
           .arrival = travel_.direction(),
           .lowest = Position::native(travel_.lowest()),
           .highest = Position::native(travel_.highest()),
           .after_gap = std::exchange(gap_behind_, false)};
  travel_.begin_stretch(window_.back().mean);
  settling_ = used_ = {};
  held_.reset();
  at_rest_ = true;
  for (const Cell& c : window_) add_to_rest(c);
}

void StandstillDetector::add_to_rest(const Cell& cell) {
  rest_.end_s = cell.end_s;
  if (cell.begin_s < rest_.begin_s + options_.settling.in_s()) {
    settling_.add(cell, rest_.begin_s, origin_);
    return;
  }
  if (held_) used_.add(*held_, rest_.begin_s, origin_);
  held_ = cell;
}

Standstill StandstillDetector::end_rest(bool cut_off) {
  at_rest_ = false;
  if (held_ && (cut_off || used_.count == 0.0)) used_.add(*held_, rest_.begin_s, origin_);
  const Average& average = used_.count > 0.0 ? used_ : settling_;
  Standstill standstill = rest_;
  standstill.used_from_s = average.from_s;
  standstill.used_to_s = average.to_s;
  standstill.count = static_cast<std::size_t>(average.count);
  standstill.rejected = average.rejected;
  standstill.position = Position::native(origin_ + average.mean);
  standstill.spread = Position::native(average.count > 1.0 ? std::sqrt(average.squares / (average.count - 1.0)) : 0.0);
  standstill.drift = Position::native(average.slope() * (average.to_s - average.from_s));
  standstill.cut_off = cut_off;
  return standstill;
}

}  // namespace axiometry::capture
