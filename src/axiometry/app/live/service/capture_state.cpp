// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/live/service/capture_state.h"

#include <fmt/format.h>

#include <utility>

#include "axiometry/app/live/sources/simulated_lengths.h"
#include "axiometry/app/live/sources/simulated_motion.h"
#include "axiometry/app/recordings/stop_options.h"
#include "axiometry/app/workbench/workbench_json.h"
#include "axiometry/simulation/presets.h"

namespace axiometry::app {
namespace {

using json::Value;

/// A text of this program in the reader's language.
std::string told_to(const Reader& reader, std::string_view text) {
  return language::translated(text, reader.language, reader.numbers);
}

Value captured_approach_value(const Approach& approach, const CaptureState& state) {
  Value value = Value::object();
  value.add("target", approach.target + 1);
  value.add("run", approach.run + 1);
  value.add("direction", approach.direction == Direction::up ? "up" : "down");
  if (approach.target < state.targets.size()) value.add("position", state.targets[approach.target].in_native());
  return value;
}

Value reading_value(const capture::CapturedReading& reading, const CaptureState& state, const Reader& reader) {
  Value value = captured_approach_value(reading.approach, state);
  value.add("deviation", reading.deviation.in_native());
  value.add("spread", reading.standstill.spread.in_native() * deviation_per_position(state.kind));
  value.add("samples", reading.standstill.count);
  Value remarks = Value::array();
  for (const std::string& remark : reading.remarks) remarks.push(told_to(reader, remark));
  value.add("remarks", std::move(remarks));
  return value;
}

Value value_read(const capture::PlannedValue& read, const CaptureState& state, const Reader& reader) {
  Value value = captured_approach_value(read.approach, state);
  value.add("deviation", read.still.value);
  value.add("spread", read.still.spread);
  value.add("samples", read.still.count);
  Value remarks = Value::array();
  for (const std::string& remark : read.remarks) remarks.push(told_to(reader, remark));
  value.add("remarks", std::move(remarks));
  return value;
}

Value event_value(const capture::CaptureEvent& event, const Reader& reader) {
  Value value = Value::object();
  value.add("kind", capture::event_name(event.kind));
  value.add("message", told_to(reader, event.message));
  value.add("time_s", event.time_s);
  return value;
}

Value now_value(const capture::StandstillDetector::Whereabouts& now) {
  Value value = Value::object();
  value.add("position", now.position.in_native());
  value.add("at_rest", now.at_rest);
  return value;
}

template <typename Things, typename Spell>
Value list_of(const Things& things, Spell spell) {
  Value list = Value::array();
  for (const auto& thing : things) list.push(spell(thing));
  return list;
}

Value caught_value(const CaughtLength& caught) {
  Value value = Value::object();
  value.add("stop", caught.stop + 1);
  value.add("length_mm", caught.length_mm);
  value.add("scatter_um", caught.scatter_um);
  value.add("time_s", caught.time_s);
  value.add("begins_segment", caught.begins_segment);
  return value;
}

Value end_value(const CaptureState& state, const Reader& reader) {
  if (!state.came_to) return {};
  const TableEnd& end = *state.came_to;
  Value value = Value::object();
  value.add("found", end.found);
  value.add("notes", list_of(end.notes, [&](const std::string& note) { return Value(told_to(reader, note)); }));
  Value files = Value::array();
  const std::pair<std::string_view, const std::string&> of_roles[] = {
      {"raw", end.raw}, {"times", end.times}, {"keys", end.keys}, {table_role(state), end.table}};
  for (const auto& [role, sha256] : of_roles)
    if (!sha256.empty()) files.push(role);
  value.add("files", std::move(files));
  return value;
}

std::string_view unit_name(const CaptureState& state) {
  if (!state.motion) return state.kind == AxisKind::linear ? "um" : "arcsec";
  const bool rotation = state.motion->order.error.rotation();
  return motion_unit_name(state.motion->unit.value_or(rotation ? MotionUnit::urad : MotionUnit::um));
}

Value motion_value(const CaptureState& state, const Reader& reader) {
  const MotionState& motion = *state.motion;
  Value value = Value::object();
  value.add("error", motion.order.error.text());
  value.add("stops", stop_sign_word(motion.order.sign));
  value.add("now", motion.now ? Value(*motion.now) : Value());
  value.add("is_reading", motion.is_reading);
  value.add("waits_for_key", motion.waits_for_key);
  value.add("end", end_value(state, reader));
  return value;
}

/// All of a motion where any has changed: one may have been taken back.
Value readings_value(const CaptureState& state, const Reader& reader) {
  if (state.motion && state.motion->values)
    return list_of(*state.motion->values, [&](const auto& read) { return value_read(read, state, reader); });
  return list_of(state.readings, [&](const StampedReading& r) { return reading_value(r.reading, state, reader); });
}

Value lengths_value(const CaptureState& state, const Reader& reader) {
  const LengthsState& lengths = *state.lengths;
  Value value = Value::object();
  value.add("kind", kind_name(lengths.order.kind));
  value.add("plan_id", lengths.order.plan_id);
  value.add("title", told_to(reader, lengths.order.title));
  value.add("due", lengths.due ? Value(*lengths.due + 1) : Value());
  value.add("caught", lengths.caught ? list_of(*lengths.caught, caught_value) : Value());
  value.add("broken_before", list_of(lengths.broken_before, [](std::size_t stop) { return Value(stop + 1); }));
  value.add("end", end_value(state, reader));
  return value;
}

}  // namespace

std::string_view stage_name(CaptureState::Stage stage) {
  switch (stage) {
    case CaptureState::Stage::waiting: return "waiting";
    case CaptureState::Stage::running: return "running";
    case CaptureState::Stage::complete: return "complete";
    case CaptureState::Stage::stopped: return "stopped";
    case CaptureState::Stage::failed: return "failed";
    case CaptureState::Stage::interrupted: return "interrupted";
  }
  return "";
}

std::optional<CaptureState::Stage> stage_named(std::string_view name) {
  using enum CaptureState::Stage;
  for (const CaptureState::Stage stage : {waiting, running, complete, stopped, failed, interrupted})
    if (stage_name(stage) == name) return stage;
  return {};
}

std::string_view table_role(const CaptureState& state) { return state.motion ? "readings" : "lengths"; }

bool has_ended(CaptureState::Stage stage) {
  return stage != CaptureState::Stage::waiting && stage != CaptureState::Stage::running;
}

Value to_json(const CaptureSource& source, const Reader& reader) {
  const auto told = [&](std::string_view text) { return told_to(reader, text); };
  Value value = Value::object();
  value.add("id", source.id);
  value.add("title", source.kind == CaptureSource::Kind::simulator ? told_to(reader, source.title) : source.title);
  value.add("kind", kind_name(source.kind));
  if (source.kind != CaptureSource::Kind::simulator) return value;
  value.add("speeds", list_of(simulation_speeds(), [](double speed) { return Value(speed); }));
  const auto row_of = [&](const auto& preset) {
    Value row = Value::object();
    row.add("id", preset.id);
    row.add("title", told(preset.title));
    row.add("sign", told(preset.sign));
    return row;
  };
  value.add("presets", list_of(simulation::presets(), row_of));
  value.add("length_presets", list_of(length_presets(), row_of));
  value.add("motion_presets", list_of(motion_presets(), row_of));
  return value;
}

Value to_json(const CaptureState& state, const Reader& reader) {
  Value value = Value::object();
  value.add("id", static_cast<double>(state.id));
  value.add("plan", state.lengths ? Value() : Value(static_cast<double>(state.plan)));
  value.add("part", state.part);
  value.add("source", to_json(state.source, reader));
  value.add("started", state.started);
  value.add("revision", static_cast<double>(state.revision));
  value.add("state", stage_name(state.stage));
  value.add("kind", axis_kind_name(state.kind));
  value.add("unit", unit_name(state));
  value.add("targets", list_of(state.targets, [](Position x) { return Value(x.in_native()); }));
  value.add("approaches", state.approaches);
  value.add("due", state.due ? captured_approach_value(*state.due, state) : Value());
  value.add("now", state.now ? now_value(*state.now) : Value());
  value.add("taken", state.taken);
  value.add("anew", state.anew);
  value.add("readings", readings_value(state, reader));
  value.add("events",
            list_of(state.events, [&](const capture::CaptureEvent& event) { return event_value(event, reader); }));
  value.add("notices", list_of(state.notices, [&](const std::string& text) { return Value(told_to(reader, text)); }));
  value.add("so_far", state.so_far ? to_json(*state.so_far, reader) : Value());
  value.add("test", state.test ? Value(static_cast<double>(*state.test)) : Value());
  value.add("lengths", state.lengths ? lengths_value(state, reader) : Value());
  value.add("motion", state.motion ? motion_value(state, reader) : Value());
  value.add("error", state.error.empty() ? Value() : Value(told_to(reader, state.error)));
  return value;
}

}  // namespace axiometry::app
