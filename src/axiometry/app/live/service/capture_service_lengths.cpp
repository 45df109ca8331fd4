// SPDX-License-Identifier: Apache-2.0
// Captures of lengths: what they wait for; and what those that became tables have become.
#include <fmt/format.h>

#include <charconv>
#include <set>
#include <utility>

#include "axiometry/app/files/given_text.h"
#include "axiometry/app/live/service/capture_running.h"
#include "axiometry/app/live/sources/own_options.h"
#include "axiometry/app/recordings/capture_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/store/database/clock.h"

namespace axiometry::app {
namespace {

/// All parts of one plan are simulated at one machine.
std::uint64_t seed_of(std::string_view plan_id) {
  constexpr std::size_t digits_below_limit = 13;
  std::uint64_t seed = 0;
  const std::string_view digits = plan_id.substr(0, digits_below_limit);
  std::from_chars(digits.data(), digits.data() + digits.size(), seed, 16);
  return seed % seed_limit;
}

}  // namespace

Result<CaptureState> CaptureService::start(const LengthWish& wish) {
  AXIOMETRY_TRY(const CaptureSource* const source, source_named(wish.source));
  AXIOMETRY_TRY(const OwnOptions own, own_options(wish.options, source->kind));
  AXIOMETRY_TRY(const CaptureOptions options, capture_options_from(own.others));
  CaptureOrder order{.plan = 0,
                     .part = wish.task.part(),
                     .walked = {},
                     .lengths = LengthOrder{.kind = wish.task.kind(),
                                            .plan = {},
                                            .plan_id = wish.task.plan_id(),
                                            .title = wish.task.title(),
                                            .stops = wish.task.stop_count()},
                     .source = wish.source,
                     .layout = wish.layout.empty() ? options.stream : wish.layout,
                     .options = wish.options,
                     .actor = wish.actor,
                     .started = store::now_text()};
  if (source->kind == CaptureSource::Kind::simulator && !own.seed)
    put_seed(order.options, seed_of(order.lengths->plan_id));
  return start(std::move(order), *source, wish.task);
}

Result<LengthTask> CaptureService::task_of(const LengthOrder& order, std::size_t part) const {
  AXIOMETRY_TRY(const std::string plan, keeping_.bytes(order.plan));
  AXIOMETRY_TRY(json::Value value, json::parse(plan));
  json::Value body = json::Value::object();
  body.add("plan", std::move(value));
  return LengthTask::make(order.kind, body, part);
}

Result<LengthTask> CaptureService::task_of(const CaptureState& state) const {
  if (state.lengths) return task_of(state.lengths->order, state.part);
  if (state.motion)
    return fail(ErrorKind::not_found, fmt::format("found capture {} of the error {}, expected one of lengths", state.id,
                                                  state.motion->order.error.text()));
  return fail(ErrorKind::not_found, fmt::format("found capture {} of a test, expected one of lengths", state.id));
}

Result<std::string> CaptureService::file_of(store::Id id, std::string_view role) {
  AXIOMETRY_TRY(const CaptureState found, state(id));
  return file_of(found, role);
}

Result<std::string> CaptureService::file_of(const CaptureState& found, std::string_view role) const {
  std::string sha256;
  if (const auto& end = found.came_to)
    sha256 = role == "raw"               ? end->raw
             : role == "times"           ? end->times
             : role == "keys"            ? end->keys
             : role == table_role(found) ? end->table
                                         : "";
  if (!sha256.empty()) return keeping_.bytes(sha256);
  return fail(ErrorKind::not_found, fmt::format("found no file {} of capture {}", text::quoted(role), found.id));
}

/// An archive that cannot be read or written now is asked again when the program begins the next time: what the folder
/// has stays as it is.
void CaptureService::agree_with_archive() {
  if (!keeping_.captures) return;
  const auto archived = keeping_.captures();
  if (!archived) return;
  std::set<std::string> listed, discarded;
  for (const EndedCapture& capture : archived->listed) listed.insert(identity_of(capture.order));
  for (const EndedCapture& capture : archived->discarded) discarded.insert(identity_of(capture.order));
  for (const CaptureFolder::Ended& ended : folder_.ended()) {
    const std::string identity = identity_of(ended.capture.order);
    if (discarded.contains(identity))
      static_cast<void>(folder_.discard(ended.id));
    else if (!listed.contains(identity))
      static_cast<void>(keeping_.keep_capture(ended.capture));
  }
  static_cast<void>(folder_.adopt(archived->listed));
}

Result<void> CaptureService::discard(store::Id id, const std::string& actor) {
  const std::scoped_lock lock(mutex_);
  const auto running = captures_.find(id);
  if (restarting_.contains(id) || (running != captures_.end() && !running->second->ended()))
    return fail(ErrorKind::conflict, fmt::format("found capture {} running, expected one that has ended", id));
  AXIOMETRY_TRY_VOID(folder_.discard(id, [&](const EndedCapture& capture) -> Result<void> {
    return keeping_.discard_capture ? keeping_.discard_capture(capture, actor) : Result<void>{};
  }));
  if (running != captures_.end()) captures_.erase(running);
  return {};
}

}  // namespace axiometry::app
