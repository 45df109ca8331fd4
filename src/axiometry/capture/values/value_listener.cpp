// SPDX-License-Identifier: Apache-2.0
#include "axiometry/capture/values/value_listener.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "axiometry/base/contract.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/unit_sizes.h"

namespace axiometry::capture {
namespace {

constexpr double window_share = 0.4;  // window as a share of the dwell
constexpr double window_without_dwell_s = 1.0;
constexpr std::size_t most_of_a_rest = std::size_t{1} << 22;  // samples: an hour at 1 kHz; the newest count
constexpr std::size_t most_held = std::size_t{1} << 17;       // readings behind one that waits for a person
constexpr double windows_kept = 4.0;                          // of a rest that is not known to have begun

std::vector<std::string> remarks_of(const StillValue& still) {
  if (still.rejected == 0) return {};
  return {fmt::format("{} {} left out", still.rejected, still.rejected == 1 ? "outlier" : "outliers")};
}

/// Of the position while the reading was taken, which is another quantity.
std::vector<std::string> remarks_of_position(const Standstill& s) {
  std::vector<std::string> remarks;
  if (s.rejected > 0)
    remarks.push_back(
        fmt::format("{} of {} samples of the position left out as outliers", s.rejected, s.count + s.rejected));
  if (std::abs(s.drift.in_native()) > s.threshold.in_native())
    remarks.push_back(
        fmt::format("the position drifts by {} µm while at rest", format_fixed(s.drift.in_native() * um_per_mm, 2)));
  if (s.cut_off) remarks.emplace_back("cut off by missing samples or the end of the recording");
  return remarks;
}

}  // namespace

Duration value_window(const Plan& plan) {
  return plan.dwell.in_s() > 0.0 ? Duration(window_share * plan.dwell) : Duration::s(window_without_dwell_s);
}

ValueListener::ValueListener(Plan plan, const ValueOptions& options)
    : plan_(std::move(plan)), options_(options), progress_(plan_) {}

Result<ValueListener> ValueListener::make(Plan plan, const ValueOptions& options) {
  if (options.matcher.zero_at_first_target)
    return fail(
        "found a zero to be set at the first target, expected the datum of the position: readings beside it "
        "are taken as they come");
  ValueListener listener(std::move(plan), options);
  if (options.sign != StopSign::position) return listener;
  listener.detector_ = std::make_unique<StandstillDetector>(options.rest);
  AXIOMETRY_TRY(TargetMatcher matcher, TargetMatcher::make(listener.plan_, options.matcher));
  listener.matcher_.emplace(std::move(matcher));
  return listener;
}

void ValueListener::event(EventKind kind, double time_s, std::string message) {
  tell_more_alike();
  events_.push_back({kind, time_s, std::move(message)});
}

/// An instrument that sends all the time, or a trigger that chatters, would say the same a hundred times a second.
void ValueListener::refused(EventKind kind, double time_s, std::string message) {
  if (last_refused_ && !events_.empty() && events_.back().message == message) {
    last_refused_ = CaptureEvent{kind, time_s, {}};
    ++more_alike_;
    return;
  }
  event(kind, time_s, std::move(message));
  last_refused_ = events_.back();
}

void ValueListener::tell_more_alike() {
  const std::size_t count = std::exchange(more_alike_, 0);
  const auto last = std::exchange(last_refused_, std::nullopt);
  if (count > 0) events_.push_back({last->kind, last->time_s, fmt::format("{} more in the same way: not used", count)});
}

void ValueListener::judge_by(const StillOptions& still) {
  AXIOMETRY_CONTRACT(!last_);
  options_.still = still;
}

void ValueListener::push(std::span<const Sample> values) {
  for (const Sample& value : values) take(value);
}

void ValueListener::take(const Sample& value) {
  lowest_ = std::min(lowest_, value.position);
  highest_ = std::max(highest_, value.position);
  while (!pressed_.empty() && pressed_.front().time_s < value.time_s) act_again();
  last_ = value;
  now_s_ = value.time_s;
  if (options_.sign == StopSign::position) return window_.push_back(value);
  if (options_.sign == StopSign::readings)
    return offer(
        {value.time_s, StillValue{.from_s = value.time_s, .to_s = value.time_s, .count = 1, .value = value.position}});
  if (window_from_s_ && value.time_s > *window_from_s_ + options_.window.in_s()) close_window();
  while (!edges_.empty() && edges_.front() <= value.time_s) {
    open_window(edges_.front());
    edges_.pop_front();
  }
  if (window_from_s_ && value.time_s >= *window_from_s_) window_.push_back(value);
}

void ValueListener::push_beside(std::span<const Sample> samples) {
  if (options_.sign == StopSign::position) {
    match(detector_->push(samples));
    return samples.empty() ? void() : forget_before(samples.back().time_s);
  }
  for (const Sample& sample : samples) {
    const bool on = sample.position != 0.0;
    if (on && level_ == false) edges_.push_back(sample.time_s);
    level_ = on;
  }
}

double ValueListener::press(StopKey key) {
  while (!pressed_.empty() && pressed_.front().time_s <= now_s_) act_again();  // in a recording that is gone on with
  double time_s = now_s_;
  // What waits must be told before it, when the recording is played again.
  if (!held_.empty()) time_s = std::nextafter(held_.front().time_s, -std::numeric_limits<double>::infinity());
  act({key, time_s});
  return time_s;
}

void ValueListener::press_at(StopKey key, double time_s) { pressed_.push_back({key, time_s}); }

void ValueListener::act_again() {
  const Pressed pressed = pressed_.front();
  pressed_.pop_front();
  act(pressed);
}

void ValueListener::act(const Pressed& pressed) {
  const StopKey key = pressed.key;
  const double time_s = std::isfinite(pressed.time_s) ? pressed.time_s : 0.0;  // before the first reading
  if (options_.sign == StopSign::position) return;                             // says itself which target it is
  if (key == StopKey::take) {
    if (options_.sign == StopSign::keys) return take_key(time_s);
    trusted_ = true;
  } else if (key == StopKey::undo && window_from_s_ && !progress_.complete()) {
    window_from_s_.reset();
    event(EventKind::undone, time_s, fmt::format("the reading of {} that had begun", approach_name(*due())));
  } else if (key == StopKey::undo) {
    warned_ = trusted_ = false;
    window_from_s_.reset();  // of a trigger more than the plan has approaches
    if (progress_.undo()) event(EventKind::undone, time_s, fmt::format("{} is due again", approach_name(*due())));
  } else if (!progress_.complete()) {
    warned_ = trusted_ = false;
    window_from_s_.reset();
    event(EventKind::skipped, time_s, fmt::format("{} has no reading", approach_name(*due())));
    progress_.pass(std::nullopt);
  }
  doubt_told_ = false;
  drain();
}

void ValueListener::take_key(double time_s) {
  if (progress_.complete() || window_from_s_) return;
  if (!last_) return event(EventKind::unsteady, 0.0, "no reading has come yet: not used");
  if (!warned_ && progress_.timing(time_s) == Timing::doubled) {
    warned_ = true;
    return event(EventKind::repeated, time_s,
                 fmt::format("the plan's program needs {} s to {}, which is much longer than since the reading before: "
                             "not used; again takes it all the same",
                             format_fixed(progress_.planned_s(), 1), approach_name(*due())));
  }
  open_window(std::nextafter(time_s, std::numeric_limits<double>::infinity()));
}

void ValueListener::open_window(double from_s) {
  if (window_from_s_)
    return refused(EventKind::repeated, from_s, "a trigger while the one before was being read: not used");
  window_from_s_ = from_s;
  window_.clear();
}

void ValueListener::close_window() {
  const double time_s = *std::exchange(window_from_s_, std::nullopt);
  offer({time_s, still_value(window_, options_.still)});
}

void ValueListener::offer(Candidate candidate) {
  if (held_.size() == most_held)
    return refused(EventKind::unexpected, candidate.time_s,
                   "a reading behind very many that wait to be told their target: not used");
  held_.push_back(std::move(candidate));
  drain();
}

void ValueListener::drain() {
  while (!held_.empty() && settle(held_.front())) held_.pop_front();
}

/// False where it must wait for a person to say what it is.
bool ValueListener::settle(const Candidate& candidate) {
  if (progress_.complete()) {
    refused(EventKind::unexpected, candidate.time_s, "a reading more than the plan has approaches: not used");
    return true;
  }
  const bool by_order = options_.sign != StopSign::keys && !trusted_;
  const Timing timing = by_order ? progress_.timing(candidate.time_s) : Timing::fits;
  if (timing == Timing::doubled) {
    refused(EventKind::repeated, candidate.time_s,
            fmt::format("sooner than the axis can be at {}, to which the plan's program needs {} s: not used",
                        approach_name(*due()), format_fixed(progress_.planned_s(), 1)));
    return true;
  }
  if (timing == Timing::doubtful) {
    if (!std::exchange(doubt_told_, true))
      event(EventKind::doubtful, candidate.time_s,
            fmt::format("so late that {} may have been passed without a reading (the plan's program needs {} s): it "
                        "and all behind it wait to be told; \"take\" when it is this one, \"skip\" when this one is "
                        "missing",
                        approach_name(*due()), format_fixed(progress_.planned_s(), 1)));
    return false;
  }
  give(candidate);
  return true;
}

void ValueListener::give(const Candidate& candidate) {
  trusted_ = warned_ = doubt_told_ = false;
  const Approach approach = *due();
  tell_more_alike();
  if (candidate.still) {
    given_.push_back({approach, *candidate.still, remarks_of(*candidate.still)});
    return progress_.put(given_.back(), candidate.time_s);
  }
  const bool still_due = options_.sign == StopSign::keys;
  event(EventKind::unsteady, candidate.time_s,
        fmt::format("{}: {}; not used{}", approach_name(approach), candidate.still.error().message,
                    still_due ? ", the target is still due" : ""));
  if (!still_due) progress_.pass(candidate.time_s);
}

void ValueListener::match(const std::vector<Standstill>& standstills) {
  for (const Standstill& standstill : standstills) {
    const std::size_t before = matcher_->result().readings.size();
    const std::vector<CapturedReading> found = matcher_->take(standstill);
    if (matcher_->result().readings.size() < before + found.size()) at_rests_.clear();  // the test was begun anew
    take_events();
    for (const CapturedReading& reading : found) read_rest(reading);
  }
}

/// Those of the matcher that are new.
void ValueListener::take_events() {
  const auto& told = matcher_->result().events;
  events_matched_ = std::min(events_matched_, told.size());
  events_.insert(events_.end(), told.begin() + static_cast<std::ptrdiff_t>(events_matched_), told.end());
  events_matched_ = told.size();
}

void ValueListener::read_rest(const CapturedReading& reading) {
  const Standstill& rest = reading.standstill;
  const auto from = std::ranges::lower_bound(window_, rest.used_from_s, {}, &Sample::time_s);
  const auto to = std::ranges::upper_bound(window_, rest.used_to_s, {}, &Sample::time_s);
  const auto still = still_value(std::span(from, std::max(from, to)), options_.still);
  if (!still)
    return event(EventKind::unsteady, rest.used_from_s,
                 fmt::format("{}: {}; not used", approach_name(reading.approach), still.error().message));
  std::vector<std::string> remarks = remarks_of(*still);
  const std::vector<std::string> of_position = remarks_of_position(rest);
  remarks.insert(remarks.end(), of_position.begin(), of_position.end());
  at_rests_.push_back({reading.approach, *still, std::move(remarks)});
  given_.push_back(at_rests_.back());
}

/// A rest that goes on began at most a few windows before it was seen. The time is that of the positions, of which the
/// readings may be far ahead.
void ValueListener::forget_before(double time_s) {
  const auto now = detector_->now();
  std::size_t old = window_.size() > most_of_a_rest ? window_.size() - most_of_a_rest : 0;
  if (!(now && now->at_rest)) {
    const double kept_s = windows_kept * options_.rest.window.in_s() + options_.rest.settling.in_s();
    const auto first = std::ranges::lower_bound(window_, time_s - kept_s, {}, &Sample::time_s);
    old = std::max(old, static_cast<std::size_t>(first - window_.begin()));
  }
  if (2 * old > window_.size()) window_.erase(window_.begin(), window_.begin() + static_cast<std::ptrdiff_t>(old));
}

void ValueListener::interrupt() {
  while (!pressed_.empty() && pressed_.front().time_s <= now_s_) act_again();  // what was said before the gap
  if (last_) now_s_ = std::nextafter(now_s_, std::numeric_limits<double>::infinity());
  if (detector_) match(detector_->interrupt());
  level_.reset();
  edges_.clear();
  if (!detector_ && window_from_s_) {
    const double time_s = *std::exchange(window_from_s_, std::nullopt);
    offer({time_s, fail("samples are missing, or the recording ended, while it was read")});
  }
}

Result<void> ValueListener::finish() {
  while (!pressed_.empty()) act_again();
  interrupt();
  const double end_s = last_ ? last_->time_s : 0.0;
  tell_more_alike();
  if (lowest_ >= highest_ && taken() > 1)
    event(EventKind::signal_lost, end_s,
          fmt::format("every sample of the recording is {} {}, to the last digit: the instrument may not have measured",
                      format_exact(lowest_), options_.still.unit));
  if (matcher_) {
    AXIOMETRY_TRY_VOID(matcher_->finish());
    AXIOMETRY_TRY_VOID(check_positions());
    take_events();
    return {};
  }
  if (!held_.empty())
    event(EventKind::doubtful, end_s,
          fmt::format("{} {} whose target was not told: not used", held_.size(),
                      held_.size() == 1 ? "reading" : "readings"));
  if (const auto first = due()) event(EventKind::incomplete, end_s, ended_before(*first, progress_.remaining() - 1));
  return {};
}

Result<void> ValueListener::check_positions() const {
  return matcher_ ? check_fit(plan_, matcher_->result()) : Result<void>{};
}

bool ValueListener::complete() const { return matcher_ ? matcher_->complete() : progress_.complete(); }

std::size_t ValueListener::taken() const { return matcher_ ? at_rests_.size() : progress_.taken(); }

std::optional<Approach> ValueListener::due() const { return matcher_ ? matcher_->due() : progress_.due(); }

std::vector<PlannedValue> ValueListener::values() const { return matcher_ ? at_rests_ : progress_.values(); }

std::optional<double> ValueListener::now() const { return last_ ? std::optional(last_->position) : std::nullopt; }

}  // namespace axiometry::capture
