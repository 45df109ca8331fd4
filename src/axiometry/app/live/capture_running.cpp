// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/live/capture_running.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>

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
            .due = begun_->session.matcher().due(),
            .now = {},
            .taken = 0,
            .readings = {},
            .anew = false,
            .events = {},
            .notices = {},
            .so_far = nullptr,
            .test = {},
            .error = {}};
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
    return copy;
  }
  // One who knows a later revision has seen another program's life of this capture.
  const bool all = *after < anew_at_ || *after > state_.revision;
  copy.anew = all || *after == 0;
  for (const StampedReading& reading : state_.readings)
    if (all || reading.revision > *after) copy.readings.push_back(reading);
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
          .abandoned = [this] { return interrupt_.load(); }};
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
void CaptureService::Running::take_readings(const CaptureSession& session) {
  const auto& all = session.matcher().result().readings;
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

void CaptureService::Running::now(const CaptureSession& session) {
  {
    const std::scoped_lock lock(mutex_);
    ++state_.revision;
    if (session.samples() > 0) state_.stage = Stage::running;
    state_.due = session.matcher().due();
    state_.now = session.now();
    take_readings(session);
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
    const auto outcome = run_live_capture(std::move(begun_->session), begun_->live, watching);
    if (!interrupt_) end = conclude(outcome);
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

CaptureService::Running::End CaptureService::Running::conclude(const Result<CaptureOutcome>& outcome) {
  if (outcome) {
    {
      const std::scoped_lock lock(mutex_);
      ++state_.revision;
      for (std::size_t k = state_.readings.size(); k < outcome->result.readings.size(); ++k)
        state_.readings.push_back({state_.revision, outcome->result.readings[k]});
      state_.taken = state_.readings.size();
      state_.due.reset();
    }
    evaluate(outcome->test);
  }
  const Stage stage = outcome ? (outcome->complete ? Stage::complete : Stage::stopped)
                              : (stop_ || concludes_ ? Stage::stopped : Stage::failed);
  std::string error = outcome ? "" : outcome.error().message;
  const auto kept = keeping_.keep({*held_, std::move(test_)});
  if (!kept)
    return {.stage = Stage::interrupted,
            .test = {},
            .error = fmt::format("{}; what came stays on the disk and can be kept later", kept.error().message)};
  held_->remove();
  return {.stage = stage, .test = *kept, .error = std::move(error)};
}

void CaptureService::Running::tell(End end) {
  const std::scoped_lock lock(mutex_);
  ++state_.revision;
  state_.stage = end.stage;
  state_.now.reset();
  state_.test = end.test;
  state_.error = std::move(end.error);
  changed_.notify_all();
}

}  // namespace axiometry::app
