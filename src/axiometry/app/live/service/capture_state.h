// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "axiometry/app/files/reader.h"
#include "axiometry/app/live/disk/table_order.h"
#include "axiometry/app/live/service/caught_lengths.h"
#include "axiometry/app/live/sources/capture_source.h"
#include "axiometry/app/workbench/workbench_values.h"
#include "axiometry/base/json/json.h"
#include "axiometry/capture/capture_result.h"
#include "axiometry/capture/standstill.h"
#include "axiometry/store/records.h"

/// What can be said about a capture at one moment.
namespace axiometry::app {

/// Counts every change of a capture's state, from 1.
using CaptureRevision = std::uint64_t;

struct StampedReading {
  CaptureRevision revision = 0;  ///< revision with which it came
  capture::CapturedReading reading;
};

/// Of a capture of lengths, in place of targets and readings.
struct LengthsState {
  LengthOrder order;
  std::optional<std::size_t> due;                           ///< the stop that comes next, from 0
  CaptureRevision caught_at = 0;                            ///< revision with which the following changed
  std::shared_ptr<const std::vector<CaughtLength>> caught;  ///< nullptr where it is known already
  std::vector<std::size_t> broken_before;  ///< stops before which the beam was broken though the plan keeps it
};

/// Of a straightness or a rotation, in place of readings of positions.
struct MotionState {
  MotionOrder order;
  std::optional<MotionUnit> unit{};  ///< unit of all values; nothing before the first reading
  std::optional<double> now{};       ///< the last reading
  bool is_reading = false;           ///< whether a window behind a key or a trigger is open
  bool waits_for_key = false;        ///< whether somebody must say whose a late reading is
  CaptureRevision read_at = 0;       ///< revision with which the following changed
  std::shared_ptr<const std::vector<capture::PlannedValue>> values{};  ///< nullptr where they are known already
};

struct CaptureState {
  enum class Stage {
    waiting,  ///< no byte has come yet
    running,
    complete,     ///< every approach has come or was missed
    stopped,      ///< ended by a person, or because the source came to its end
    failed,       ///< what came could not be understood, or not be kept
    interrupted,  ///< the program ended while it ran; what came is on the disk
  };

  store::Id id = 0;
  store::Id plan = 0;
  std::size_t part = 1;
  CaptureSource source;
  std::string started;  ///< RFC 3339, UTC
  CaptureRevision revision = 0;
  Stage stage = Stage::waiting;
  AxisKind kind = AxisKind::linear;
  std::vector<Position> targets;
  std::size_t approaches = 0;  ///< approaches of the plan
  std::optional<Approach> due;
  std::optional<capture::StandstillDetector::Whereabouts> now;
  std::size_t taken = 0;                 ///< readings so far
  std::vector<StampedReading> readings;  ///< those that were asked for
  bool anew = false;                     ///< they are all there are: earlier ones hold no longer
  std::vector<capture::CaptureEvent> events;
  std::vector<std::string> notices;
  std::shared_ptr<const Outcome> so_far;
  std::optional<store::Id> test;  ///< it was kept as
  std::optional<LengthsState> lengths{};
  std::optional<MotionState> motion{};
  std::optional<TableEnd> came_to{};  ///< table of lengths or readings, when it has ended
  std::string error;
};

std::string_view stage_name(CaptureState::Stage stage);
std::optional<CaptureState::Stage> stage_named(std::string_view name);
bool has_ended(CaptureState::Stage stage);
std::string_view table_role(const CaptureState& state);  ///< role of the file that came_to has: "lengths" or "readings"

/// Capture and Source of apps/server/openapi.json.
json::Value to_json(const CaptureState& state, const Reader& reader);
json::Value to_json(const CaptureSource& source, const Reader& reader);

}  // namespace axiometry::app
