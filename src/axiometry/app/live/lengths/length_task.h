// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "axiometry/app/live/lengths/found_table.h"
#include "axiometry/app/recordings/capture_session.h"
#include "axiometry/base/json/json.h"
#include "axiometry/base/result.h"
#include "axiometry/base/vector3.h"
#include "axiometry/model/tracking.h"
#include "axiometry/volumetric/plan/calibration_plan.h"

/// What a live capture of lengths waits for: a part of the plan of a tracking interferometer.
namespace axiometry::app {

enum class LengthPlanKind {
  lines,   ///< a tracking plan; its parts are its lines, and together they are part 0
  volume,  ///< a volumetric plan; its parts are its runs, from 1
};
std::string_view kind_name(LengthPlanKind kind);  ///< "lines", "volume"
std::optional<LengthPlanKind> length_plan_kind(std::string_view name);

/// Where the reflector is to come to rest.
struct TaskStop {
  std::string group;  ///< "measuring line xy", "part 3"
  std::string name;   ///< name within it: "target 1↑ run 1", "point 17"
  Vector3 reflector_mm;
  bool begins_segment = false;  ///< the plan expects that the beam is lost on the way there
};

/// A part that can be captured.
struct TaskPart {
  std::size_t part = 0;
  std::string title;
  std::size_t stops = 0;
};

class LengthTask {
 public:
  /// Of {"plan": …} as the workbench takes plans: fails as requested_lines() and given_calibration() do, on a part that
  /// the plan does not have and on one without stops.
  static Result<LengthTask> make(LengthPlanKind kind, const json::Value& body, std::size_t part);

  LengthPlanKind kind() const;
  std::size_t part() const { return part_; }
  std::string title() const;            ///< "measuring line xy", "all 7 lines", "part 3 (station A, tool short)"
  std::vector<TaskStop> stops() const;  ///< stops in the order in which they come
  std::size_t stop_count() const;
  const std::vector<TaskPart>& parts() const { return parts_; }  ///< all of the plan, this one too

  /// The whole plan, as a file of it; read again it gives the same.
  json::Value plan_value() const;
  /// SHA-256 of the plan but for its date, so that a plan that is made again on another day is the same one.
  std::string plan_id() const;

  /// The lines of this part as a plan of their own, and the whole plan; nullptr for the other kind of plan.
  const TrackingPlan* lines() const { return lines_ ? &*lines_ : nullptr; }
  const TrackingPlan* all_lines() const { return std::get_if<TrackingPlan>(&plan_); }
  const volumetric::CalibrationPlan* volume() const { return std::get_if<volumetric::CalibrationPlan>(&plan_); }

  /// Fails on options that have no meaning for lengths, a part among them, and as CaptureSession::open() does.
  Result<CaptureSession> open(const CaptureOptions& options) const;
  /// What such a session has found. Fails as captured_lengths() and part_lengths() do: where another part of a
  /// volumetric plan fits far better, too.
  Result<FoundTable> lengths(const CaptureSession& session) const;

 private:
  using AnyPlan = std::variant<TrackingPlan, volumetric::CalibrationPlan>;
  LengthTask(AnyPlan plan, std::size_t part) : plan_(std::move(plan)), part_(part) {}

  AnyPlan plan_;
  std::size_t part_;
  std::optional<TrackingPlan> lines_;
  std::vector<TaskPart> parts_;
};

struct CapturedTable {
  std::string name;  ///< name of the capture, for comments: "capture 7"
  std::string bytes;
};

/// The tables of several captures of one plan as one: the lengths of a line, or of a station with a tool, are those of
/// the last table that has any of them; what is left out so is told in comments. Fails on a table that cannot be read.
Result<std::string> joined_tables(const LengthTask& plan, const std::vector<CapturedTable>& tables);

}  // namespace axiometry::app
