// SPDX-License-Identifier: Apache-2.0
#include "axiometry/capture/stop_lengths.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/unit_sizes.h"
#include "axiometry/capture/station_refining.h"

namespace axiometry::capture {
namespace {

constexpr double same_place_mm = 1e-6;
constexpr double resting_share = 0.5;    // of the standstills that must belong to stops
constexpr double displaced_share = 0.3;  // of the stops heard: rests that are none, and as many stops without one
constexpr double much_cheaper = 12.0;    // three changes of length that fit
constexpr double jump_share = 0.2;       // of the changes of length that may be none of the list
constexpr std::size_t jumps_always = 3;

StandstillOptions rest_of(const StopOptions& options) {
  return options.rest ? *options.rest : standstill_options(options.drive);
}

StopMatcherOptions matcher_of(const StopOptions& options) {
  StopMatcherOptions matcher = options.matcher;
  matcher.turn_mm = options.drive.turn_mm;
  matcher.shortest = rest_of(options).shortest;
  return matcher;
}

/// From matches to what every stop has.
class Outcome {
 public:
  explicit Outcome(const StopMatcher& matcher) : matcher_(matcher), matches_(matcher.matches()) {}

  StopLengths run() {
    lengths_.stops.resize(stops().size());
    for (const Standstill& s : matcher_.standstills()) lengths_.standstills += matcher_.gives_length(s) ? 1 : 0;
    find_ambiguous();
    std::size_t segment = 0;
    for (std::size_t k = 0; k < matches_.size(); ++k) {
      const StopMatch& m = matches_[k];
      if (m.begins_segment)
        lengths_.segments.push_back({++segment, m.stop, standstill(m).begin_s, m.untold, m.planned});
      StopOutcome& outcome = lengths_.stops[m.stop];
      if (standstill(m).frozen_from_s)
        outcome.lack = StopLack::signal_lost;
      else if (!matcher_.gives_length(standstill(m)))
        outcome.lack = StopLack::too_short;
      else if (ambiguous_[k])
        outcome.lack = StopLack::ambiguous;
      else
        outcome.length = length_of(standstill(m), segment);
    }
    const std::size_t heard = matches_.empty() ? 0 : matches_.back().stop + 1;
    for (std::size_t k = heard; k < stops().size(); ++k) lengths_.stops[k].lack = StopLack::not_reached;
    find_unused();
    return std::move(lengths_);
  }

 private:
  std::span<const ExpectedStop> stops() const { return matcher_.stops(); }
  const Standstill& standstill(const StopMatch& match) const { return matcher_.standstills()[match.standstill]; }

  StopLength length_of(const Standstill& s, std::size_t segment) const {
    StopLength length{s.position.in_native(),
                      s.spread.in_native(),
                      s.drift.in_native(),
                      0.5 * (s.used_from_s + s.used_to_s),
                      s.count,
                      segment};
    if (s.rejected > 0)
      length.remarks.push_back(fmt::format("{} of {} samples left out as outliers", s.rejected, s.count + s.rejected));
    if (std::abs(s.drift.in_native()) > s.threshold.in_native())
      length.remarks.push_back(
          fmt::format("drifts by {} µm while at rest", format_fixed(s.drift.in_native() * um_per_mm, 2)));
    if (s.cut_off) length.remarks.emplace_back("cut off by missing samples or the end of the recording");
    return length;
  }

  /// Whether the standstill of one stop may be that of another, which has none.
  bool may_be(const StopMatch& match, std::size_t other) const {
    const ExpectedStop& a = stops()[match.stop];
    const ExpectedStop& b = stops()[other];
    const auto& arrival = standstill(match).arrival;
    const bool alike = a.arrival == b.arrival && distance(a.reflector_mm, b.reflector_mm) <= same_place_mm;
    const bool excluded = arrival && b.arrival && (*arrival == Direction::up) != (b_arrival_shown(b) == Direction::up);
    if (alike || excluded) return false;
    return std::abs(a.distance_mm() - b.distance_mm()) <= matcher_.tolerance_mm(match.stop, other);
  }
  Direction b_arrival_shown(const ExpectedStop& stop) const {
    const bool turned = matcher_.options().reversed;
    return (*stop.arrival == Direction::up) != turned ? Direction::up : Direction::down;
  }

  void find_ambiguous() {
    ambiguous_.assign(matches_.size(), false);
    for (std::size_t k = 0; k < matches_.size(); ++k) {
      const std::size_t own = matches_[k].stop;
      const std::size_t first = k == 0 ? 0 : matches_[k - 1].stop + 1;
      const std::size_t last = k + 1 == matches_.size() ? own : matches_[k + 1].stop;
      for (std::size_t other = own; other-- > first && !stops()[other + 1].begins_segment;)
        if (may_be(matches_[k], other)) ambiguous_[k] = true;
      for (std::size_t other = own + 1; other < last && !stops()[other].begins_segment; ++other)
        if (may_be(matches_[k], other)) ambiguous_[k] = true;
    }
  }

