// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/motion_series.h"
#include "axiometry/model/plan.h"
#include "axiometry/model/test.h"

/// Readings of straightness, roll, pitch or yaw as a table: one row for each reading.
namespace axiometry::formats {

struct MotionFile {
  std::vector<MotionReading> readings;
  std::string_view unit_in_file{};    ///< "mm", where that is another than `unit`; empty where it is the same
  MotionUnit unit = MotionUnit::um;   ///< lengths as µm, ″ and ° as ″, µrad, mrad and rad as µrad
  std::optional<MotionName> error;    ///< stated by `# error: EYX` or the column's name
  std::optional<ReadingSense> sense;  ///< stated by `# positive: -Y`
  Metadata metadata;                  ///< metadata of `# key: value` lines
  bool may_be_positions = false;      ///< lengths in a column "deviation", as those of positions are called
  std::string turn{};                 ///< "roll", "pitch" or "yaw", where the column is called so
  std::vector<SourceRemark> remarks{};
};

/// `position_mm,run,direction,straightness_um` in any order of columns and rows, separated by comma, semicolon or tab,
/// with decimal point or, but for the comma, decimal comma. `position` (or `target`) in any unit of length. The
/// reading is the column `straightness` (a length), `angle`, `roll`, `pitch`, `yaw` (an angle), `deviation` or
/// `reading` (either), or the name of the error: `EYX_um`, `EAX_urad`. `direction` in the usual words and signs.
/// Without `run` the approaches to a position in a direction count themselves in the order of the rows; without
/// `direction` all are taken as positive approaches, with a remark, unless some runs rise and others fall. Lines that
/// begin with # and hold `error`, `positive` (which way the readings are) or a known key and a colon are metadata,
/// others comments; a key that nearly is one of these is refused. An empty cell, "-" or "NA" is a reading that was not
/// taken: a remark names the positions that have none at all. Columns `time`, `scatter`, `drift` and `samples`, which
/// a capture writes beside its readings, are passed over, others with a remark.
///
/// Fails, with line and column, on a column that is missing, there twice or without a unit of its kind, on a second
/// error or a second `positive` that contradicts the first, on a position twice where neither run nor direction tell
/// which is which, on cells that are no finite number, rows that are cut off, and as decoded_text() does. What belongs
/// together is MotionSeries::make()'s question. Time grows as n log n with the rows.
Result<MotionFile> read_motion_csv(std::string_view bytes);

/// The same of readings alone, one row for each approach in the order in which a plan takes them (approaches() of
/// model/plan.h): position, direction and run are the plan's, its machine's name stands where the file has none. A cell
/// that is empty keeps its place. Fails also on a column of position, direction or run, which might say otherwise, on
/// more or fewer rows than the plan has approaches, as check_error_of_plan() does of the file's error, and on a plan of
/// a rotary axis, of a line in space or with further plans. Needs a sound plan.
Result<MotionFile> read_planned_motion(std::string_view bytes, const Plan& plan);

/// Fails on an error of another axis than the plan's, on one that is not among those that the plan is made for, and
/// where no error is known on a plan that is made for other kinds of errors alone. A plan that names no error fits all:
/// it is one of positions, and the targets and the cycle are the same.
Result<void> check_error_of_plan(const std::optional<MotionName>& error, MotionUnit unit, const Plan& plan);

/// The only error of this kind that a plan is made for; nothing of several.
std::optional<MotionName> error_of_plan(const Plan& plan, MotionUnit unit);

/// A test of positions must not be read out of such a table: its E, R and A would be taken for those of the positions.
/// Fails on a beginning of a file that names a straightness or a rotation: by `# error: EYX` above its first row, or by
/// the only column of readings beside positions, "straightness", "roll", "pitch", "yaw" or "EYX" with a unit. A column
/// "deviation", "reading" or "angle" alone says nothing. What cannot be decoded is nobody's table.
Result<void> check_no_other_error(std::string_view head);

}  // namespace axiometry::formats
