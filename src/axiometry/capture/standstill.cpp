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
constexpr std::size_t fewest_samples = 4;  // least samples of a cell
constexpr std::size_t noise_memory = 5;
constexpr std::size_t steps_looked_at = 64;
constexpr double gap_steps = 10.0;
constexpr double feed_share = 0.02;
constexpr double slowest_limit_per_s = 500.0;
constexpr double feeds_of_limit = 10.0;
constexpr double jump_least = 0.5;            // mm or °
constexpr std::size_t samples_of_a_jump = 3;  // two false ones in a row are no jump
constexpr double hold_slack = 2.0;            // the first way may hide in the last digit
constexpr double sharpest_start = 30'000.0;   // mm/s² or °/s²: 3 g
constexpr double rounding_of_numbers = 1e-9;  // mm or °: below, two differences are alike
constexpr double unlimited = std::numeric_limits<double>::max();
constexpr double rotary_smallest = 1.0 / 3600.0, linear_smallest = 0.001;

}  // namespace

double fastest_motion(double feed) { return std::max(slowest_limit_per_s, feeds_of_limit * feed / 60.0); }

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
          .turn = Position::native(plan.overrun.in_native() / 4),
          .fastest_per_s = fastest_motion(plan.feed)};
}

Standstill shifted(Standstill s, double by) {
  for (Position* x : {&s.position, &s.lowest, &s.highest}) *x = Position::native(x->in_native() + by);
  for (Position& x : s.turns) x = Position::native(x.in_native() + by);
  return s;
}

StandstillDetector::StandstillDetector(const StandstillOptions& options)
    : options_(options), travel_(options.turn.in_native()) {}

void StandstillDetector::Average::add(const SampleCell& cell, double origin_s, double origin) {
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
  scatter.add(d);
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
    samples = samples.subspan(part.size());
    if (whole && before == 0) {
      const auto left = part.subspan(take(part, true, found));
      begun_.assign(left.begin(), left.end());
      continue;
    }
    begun_.insert(begun_.end(), part.begin(), part.end());  // a cell that goes on over the end of a piece
    if (!whole) continue;
    const std::vector<Sample> cell = std::exchange(begun_, {});
    begun_.assign(cell.begin() + static_cast<std::ptrdiff_t>(take(cell, true, found)), cell.end());
  }
  return found;
}

std::vector<Standstill> StandstillDetector::interrupt() {
  std::vector<Standstill> found;
  take_begun(found);
  gap(found);
  if (last_) missing_from_s_ = last_->time_s;
  return found;
}

std::vector<Standstill> StandstillDetector::jumped() {
  std::vector<Standstill> found;
  take_begun(found);
  frozen_long() ? end_frozen(found) : gap(found);
  return found;
}

void StandstillDetector::take_begun(std::vector<Standstill>& found) {
  const std::vector<Sample> rest = std::exchange(begun_, {});
  const bool enough = rest.size() >= fewest_samples &&
                      rest.back().time_s - rest.front().time_s > options_.window.in_s() / cells_per_window / 2;
  if (enough) take(rest, false, found);
}

std::optional<StandstillDetector::Whereabouts> StandstillDetector::now() const {
  if (!now_) return std::nullopt;
  return Whereabouts{Position::native(now_->mean), at_rest_};
}

/// The samples of one cell, perhaps with gaps before and within it. How many were taken: of what may be a jump the rest
/// waits for more, where more come.
std::size_t StandstillDetector::take(std::span<const Sample> samples, bool more_come, std::vector<Standstill>& found) {
  const double longest_s =
      usual_step_s_ > 0.0 ? std::max(options_.window.in_s(), gap_steps * usual_step_s_) : unlimited;
  if (last_ && samples.front().time_s - last_->time_s > longest_s) {
    gap(found);
    missing_from_s_ = last_->time_s;
  }
  const CellSums sums = sums_of(samples);
  std::size_t end = samples.size();
  if (sums.longest_step_s > longest_s)
    for (end = 1; samples[end].time_s - samples[end - 1].time_s <= longest_s;) ++end;
  if (end == samples.size()) return take_piece(samples, sums, more_come, found);
  const auto before_gap = samples.first(end);
  take_piece(before_gap, sums_of(before_gap), false, found);
  return end + take(samples.subspan(end), more_come, found);
}