  void find_unused() {
    if (matches_.empty()) return;
    std::size_t next = 0;
    for (std::size_t k = matches_.front().standstill; k < matches_.back().standstill; ++k) {
      while (matches_[next].standstill < k) ++next;
      if (matches_[next].standstill != k && matcher_.gives_length(matcher_.standstills()[k]))
        lengths_.unused.push_back(matcher_.standstills()[k]);
    }
  }

  const StopMatcher& matcher_;
  std::vector<StopMatch> matches_;
  std::vector<bool> ambiguous_;
  StopLengths lengths_;
};

/// The same standstills under other assumptions.
StopMatcher matched_again(const StopMatcher& matcher, std::vector<ExpectedStop> stops, bool reversed) {
  StopMatcherOptions options = matcher.options();
  options.reversed = reversed;
  StopMatcher again(std::move(stops), options);
  for (const Standstill& s : matcher.standstills()) again.take(s);
  return again;
}

double turned_cost(const StopMatcher& matcher) {
  return matched_again(matcher, {matcher.stops().begin(), matcher.stops().end()}, !matcher.options().reversed).cost();
}

/// A recording of something else has standstills that are no stops beside stops without one, or changes of length that
/// are none of the list.
Result<void> check_stop_fit(const StopLengths& lengths, const StopMatcher& matcher) {
  const std::size_t matches = matcher.matched();
  if (matcher.standstills().empty())
    return fail(
        "found no standstill in the recording, expected the reflector to rest at every stop for sixteen samples and "
        "more");
  if (matches > 0 && turned_cost(matcher) + much_cheaper < matcher.cost())
    return fail(
        fmt::format("found lengths that {} where the reflector recedes from the station, expected them to {}: the "
                    "instrument counts the other way, or this is the recording of another plan",
                    matcher.options().reversed ? "grow" : "fall", matcher.options().reversed ? "fall" : "grow"));
  const auto heard = static_cast<double>(matches);
  const auto unused = static_cast<double>(lengths.unused.size());
  const auto missed = static_cast<double>(std::ranges::count_if(
      lengths.stops, [](const StopOutcome& s) { return !s.length && s.lack != StopLack::not_reached; }));
  const auto jumps = static_cast<std::size_t>(std::ranges::count(lengths.segments, true, &SegmentBegin::untold));
  const bool few = matches == 0 || heard < resting_share * (heard + unused) ||
                   std::min(missed, unused) > displaced_share * heard ||
                   (matches < 3 && lengths.stops.size() >= 3 && lengths.standstills > 2 * matches);
  if (!few && (jumps <= jumps_always || static_cast<double>(jumps) < jump_share * heard)) return {};
  return fail(fmt::format(
      "found {} of {} standstills at the {} stops of the plan, and {} changes of length that are none of it, expected "
      "most standstills at stops: the recording belongs to another plan, or its lengths are in another unit",
      matches, lengths.standstills, lengths.stops.size(), jumps));
}

}  // namespace

std::string_view lack_name(StopLack lack) {
  switch (lack) {
    case StopLack::no_standstill: return "no standstill";
    case StopLack::too_short: return "too short";
    case StopLack::signal_lost: return "signal lost";
    case StopLack::ambiguous: return "ambiguous";
    case StopLack::not_reached: return "not reached";
  }
  return "";
}

std::size_t StopLengths::found() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(stops, [](const StopOutcome& s) { return s.length.has_value(); }));
}

StopListener::StopListener(std::vector<ExpectedStop> stops, const StopOptions& options)
    : matcher_(std::move(stops), matcher_of(options)),
      watch_({.speed_mm_per_s = options.fastest_mm_per_s}),
      detector_(rest_of(options)) {}

BeamWatch::Sink StopListener::sink() {
  return {.samples = [this](std::span<const Sample> samples) { take(detector_.push(samples)); },
          .broken = [this](double) { take(detector_.jumped()); },
          .missing = [this](double time_s) { missing_s_.push_back(time_s); }};
}

/// Samples that were missing for a time too short for the detector end no rest, but the dead path may be another one.
void StopListener::take(const std::vector<Standstill>& found) {
  for (Standstill s : found) {
    for (; !missing_s_.empty() && missing_s_.front() <= s.begin_s; missing_s_.pop_front()) s.after_gap = true;
    matcher_.take(s);
  }
}

void StopListener::push(std::span<const Sample> samples) { watch_.push(samples, sink()); }

void StopListener::interrupt() {
  watch_.interrupt(sink());
  take(detector_.interrupt());
}

StopMatcher matched_to(const StopMatcher& heard, std::vector<ExpectedStop> stops) {
  return matched_again(heard, std::move(stops), heard.options().reversed);
}

Result<StopLengths> stop_lengths(const StopMatcher& matcher) {
  StopLengths first = Outcome(matcher).run();
  AXIOMETRY_TRY_VOID(check_stop_fit(first, matcher));
  const StopMatcher refined = matched_to(matcher, refined_stops(matcher));
  if (refined.matched() < matcher.matched()) return first;
  return Outcome(refined).run();
}

Result<StopLengths> lengths_at_stops(std::span<const Sample> samples, std::vector<ExpectedStop> stops,
                                     const StopOptions& options) {
  StopListener listener(std::move(stops), options);
  listener.push(samples);
  listener.interrupt();
  return listener.lengths();
}

}  // namespace axiometry::capture
