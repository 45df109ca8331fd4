// SPDX-License-Identifier: Apache-2.0
#include "axiometry/capture/stop_matcher.h"

#include <algorithm>
#include <cmath>

namespace axiometry::capture {
namespace {

/// What the parts of an explanation cost, about −2 ln of how often they happen: docs/theory/capture-lengths.md.
constexpr double cost_fit = -4.0;      // a change of length within the tolerance: chance does that seldom
constexpr double cost_misfit = 1.0;    // at the tolerance; it grows with the square
constexpr double cost_way = 2.0;       // each end of the way that is not where it should be
constexpr double cost_unseen = 1.5;    // the direction of arrival
constexpr double cost_extra = 2.0;     // a standstill that is no stop
constexpr double cost_repeated = 1.0;  // a second standstill at the stop matched last, without having been away
constexpr double cost_outside = 0.5;   // before the first stop, and behind the last
constexpr double cost_short = 0.2;     // one too short to be a stop; it may be that of a stop in vain
constexpr double cost_short_match = 0.3;
constexpr double cost_missed = 3.0;      // the first of stops left out
constexpr double cost_doubling = 1.0;    // cost each time the number of stops left out doubles
constexpr double cost_told_break = 0.5;  // samples are missing, and the length is as before
constexpr double cost_told_jump = 1.0;   // samples are missing, and the length is another
constexpr double cost_untold_break = 6.0;

constexpr double cost_most = 16.0;  // more than the best: given up
constexpr double coverage = 4.0;    // so many standard uncertainties are allowed for
constexpr std::size_t states_most = 256;
constexpr std::size_t stops_ahead = 16;  // so many stops are tried at least, and as many as the time has room for
constexpr std::size_t links_to_collect = 4096;

double missed_cost(std::size_t missed) {
  return missed == 0 ? 0.0 : cost_missed + cost_doubling * std::log2(static_cast<double>(missed));
}

}  // namespace

StopMatcher::StopMatcher(std::vector<ExpectedStop> stops, const StopMatcherOptions& options)
    : stops_(std::move(stops)),
      options_(options),
      states_(1),
      place_(stops_.size(), none),
      collect_at_(links_to_collect) {
  std::size_t segments = 0;
  for (const ExpectedStop& stop : stops_) {
    distances_.push_back(stop.distance_mm());
    const Vector3 beam = stop.reflector_mm - stop.station_mm;
    beams_.push_back(distances_.back() > 0.0 ? 1.0 / distances_.back() * beam : Vector3{});
    segments += stop.begins_segment ? 1 : 0;
    segments_.push_back(segments);
  }
}

double StopMatcher::length(const Standstill& s) const {
  return options_.reversed ? -s.position.in_native() : s.position.in_native();
}

double StopMatcher::tolerance_mm(std::size_t from, std::size_t to) const {
  const Vector3 turn = beams_[to] - beams_[from];
  const auto& covariance = stops_[to].station_covariance_mm2;
  const double station = covariance ? coverage * std::sqrt(std::max(0.0, quadratic(turn, *covariance, turn)))
                                    : options_.station_error_mm * norm(turn);
  return options_.tolerance_mm + station + options_.scale * std::abs(distances_[to] - distances_[from]);
}

bool StopMatcher::gives_length(const Standstill& rest) const {
  return !rest.frozen_from_s && rest.end_s - rest.begin_s >= options_.shortest.in_s();
}

void StopMatcher::take(const Standstill& standstill) {
  standstills_.push_back(standstill);
  const Standstill& s = standstills_.back();
  const bool no_length = !gives_length(s);
  cost_limit_ = best().cost + cost_most;
  for (State& state : states_) {
    const double low = options_.reversed ? -s.highest.in_native() : s.lowest.in_native();
    const double high = options_.reversed ? -s.lowest.in_native() : s.highest.in_native();
    state.lowest = std::min(state.lowest, low);
    state.highest = std::max(state.highest, high);
    state.broken = state.broken || s.after_gap;
    pass_over(state, s, no_length);
    try_stops(state, s, no_length);
  }
  thin_out();
}

void StopMatcher::pass_over(State state, const Standstill& s, bool no_length) {
  if (no_length) {
    state.cost += cost_short;
  } else if (state.stop == none || state.stop + 1 == stops_.size()) {
    state.cost += cost_outside;
  } else {
    const double way = state.highest - state.lowest;
    const double apart = std::abs(length(s) - length(standstills_[state.standstill]));
    const bool repeated = !state.broken && way < 2.0 * options_.turn_mm && apart < options_.turn_mm;
    state.cost += repeated ? cost_repeated : cost_extra;
    state.strayed = state.strayed || !repeated;
  }
  next_.push_back(state);
  matches_.push_back(std::nullopt);
}

void StopMatcher::try_stops(const State& state, const Standstill& s, bool no_length) {
  const std::size_t first = state.stop == none ? 0 : state.stop + 1;
  double room = states_most;  // a recording may begin late
  if (state.stop != none) {
    const double elapsed_s = s.begin_s - standstills_[state.standstill].end_s;
    room = stops_ahead + std::min<double>(states_most, elapsed_s / options_.shortest.in_s());
  }
  const std::size_t last = std::min(stops_.size(), first + static_cast<std::size_t>(room));
  for (std::size_t stop = first; stop < last; ++stop) {
    const double so_far = state.cost + missed_cost(stop - first) + (no_length ? cost_short_match : 0.0);
    if (so_far > cost_limit_) return;
    const auto taken = step(state, stop, s);
    if (!taken) continue;
    State matched{stop, state.link, standstills_.size() - 1, so_far + taken->cost, length(s), length(s)};
    offer(matched, StopMatch{stop, standstills_.size() - 1, taken->begins_segment, taken->untold, taken->planned});
  }
}

/// What it costs to take the standstill for that stop; nothing when it cannot be that.
std::optional<StopMatcher::Step> StopMatcher::step(const State& state, std::size_t stop, const Standstill& s) const {
  Step result;
  if (s.arrival && stops_[stop].arrival) {
    const Direction arrival = !options_.reversed            ? *s.arrival
                              : *s.arrival == Direction::up ? Direction::down
                                                            : Direction::up;
    if (arrival != *stops_[stop].arrival) {
      if (options_.direction_counts) return std::nullopt;
      result.cost += cost_way;
    }
  } else if (stops_[stop].arrival) {
    result.cost += cost_unseen;
  }
  if (state.stop == none) return result;
  if (segments_[stop] != segments_[state.stop]) {
    result.begins_segment = result.planned = true;
    return result;
  }
  const double shown = length(s) - length(standstills_[state.standstill]);
  const double misfit = (shown - (distances_[stop] - distances_[state.stop])) / tolerance_mm(state.stop, stop);
  const bool fits = std::abs(misfit) <= 1.0;
  if (fits) result.cost += cost_fit + cost_misfit * misfit * misfit;
  if (state.broken) {
    result.cost += fits ? cost_told_break : cost_told_jump;
    result.begins_segment = true;
  } else if (fits) {
    result.cost += state.strayed ? 0.0 : way_cost(state, stop, s);
  } else {
    result.cost += cost_untold_break;
    result.begins_segment = result.untold = true;
  }
  return result;
}

/// Whether the reflector has been where it had to be on the way, and nowhere else.
double StopMatcher::way_cost(const State& state, std::size_t stop, const Standstill& s) const {
  double lowest = distances_[stop], highest = lowest;
  for (std::size_t k = state.stop + 1; k <= stop; ++k) {
    lowest = std::min(lowest, stops_[k].lowest_mm);
    highest = std::max(highest, stops_[k].highest_mm);
  }
  const double offset = length(s) - distances_[stop];
  const double most = tolerance_mm(state.stop, stop) + 2.0 * options_.turn_mm;
  return (std::abs(state.lowest - offset - lowest) > most ? cost_way : 0.0) +
         (std::abs(state.highest - offset - highest) > most ? cost_way : 0.0);
}

/// One explanation for each stop that this standstill may be; of two that cost the same the older one.
void StopMatcher::offer(State state, StopMatch match) {
  std::size_t& place = place_[state.stop];
  if (place == none) {
    place = next_.size();
    next_.push_back(state);
    matches_.push_back(match);
  } else if (state.cost < next_[place].cost) {
    next_[place] = state;
    matches_[place] = match;
  }
}

/// Keeps the best, strictly: what costs as much as the first that has no room goes too.
void StopMatcher::thin_out() {
  const double least = std::ranges::min_element(next_, {}, &State::cost)->cost;
  double limit = least + cost_most;
  if (next_.size() > states_most) {
    std::vector<double> costs;
    for (const State& state : next_) costs.push_back(state.cost);
    std::ranges::nth_element(costs, costs.begin() + states_most);
    limit = std::min(limit, costs[states_most]);
  }
  states_.clear();
  for (std::size_t k = 0; k < next_.size(); ++k) {
    State& state = next_[k];
    if (matches_[k]) place_[state.stop] = none;
    if (state.cost >= limit && (state.cost > least || !states_.empty())) continue;
    if (matches_[k]) {
      links_.push_back({state.link, *matches_[k], state.link == none ? 1 : links_[state.link].depth + 1});
      state.link = links_.size() - 1;
    }
    states_.push_back(state);
  }
  next_.clear();
  matches_.clear();
  if (links_.size() > collect_at_) collect();
}

/// Forgets links that no explanation rests on any more.
void StopMatcher::collect() {
  std::vector<std::size_t> moved(links_.size(), none);
  for (const State& state : states_)
    for (std::size_t link = state.link; link != none && moved[link] == none; link = links_[link].before)
      moved[link] = 0;
  std::size_t count = 0;
  for (std::size_t k = 0; k < links_.size(); ++k) {
    if (moved[k] == none) continue;
    moved[k] = count;
    links_[count] = links_[k];
    if (links_[count].before != none) links_[count].before = moved[links_[count].before];
    ++count;
  }
  links_.resize(count);
  collect_at_ = 2 * count + links_to_collect;
  for (State& state : states_)
    if (state.link != none) state.link = moved[state.link];
}

const StopMatcher::State& StopMatcher::best() const { return *std::ranges::min_element(states_, {}, &State::cost); }

std::size_t StopMatcher::matched() const {
  const std::size_t link = best().link;
  return link == none ? 0 : links_[link].depth;
}

std::optional<std::size_t> StopMatcher::due() const {
  const std::size_t next = best().stop == none ? 0 : best().stop + 1;
  return next < stops_.size() ? std::optional(next) : std::nullopt;
}

std::vector<StopMatch> StopMatcher::matches() const {
  std::vector<StopMatch> list;
  for (std::size_t link = best().link; link != none; link = links_[link].before) list.push_back(links_[link].match);
  std::ranges::reverse(list);
  return list;
}

}  // namespace axiometry::capture
