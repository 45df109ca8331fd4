// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "axiometry/app/live/lengths/length_task.h"
#include "axiometry/base/json/json.h"
#include "axiometry/capture/values/value_listener.h"
#include "axiometry/model/motion_series.h"

/// What is noted of a capture that becomes a table, and no test, beside what it receives: its order, and what it came
/// to.
namespace axiometry::app {

struct LengthOrder {
  LengthPlanKind kind = LengthPlanKind::lines;
  std::string plan;     ///< SHA-256 of its file in the archive
  std::string plan_id;  ///< LengthTask::plan_id(): captures of one measurement have the same
  std::string title;    ///< title of the part
  std::size_t stops = 0;
};

/// Of a straightness or a rotation.
struct MotionOrder {
  MotionName error;
  capture::StopSign sign = capture::StopSign::keys;
};

/// Files of the archive by their SHA-256; empty where there is none.
struct TableEnd {
  std::string stage;  ///< stage_name()
  std::string raw;
  std::string times;  ///< file of the times of arrival, beside the raw recording
  std::string keys;   ///< what was said at the stops of a motion, stop_marks.h
  std::string table;
  std::size_t found = 0;           ///< lengths or readings in the table
  std::vector<std::string> notes;  ///< sentences, of FoundTable
  std::string error;
};

json::Value to_json(const LengthOrder& order);
json::Value to_json(const MotionOrder& order);
json::Value to_json(const TableEnd& end);

/// Nothing where it is not what was written.
std::optional<LengthOrder> length_order_from(const json::Value& value);
std::optional<MotionOrder> motion_order_from(const json::Value& value);
std::optional<TableEnd> table_end_from(const json::Value& value);

}  // namespace axiometry::app
