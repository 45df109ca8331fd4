// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/live/service/capture_running.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>

#include "axiometry/app/live/service/captured_motion.h"
#include "axiometry/app/recordings/raw_log.h"

namespace axiometry::app {

using Stage = CaptureState::Stage;

CaptureService::Running::Running(HeldCapture held, Begun begun, const CaptureKeeping& keeping)
    : source_(begun.source.id),
      concludes_(!begun.live.connect),
      keeping_(keeping),
      held_(std::move(held)),
      begun_(std::move(begun)) {
  const CaptureOrder& order = held_->order();
  state_ = {.id = held_->id(),
            .plan = order.plan,
            .part = order.part,
            .source = begun_->source,
            .started = order.started,
            .revision = 1,
            .stage = Stage::waiting,
            .kind = order.walked.axis.kind,
            .targets = order.walked.targets,
            .approaches = approaches(order.walked).size(),
            .due = {},
            .now = {},
            .taken = 0,
            .readings = {},
            .anew = false,
            .events = {},
            .notices = {},
            .so_far = nullptr,
            .test = {},
            .error = {}};
  if (order.lengths) {
    state_.approaches = order.lengths->stops;
    state_.lengths = {.order = *order.lengths,
                      .due = begun_->session.stops()->matcher().due(),
                      .caught_at = 1,
                      .caught = std::make_shared<const std::vector<CaughtLength>>(),
                      .broken_before = {}};
  } else if (const MotionListener* motion = begun_->session.motion()) {
    state_.motion = {.order = {.error = motion->error(), .sign = motion->stated().sign}};
    take_values(*motion);
  } else {
    state_.due = begun_->session.matcher().due();
  }
  thread_ = std::jthread([this] { run(); });
}

CaptureService::Running::~Running() { interrupt_ = true; }

void CaptureService::Running::wait_for_end(std::chrono::milliseconds longest) {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, longest, [this] { return has_ended(state_.stage); });
}

bool CaptureService::Running::ended() const {
  const std::scoped_lock lock(mutex_);
  return has_ended(state_.stage);
}

bool CaptureService::Running::interrupted() const {
  const std::scoped_lock lock(mutex_);
  return state_.stage == Stage::interrupted;
}

CaptureState CaptureService::Running::state(std::optional<CaptureRevision> after) const {
  const std::scoped_lock lock(mutex_);
  CaptureState copy = state_;
  copy.readings.clear();
  if (!after) {
    copy.events.clear();
    copy.so_far.reset();
    if (copy.lengths) copy.lengths->caught.reset();
    if (copy.motion) copy.motion->values.reset();
    return copy;
  }
  // One who knows a later revision has seen another program's life of this capture.
  const bool all = *after < anew_at_ || *after > state_.revision;
  copy.anew = all || *after == 0;
  for (const StampedReading& reading : state_.readings)
    if (all || reading.revision > *after) copy.readings.push_back(reading);
  if (copy.lengths && !all && copy.lengths->caught_at <= *after) copy.lengths->caught.reset();
  if (copy.motion) {
    if (!all && copy.motion->read_at <= *after) copy.motion->values.reset();
    copy.anew = copy.motion->values != nullptr;
  }
  return copy;
}

CaptureObserver CaptureService::Running::observer() {
  return {.reading = [this](const capture::CapturedReading&) { evaluated_ = false; },
          .event =
              [this](const capture::CaptureEvent& event) {
                const std::scoped_lock lock(mutex_);
                ++state_.revision;
                state_.events.push_back(event);
              },
          .notice =
              [this](const std::string& text) {
                const std::scoped_lock lock(mutex_);
                ++state_.revision;
                tell_notice(text);
              },
          .now = [this](const CaptureSession& session) { now(session); },
          .stopped = [this] { return stop_.load(); },
          .abandoned = [this] { return interrupt_.load(); },
          .value = {},
          .keys = [this] { return take_keys(); }};
}

bool CaptureService::Running::press(capture::StopKey key) {
  const std::scoped_lock lock(mutex_);
  if (listens_) keys_.push_back(key);
  return listens_;
}