/// Samples without a gap in time between them.
std::size_t StandstillDetector::take_piece(std::span<const Sample> samples, const CellSums& sums, bool more_come,
                                           std::vector<Standstill>& found) {
  const auto leap = leap_at(samples);
  const auto behind = samples.subspan(leap.value_or(samples.size()));
  const auto still = samples.first(samples.size() - behind.size());
  const bool too_few = behind.size() < samples_of_a_jump && more_come && !still.empty();
  if (leap && (too_few || stays_away(behind))) {
    if (!still.empty()) take_piece(still, sums_of(still), false, found);
    if (too_few) return still.size();
    end_frozen(found);
    return still.size() + take_piece(behind, sums_of(behind), more_come, found);
  }
  if (missing_from_s_) missing_.push_back({*std::exchange(missing_from_s_, {}), samples.front().time_s});
  watch_value(samples, sums);
  last_ = samples.back();
  if (samples.size() >= fewest_samples) take_cell(samples, sums, found);
  return samples.size();
}

/// How long it usually is one value on the way must have been seen: an instrument may be asked more often than it
/// measures.
bool StandstillDetector::frozen_long() const {
  return frozen_ && usual_hold_s_ > 0.0 &&
         frozen_->to_s - frozen_->from_s > std::max(options_.window.in_s(), gap_steps * usual_hold_s_);
}

/// Farther from a value that stood still than anything starts from rest within that time. Samples of one time came in
/// one burst.
bool StandstillDetector::is_away(const Sample& sample, double step_s) const {
  const double time_s = std::max({step_s, usual_step_s_, hold_slack * usual_hold_s_});
  const double reach = std::min(options_.fastest_per_s * time_s, 0.5 * sharpest_start * time_s * time_s);
  return std::abs(sample.position - frozen_->position) > jump_least + reach;
}

/// A false sample or two do not.
bool StandstillDetector::stays_away(std::span<const Sample> behind) const {
  return std::ranges::all_of(behind.first(std::min(behind.size(), samples_of_a_jump)),
                             [&](const Sample& s) { return is_away(s, 0.0); });
}

/// The first sample that is away from a value that had stood still for long.
std::optional<std::size_t> StandstillDetector::leap_at(std::span<const Sample> samples) const {
  if (!frozen_long()) return std::nullopt;
  const auto first = std::ranges::find_if(samples, [&](const Sample& s) { return s.position != frozen_->position; });
  if (first == samples.end()) return std::nullopt;
  const double before_s = first == samples.begin() ? last_->time_s : std::prev(first)->time_s;
  if (!is_away(*first, first->time_s - before_s)) return std::nullopt;
  return static_cast<std::size_t>(first - samples.begin());
}

/// What goes on as it was has been the same value, false samples aside.
void StandstillDetector::watch_value(std::span<const Sample> samples, const CellSums& sums) {
  const bool goes_on = frozen_ && leap_at(samples) && samples.back().position == frozen_->position;
  if (sums.lowest != sums.highest && !goes_on)
    frozen_.reset();
  else if (!goes_on && (!frozen_ || frozen_->position != samples.front().position))
    frozen_ = {samples.front().position, samples.front().time_s, samples.back().time_s};
  else
    frozen_->to_s = samples.back().time_s;
}

