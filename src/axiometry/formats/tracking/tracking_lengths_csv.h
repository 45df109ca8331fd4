// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/test.h"
#include "axiometry/model/tracking.h"

/// Lengths that a tracking interferometer showed along the lines of a plan, as a table: one row for each reading.
namespace axiometry::formats {

struct LengthRow {
  LengthReading reading;  ///< a reading in program order has no line and approach, which its place tells
  bool missing = false;   ///< whether no reading was taken there, in program order
  double time_s = std::numeric_limits<double>::quiet_NaN();
  TextPosition at{};
};

struct TrackingLengths {
  bool in_program_order = false;  ///< the table has no labels: rows belong to the plan's approaches in their order
  std::vector<LengthRow> rows;
  Metadata metadata;                    ///< metadata of `# key: value` lines
  std::vector<SourceRemark> remarks{};  ///< the encoding, columns passed over
};

/// The head of the long table as we write it, but for segments and times.
inline constexpr std::string_view tracking_lengths_head = "line,target,direction,run,length_difference_mm";

/// Two kinds of tables, separated by comma, semicolon or tab, with decimal point or, but for the comma, decimal comma:
/// - long: `line,target,direction,run,length_difference_mm` in any order of columns and rows. `target` is the number of
///   the target from 1; `position_mm` (or `target_mm`) in its place is the position, within 0.05 mm and a quarter of
///   the smallest interval of a target of the plan. `direction` in the usual words and signs; it may be left out where
///   the plan has one direction. Without `run` approaches to a target count themselves in the order of the rows.
/// - in the order of the program: `length_difference_mm` (or `length_mm`) and none of `line`, `target`, `direction`,
///   `run`. An empty cell, "-" or "NA" is a reading that was not taken.
/// In both `segment` (a whole number from 0) and `time_s` may stand; other columns are passed over with a remark. Units
/// of length are those of other tables (`length_difference_um`, `length [m]`). Lines that begin with # and hold a known
/// key and a colon are metadata, others comments.
///
/// Fails, with line and column, on a column that is missing, there twice or without unit, on lines and targets that the
/// plan does not have, a reading given twice (naming the first), cells that are no finite number, rows that are cut
/// off, and as decoded_text() does. Whether the lengths fit the plan is another question
/// (tracking/lengths/reading_order.h).
Result<TrackingLengths> read_tracking_lengths(std::string_view bytes, const TrackingPlan& plan);

/// The long table of readings at approaches of the plan, with `segment` where one is not 0 and `time_s` (three
/// decimals) where times are given, one for each. read_tracking_lengths() reads the same readings back.
std::string write_tracking_lengths(std::span<const LengthReading> readings, std::span<const double> times_s = {});

/// Whether a file with this beginning holds a continuous recording of lengths, and not such a table. A header with a
/// column of lengths is one of a table, unless the rows below it have times that follow each other faster than an axis
/// can stop (a quarter of the shortest dwell of the plan) and none of them says its line; all else that a layout of
/// continuous recordings (formats/recording.h) recognises is a recording.
bool is_length_recording(std::string_view head, const TrackingPlan& plan);

}  // namespace axiometry::formats
