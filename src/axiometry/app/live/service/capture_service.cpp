// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/live/service/capture_service.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <set>

#include "axiometry/app/files/given_text.h"
#include "axiometry/app/files/source.h"
#include "axiometry/app/live/disk/stop_marks.h"
#include "axiometry/app/live/service/capture_running.h"
#include "axiometry/app/live/sources/own_options.h"
#include "axiometry/app/live/sources/simulated_lengths.h"
#include "axiometry/app/live/sources/simulated_motion.h"
#include "axiometry/app/plan/plan.h"
#include "axiometry/app/recordings/stop_options.h"
#include "axiometry/base/at_scope_end.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/store/database/clock.h"

namespace axiometry::app {
namespace {

using Stage = CaptureState::Stage;

constexpr std::size_t ended_remembered = 50;
constexpr auto longest_stop = std::chrono::seconds(5);

Result<Plan> part_of(const Plan& whole, std::size_t part) {
  if (part == 1) {
    Plan alone = whole;
    alone.further.clear();
    return alone;
  }
  if (part < 1 || part > whole.further.size() + 1)
    return fail(fmt::format("found part {} asked for, expected 1 to {}: the plan and those that belong to it", part,
                            whole.further.size() + 1));
  return whole.further[part - 2];
}

/// A source that is no longer named: what was heard of it can still be kept.
CaptureSource without_address(const std::string& id) {
  return {.id = id, .kind = CaptureSource::Kind::tcp, .title = id, .address = {}};
}

/// Bytes; none of a file that is not there.
std::uint64_t size_of_recorded(const std::string& recorded) {
  std::error_code none;
  const auto size = std::filesystem::file_size(recorded, none);
  return none ? 0 : size;
}

/// A connection that is there already is handed out first.
Connect with_first(std::unique_ptr<LiveStream> first, Connect connect) {
  auto held = std::make_shared<std::unique_ptr<LiveStream>>(std::move(first));
  return [held, connect = std::move(connect)]() -> Result<std::unique_ptr<LiveStream>> {
    if (*held) return std::move(*held);
    return connect();
  };
}

}  // namespace

CaptureService::CaptureService(CaptureSettings settings, CaptureKeeping keeping, CaptureFolder folder)
    : settings_(std::move(settings)), keeping_(std::move(keeping)), folder_(std::move(folder)) {}

CaptureService::~CaptureService() {
  const std::scoped_lock lock(mutex_);
  for (const auto& [id, capture] : captures_) capture->interrupt();
  captures_.clear();
}

Result<std::unique_ptr<CaptureService>> CaptureService::open(CaptureSettings settings, CaptureKeeping keeping) {
  std::set<std::string> names;
  for (const CaptureSource& source : settings.sources)
    if (!names.insert(text::to_lower(source.id)).second)
      return fail(fmt::format("found two sources named {}, expected different names", source.id));
  CaptureFolder folder(settings.folder);
  settings.sources.insert(settings.sources.begin(), simulator_source());
  std::unique_ptr<CaptureService> service(
      new CaptureService(std::move(settings), std::move(keeping), std::move(folder)));
  service->agree_with_archive();
  return service;
}

Result<const CaptureSource*> CaptureService::source_named(const std::string& id) const {
  const auto source = std::ranges::find(settings_.sources, id, &CaptureSource::id);
  if (source != settings_.sources.end()) return &*source;
  std::vector<std::string_view> ids;
  for (const CaptureSource& s : settings_.sources) ids.push_back(s.id);
  return fail(ErrorKind::not_found,
              fmt::format("found no source {}, expected one of {}", text::quoted(id), fmt::join(ids, ", ")));
}

/// Checks everything and reaches the source, but for one that is concluded without it.
Result<CaptureService::Begun> CaptureService::begin(const CaptureOrder& order, Way way, const std::string& recorded,
                                                    std::optional<LengthTask> task) const {
  auto named = source_named(order.source);
  if (!named && way != Way::conclude) return std::unexpected(std::move(named).error());
  CaptureSource source = named ? **named : without_address(order.source);
  const bool simulated = source.id == simulator_source().id;
  AXIOMETRY_TRY(const OwnOptions own, own_options(order.options, source.kind));
  AXIOMETRY_TRY(CaptureOptions options, live_options_from(own.others));
  if (own.size && !options.motion)
    return fail("found size, expected it with the stops of a straightness or a rotation only");
  if (options.motion && !recorded.empty()) {
    AXIOMETRY_TRY(options.motion->marks, marks_beside(recorded));
  }
  const std::uint64_t heard = recorded.empty() ? 0 : size_of_recorded(recorded);
  options.stream = order.layout;
  options.recording.skip_damaged = true;
  if (options.motion && simulated) AXIOMETRY_TRY_VOID(hear_simulated_motion(options));
  if (order.lengths && !task) {
    AXIOMETRY_TRY(task, task_of(*order.lengths, order.part));
  }
  AXIOMETRY_TRY(CaptureSession session, task ? task->open(options) : CaptureSession::open(order.walked, options));
  Begun begun{std::move(source), std::move(session), {.name = {}, .connect = {}, .raw = {}}, {}, std::move(task)};
  begun.live.give_up = own.give_up;
  begun.live.raw_limit = settings_.raw_limit;
  begun.live.for_undo = settings_.for_undo;
  if (simulated && begun.session.motion() != nullptr) {
    if (way == Way::conclude) return begun;
    AXIOMETRY_TRY(SimulatedMotion made,
                  simulated_motion_source(simulated_motion_of(own, {own.speed, heard}), begun.session));
    begun.live.connect = std::move(made.connect);
    begun.live.beside = std::move(made.beside);
    return begun;
  }
  if (simulated && begun.task) {
    if (way == Way::conclude) return begun;
    AXIOMETRY_TRY(
        begun.live.connect,
        simulated_lengths_source({*begun.task, own.preset, own.seed.value_or(1), {.speed = own.speed, .skip = heard}}));
    return begun;
  }
  if (simulated)
    begun.simulated = {
        .plan = order.walked, .preset = own.preset, .seed = own.seed.value_or(1), .speed = own.speed, .skip = heard};
  if (way == Way::conclude) return begun;
  if (simulated) {
    AXIOMETRY_TRY(begun.live.connect, simulated_source(*begun.simulated));
    return begun;
  }
  const Connect connect = [address = begun.source.address] { return connect_to(address); };
  auto first = connect();
  if (!first) return fail(ErrorKind::unavailable, fmt::format("{}: {}", begun.source.id, first.error().message));
  begun.live.connect = with_first(*std::move(first), connect);
  return begun;
}

std::vector<std::string> CaptureService::without_order() const {
  const std::scoped_lock lock(mutex_);
  return folder_.without_order();
}

/// A place among those that run, and the source, which has one listener.
Result<void> CaptureService::reserve(const CaptureSource& source) {
  const std::scoped_lock lock(mutex_);
  std::size_t running = beginning_.size();
  bool taken = std::ranges::find(beginning_, source.id) != beginning_.end();
  for (const auto& [id, capture] : captures_) {
    if (capture->ended() || capture->concluding()) continue;
    ++running;
    taken = taken || capture->source() == source.id;
  }
  if (running >= settings_.most_at_once)
    return fail(ErrorKind::unavailable, fmt::format("found {} captures running, expected fewer than {}: stop one",
                                                    running, settings_.most_at_once));
  if (taken && source.kind != CaptureSource::Kind::simulator)
    return fail(ErrorKind::conflict,
                fmt::format("found another capture listening to {}, expected none: it has one listener", source.id));
  beginning_.push_back(source.id);
  return {};
}

void CaptureService::release(const std::string& source) {
  const std::scoped_lock lock(mutex_);
  beginning_.erase(std::ranges::find(beginning_, source));
}

CaptureState CaptureService::launch(HeldCapture held, Begun begun, Way way) {
  begun.live.name = base_name(held.raw());
  (way == Way::listen ? begun.live.raw : begun.live.resume) = held.raw();
  const store::Id id = held.id();
  auto running = std::make_shared<Running>(std::move(held), std::move(begun), keeping_);
  CaptureState state = running->state(0);
  const std::scoped_lock lock(mutex_);
  captures_[id] = std::move(running);
  forget_old();
  return state;
}

Result<CaptureState> CaptureService::start(const CaptureWish& wish) {
  AXIOMETRY_TRY(const CaptureSource* const source, source_named(wish.source));
  AXIOMETRY_TRY(const OwnOptions own, own_options(wish.options, source->kind));
  AXIOMETRY_TRY(const CaptureOptions options, live_options_from(own.others));
  CaptureOrder order{.plan = wish.plan,
                     .part = options.part.value_or(1),
                     .walked = {},
                     .source = wish.source,
                     .layout = wish.layout.empty() ? options.stream : wish.layout,
                     .options = wish.options,
                     .actor = wish.actor,
                     .started = store::now_text()};
  order.walked = wish.whole;  // of a motion it must have no further ones
  if (!options.motion) {
    AXIOMETRY_TRY(order.walked, part_of(wish.whole, options.part.value_or(1)));
  }
  if (source->kind == CaptureSource::Kind::simulator && !own.seed) put_seed(order.options, drawn_seed());
  return start(std::move(order), *source);
}

/// Of a source and an order that were looked at.
Result<CaptureState> CaptureService::start(CaptureOrder order, const CaptureSource& source,
                                           std::optional<LengthTask> task) {
  AXIOMETRY_TRY_VOID(reserve(source));
  const AtScopeEnd released([&] { release(source.id); });
  AXIOMETRY_TRY(Begun begun, begin(order, Way::listen, {}, std::move(task)));
  if (const MotionListener* motion = begun.session.motion())
    order.motion = {.error = motion->error(), .sign = motion->stated().sign};
  if (order.lengths) {
    AXIOMETRY_TRY(order.lengths->plan, keeping_.keep_plan(order, json::dump(begun.task->plan_value()) + "\n"));
  }
  auto held = [&] {
    const std::scoped_lock lock(mutex_);
    return folder_.add(order);
  }();
  if (!held) return std::unexpected(std::move(held).error());
  return launch(*std::move(held), std::move(begun), Way::listen);
}

/// Needs the lock. Each reads a whole recording in a thread of its own.
bool CaptureService::may_conclude() const {
  std::size_t concluding = about_to_conclude_.size();
  for (const auto& [id, capture] : captures_)
    if (capture->concluding() && !capture->ended() && !about_to_conclude_.contains(id)) ++concluding;
  return concluding < settings_.most_concluding;
}

Result<CaptureState> CaptureService::restart(store::Id id, Way way) {
  auto held = [&]() -> Result<HeldCapture> {
    const std::scoped_lock lock(mutex_);
    const auto running = captures_.find(id);
    if (restarting_.contains(id) || (running != captures_.end() && !running->second->ended()))
      return fail(ErrorKind::conflict, fmt::format("found capture {} running, expected one that was interrupted", id));
    AXIOMETRY_TRY(HeldCapture taken, folder_.take(id));
    if (way == Way::conclude && !may_conclude())
      return fail(ErrorKind::unavailable,
                  fmt::format("found {} interrupted captures being ended, expected fewer than {}: try again when one "
                              "of them is kept",
                              settings_.most_concluding, settings_.most_concluding));
    CaptureState waiting = state_of(taken.order(), id, Stage::waiting);
    if (way == Way::conclude) about_to_conclude_.insert(id);
    restarting_.emplace(id, std::move(waiting));
    return taken;
  }();
  if (!held) return std::unexpected(std::move(held).error());
  const AtScopeEnd restarted([&] {
    const std::scoped_lock lock(mutex_);
    restarting_.erase(id);
    about_to_conclude_.erase(id);
  });
  return way == Way::go_on ? go_on(*std::move(held)) : play(*std::move(held), way);
}

/// Lets go of it before it comes back with a failure.
Result<CaptureState> CaptureService::go_on(HeldCapture held) {
  std::optional<store::Id> test;
  if (!becomes_table(held.order())) {
    AXIOMETRY_TRY(test, keeping_.kept(held));
  }
  if (test) {
    held.remove();
    return fail(ErrorKind::conflict, fmt::format("found capture {} in the archive already, as test {}, expected one "
                                                 "that is to be gone on with",
                                                 held.id(), *test));
  }
  AXIOMETRY_TRY(const CaptureSource* const source, source_named(held.order().source));
  AXIOMETRY_TRY_VOID(reserve(*source));
  const AtScopeEnd released([&] { release(source->id); });
  return play(std::move(held), Way::go_on);
}

/// Where it is concluded it needs no place among those that listen.
Result<CaptureState> CaptureService::play(HeldCapture held, Way way) {
  AXIOMETRY_TRY(Begun begun, begin(held.order(), way, held.raw()));
  return launch(std::move(held), std::move(begun), way);
}

Result<CaptureState> CaptureService::resume(store::Id id) { return restart(id, Way::go_on); }

Result<CaptureState> CaptureService::stop(store::Id id) {
  auto running = find(id);
  if (!running || running->interrupted()) {
    AXIOMETRY_TRY_VOID(restart(id, Way::conclude));
    running = find(id);
  }
  if (!running) return fail(ErrorKind::not_found, fmt::format("found no capture {}", id));
  if (!running->concluding()) running->stop();
  running->wait_for_end(longest_stop);
  return running->state(0);
}

Result<CaptureState> CaptureService::press(store::Id id, capture::StopKey key) {
  AXIOMETRY_TRY(const CaptureState found, state(id));
  if (!found.motion || found.motion->order.sign == capture::StopSign::position)
    return fail(ErrorKind::conflict,
                fmt::format("found capture {}, at whose stops nothing can be said, expected one of a straightness or a "
                            "rotation with the stops keys, trigger or readings",
                            id));
  const auto running = find(id);
  if (!running || !running->press(key))
    return fail(ErrorKind::conflict, fmt::format("found capture {} not running, expected one that runs", id));
  return running->state(0);
}

std::shared_ptr<CaptureService::Running> CaptureService::find(store::Id id) const {
  const std::scoped_lock lock(mutex_);
  const auto place = captures_.find(id);
  return place == captures_.end() ? nullptr : place->second;
}

CaptureState CaptureService::state_of(const CaptureOrder& order, store::Id id, Stage stage) const {
  const auto source = source_named(order.source);
  CaptureState state;
  state.id = id;
  state.plan = order.plan;
  state.part = order.part;
  state.source = source ? **source : without_address(order.source);
  state.started = order.started;
  state.stage = stage;
  state.anew = true;
  state.kind = order.walked.axis.kind;
  state.targets = order.walked.targets;
  if (order.lengths) {
    state.approaches = order.lengths->stops;
    state.lengths = {.order = *order.lengths, .due = {}, .caught_at = 0, .caught = {}, .broken_before = {}};
  } else {
    state.approaches = approaches(order.walked).size();
    if (order.motion) state.motion = {.order = *order.motion};
  }
  return state;
}

CaptureState CaptureService::state_of(const CaptureFolder::Ended& ended) const {
  CaptureState state =
      state_of(ended.capture.order, ended.id, stage_named(ended.capture.end.stage).value_or(Stage::stopped));
  state.taken = ended.capture.end.found;
  state.error = ended.capture.end.error;
  state.came_to = ended.capture.end;
  return state;
}

Result<CaptureState> CaptureService::state(store::Id id, CaptureRevision after) {
  const std::scoped_lock lock(mutex_);
  if (const auto running = captures_.find(id); running != captures_.end()) return running->second->state(after);
  if (const auto restarting = restarting_.find(id); restarting != restarting_.end()) return restarting->second;
  if (const auto ended = folder_.ended(id)) return state_of(*ended);
  for (const CaptureFolder::Left& left : folder_.left_behind())
    if (left.id == id) return state_of(left.order, left.id, Stage::interrupted);
  return fail(ErrorKind::not_found, fmt::format("found no capture {} that runs or has run lately", id));
}

std::vector<CaptureState> CaptureService::states() {
  const std::scoped_lock lock(mutex_);
  std::vector<CaptureState> states;
  for (const auto& [id, capture] : captures_) states.push_back(capture->state({}));
  for (const auto& [id, state] : restarting_)
    if (!captures_.contains(id)) states.push_back(state);
  // Between giving up its lock and taking it again the folder has one that is being reached again, too.
  const auto is_listed = [&](store::Id id) { return captures_.contains(id) || restarting_.contains(id); };
  for (const CaptureFolder::Left& left : folder_.left_behind())
    if (!is_listed(left.id)) states.push_back(state_of(left.order, left.id, Stage::interrupted));
  for (const CaptureFolder::Ended& ended : folder_.ended())
    if (!is_listed(ended.id)) states.push_back(state_of(ended));
  std::ranges::sort(states, std::greater(), &CaptureState::id);
  return states;
}

/// Needs the lock.
void CaptureService::forget_old() {
  auto ended = static_cast<std::size_t>(
      std::ranges::count_if(captures_, [](const auto& entry) { return entry.second->ended(); }));
  for (auto entry = captures_.begin(); entry != captures_.end() && ended > ended_remembered;) {
    const bool goes = entry->second->ended();
    entry = goes ? captures_.erase(entry) : std::next(entry);
    ended -= goes ? 1 : 0;
  }
}

}  // namespace axiometry::app