void StandstillDetector::take_cell(std::span<const Sample> samples, const CellSums& sums,
                                   std::vector<Standstill>& found) {
  const double noise = noises_.size() < noise_memory ? 0.0 : numeric::median({noises_.begin(), noises_.end()});
  const double floor = std::max(quantum_, 0.5 * options_.smallest.in_native());
  const SampleCell cell = maker_.make(samples, sums, noise, floor);
  note_usual(samples, cell);
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

void StandstillDetector::note_usual(std::span<const Sample> samples, const SampleCell& cell) {
  noises_.push_back(cell.scale);
  if (noises_.size() > noise_memory) noises_.pop_front();
  usual_step_s_ = (cell.end_s - cell.begin_s) / static_cast<double>(samples.size() - 1);
  const std::size_t looked_at = std::min(samples.size(), steps_looked_at);
  double changes = 0.0, step_before = 0.0;
  const auto note_finest = [&](double difference) {
    if (difference > rounding_of_numbers && (finest_ <= 0.0 || difference < finest_)) finest_ = difference;
  };
  for (std::size_t k = 1; k < looked_at; ++k) {
    const double step = std::abs(samples[k].position - samples[k - 1].position);
    if (step > 0.0) changes += 1.0;
    if (step > 0.0 && (quantum_ == 0.0 || step < quantum_)) quantum_ = step;
    note_finest(step);
    note_finest(std::abs(step - std::exchange(step_before, step)));
  }
  if (changes == 0.0) return;
  const double hold_s = (samples[looked_at - 1].time_s - samples.front().time_s) / changes;
  usual_hold_s_ = usual_hold_s_ > 0.0 ? std::min(usual_hold_s_, hold_s) : hold_s;
}

void StandstillDetector::travel(std::span<const Sample> samples, const SampleCell& cell) {
  const bool moves = cell.highest - cell.lowest > options_.turn.in_native() / 8;
  const auto before = travel_.direction();
  if (moves || !at_rest_) way_.move_along(samples);
  moves ? travel_.move_along(samples) : travel_.move_to(cell.mean);
  if (before != travel_.direction()) way_.turned(*travel_.direction());
}

void StandstillDetector::gap(std::vector<Standstill>& found) {
  if (at_rest_) found.push_back(end_rest(true));
  window_.clear();
  travel_.forget();
  way_.forget();
  gap_behind_ = true;
  frozen_.reset();
}

/// The signal, as it seems: a gap that was filled with the last value.
void StandstillDetector::end_frozen(std::vector<Standstill>& found) {
  rest_.frozen_from_s = frozen_->from_s;
  gap(found);
}

double StandstillDetector::threshold() const {
  if (options_.threshold) return options_.threshold->in_native();
  std::vector<double> noises;
  for (const SampleCell& c : window_) noises.push_back(c.standard_deviation);
  return rest_threshold(quantum_, std::move(noises), {options_.smallest.in_native(), options_.greatest.in_native()});
}

bool StandstillDetector::settled(double threshold) const {
  if (window_.size() < cells_per_window) return false;
  const auto [lowest, highest] = std::ranges::minmax_element(window_, {}, &SampleCell::mean);
  return highest->mean - lowest->mean <= threshold;
}

void StandstillDetector::begin_rest(double threshold) {
  origin_ = window_.front().mean;
  rest_ = {.begin_s = window_.front().begin_s,
           .threshold = Position::native(threshold),
           .arrival = travel_.direction(),
           .lowest = Position::native(travel_.lowest()),
           .highest = Position::native(travel_.highest()),
           .edge_s = options_.window.in_s() / cells_per_window,
           .missing = std::exchange(missing_, {}),
           .after_gap = std::exchange(gap_behind_, false)};
  if (rest_.arrival) rest_.speed = way_.speed(*rest_.arrival, origin_);
  for (const double turn : travel_.take_turns()) rest_.turns.push_back(Position::native(turn));
  rest_.beyond = Position::native(travel_.beyond(window_.back().mean));
  travel_.begin_stretch(window_.back().mean);
  way_.forget();
  settling_ = used_ = {};
  held_.reset();
  at_rest_ = true;
  for (const SampleCell& c : window_) add_to_rest(c);
}

void StandstillDetector::add_to_rest(const SampleCell& cell) {
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
  standstill.scatter = average.scatter.without_drift(average.slope(), average.to_s - average.from_s);
  standstill.step = Position::native(finest_);
  standstill.cut_off = cut_off;
  return standstill;
}

}  // namespace axiometry::capture