std::vector<capture::StopKey> CaptureService::Running::take_keys() {
  const std::scoped_lock lock(mutex_);
  return std::exchange(keys_, {});
}

void CaptureService::Running::listen_no_more() {
  const std::scoped_lock lock(mutex_);
  listens_ = false;
  if (std::exchange(keys_, {}).empty()) return;
  ++state_.revision;
  tell_notice("what was said while the capture ended is not used");
}

/// A source that comes and goes all night must not make the state grow: what is told of it is counted then.
void CaptureService::Running::tell_notice(const std::string& text) {
  constexpr std::size_t most = 50;
  if (state_.notices.size() < most) {
    state_.notices.push_back(text);
    return;
  }
  state_.notices.erase(state_.notices.begin() + 1);
  state_.notices.front() = fmt::format("{} earlier messages are not shown", ++notices_left_out_ + 1);
  state_.notices.push_back(text);
}

/// Readings that are not among those we know; all of them where the capture has begun again.
void CaptureService::Running::take_readings(const std::vector<capture::CapturedReading>& all) {
  const bool again = all.size() < state_.readings.size() ||
                     (!state_.readings.empty() && !(all[state_.readings.size() - 1].standstill.begin_s ==
                                                    state_.readings.back().reading.standstill.begin_s));
  if (again) {
    state_.readings.clear();
    anew_at_ = state_.revision;
  }
  for (std::size_t k = state_.readings.size(); k < all.size(); ++k)
    state_.readings.push_back({state_.revision, all[k]});
  state_.taken = state_.readings.size();
}

/// A standstill may change what the ones before it are taken for.
void CaptureService::Running::take_lengths(const CaptureSession& session) {
  const capture::StopMatcher& matcher = session.stops()->matcher();
  if (matcher.standstills().size() == standstills_) return;
  standstills_ = matcher.standstills().size();
  LengthsState& lengths = *state_.lengths;
  lengths.due = matcher.due();
  CaughtLengths caught = caught_lengths(matcher);
  lengths.broken_before = std::move(caught.broken_before);
  state_.taken = caught.lengths.size();
  if (caught.lengths == *lengths.caught) return;
  lengths.caught = std::make_shared<const std::vector<CaughtLength>>(std::move(caught.lengths));
  lengths.caught_at = state_.revision;
}

/// Needs the lock. Of the values all are new where one was given or taken back, which an event tells.
void CaptureService::Running::take_values(const MotionListener& motion) {
  const capture::ValueListener& listener = motion.values();
  MotionState& known = *state_.motion;
  if (motion.unit_of_stream() != nullptr) known.unit = motion.unit();
  known.now = listener.now();
  known.is_reading = listener.is_reading();
  known.waits_for_key = listener.waits_for_key();
  state_.due = listener.due();
  const std::size_t told = listener.given().size() + listener.events().size();
  if (known.values && told == told_) return;
  told_ = told;
  known.values = std::make_shared<const std::vector<capture::PlannedValue>>(listener.values());
  known.read_at = state_.revision;
  state_.taken = known.values->size();
}

void CaptureService::Running::now(const CaptureSession& session) {
  {
    const std::scoped_lock lock(mutex_);
    ++state_.revision;
    if (session.samples() > 0) state_.stage = Stage::running;
    state_.now = session.now();
    if (state_.lengths) return take_lengths(session);
    if (state_.motion) return take_values(*session.motion());
    state_.due = session.matcher().due();
    take_readings(session.matcher().result().readings);
  }
  if (evaluated_) return;
  evaluated_ = true;
  if (auto test = session.test()) evaluate(*std::move(test));
}

void CaptureService::Running::evaluate(Test test) {
  if (begun_->simulated) mark_simulated(test, *begun_->simulated);
  test_ = std::move(test);
  auto evaluated = keeping_.evaluate(held_->order(), *test_);
  if (!evaluated) return;  // too little for an evaluation yet
  const std::scoped_lock lock(mutex_);
  ++state_.revision;
  state_.so_far = std::make_shared<const Outcome>(*std::move(evaluated));
}

void CaptureService::Running::run() {
  End end{.stage = Stage::interrupted, .test = {}, .error = {}};
  try {
    const CaptureObserver watching = observer();
    if (becomes_table(held_->order())) {
      const HeardLive heard = hear_live(std::move(begun_->session), begun_->live, watching);
      listen_no_more();
      if (!interrupt_) end = conclude_table(heard);
    } else {
      const auto outcome = run_live_capture(std::move(begun_->session), begun_->live, watching);
      if (!interrupt_) end = conclude(outcome);
    }
  } catch (const std::exception& exception) {
    end = {.stage = Stage::failed,
           .test = {},
           .error = fmt::format("the program failed at this capture: {}", exception.what())};
  }
  // Who sees the end may take source and files at once.
  begun_.reset();
  held_.reset();
  tell(std::move(end));
}

CaptureService::Running::End CaptureService::Running::left_for_later(const Error& error) {
  return {.stage = Stage::interrupted,
          .test = {},
          .error = fmt::format("{}; what came stays on the disk and can be kept later", error.message)};
}

CaptureService::Running::End CaptureService::Running::conclude(const Result<CaptureOutcome>& outcome) {
  if (outcome) {
    {
      const std::scoped_lock lock(mutex_);
      ++state_.revision;
      take_readings(outcome->result.readings);
      state_.due.reset();
    }
    evaluate(outcome->test);
  }
  const Stage stage = outcome ? (outcome->complete ? Stage::complete : Stage::stopped)
                              : (stop_ || concludes_ ? Stage::stopped : Stage::failed);
  std::string error = outcome ? "" : outcome.error().message;
  const auto kept = keeping_.keep({*held_, std::move(test_)});
  if (!kept) return left_for_later(kept.error());
  held_->remove();
  return {.stage = stage, .test = *kept, .error = std::move(error)};
}

Result<FoundTable> CaptureService::Running::table_of(const HeardLive& heard) const {
  const CaptureSession& session = heard.heard.session;
  if (begun_->task) return begun_->task->lengths(session);
  return captured_motion(session, held_->order(), heard.heard.date);
}

/// What the state shows at the end is what the table holds, as far as both are known.
CaptureService::Running::End CaptureService::Running::conclude_table(const HeardLive& heard) {
  if (!heard.on_disk) return left_for_later(*heard.trouble);
  {
    const std::scoped_lock lock(mutex_);
    ++state_.revision;
    state_.lengths ? take_lengths(heard.heard.session) : take_values(*heard.heard.session.motion());
  }
  const auto table = table_of(heard);
  auto kept = keeping_.keep_table(*held_, table ? std::optional(*table) : std::nullopt);
  if (!kept) return left_for_later(kept.error());
  const Stage stage = heard.trouble          ? (stop_ || concludes_ ? Stage::stopped : Stage::failed)
                      : heard.heard.complete ? Stage::complete
                                             : Stage::stopped;
  kept->stage = stage_name(stage);
  if (heard.trouble)
    kept->error = heard.trouble->message;
  else if (!table)
    kept->error = table.error().message;
  if (kept->raw.empty())
    held_->remove();  // nothing came
  else if (auto noted = ended_table(*kept); !noted)
    return left_for_later(noted.error());
  return {.stage = stage, .test = {}, .error = kept->error, .came_to = *kept};
}

/// In the archive before the folder says so: what was noted in both once is noted in both again.
Result<void> CaptureService::Running::ended_table(const TableEnd& end) {
  if (keeping_.keep_capture) AXIOMETRY_TRY_VOID(keeping_.keep_capture({held_->order(), end}));
  return held_->end(end);
}

void CaptureService::Running::tell(End end) {
  const std::scoped_lock lock(mutex_);
  ++state_.revision;
  if (state_.lengths && end.stage != Stage::interrupted) state_.lengths->due.reset();
  if (state_.motion) {
    if (end.stage != Stage::interrupted) state_.due.reset();
    state_.motion->now.reset();
    state_.motion->is_reading = state_.motion->waits_for_key = false;
  }
  state_.came_to = std::move(end.came_to);
  state_.stage = end.stage;
  listens_ = false;
  state_.now.reset();
  state_.test = end.test;
  state_.error = std::move(end.error);
  changed_.notify_all();
}

}  // namespace axiometry::app
