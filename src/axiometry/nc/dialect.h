// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "axiometry/base/result.h"
#include "axiometry/model/plan.h"
#include "axiometry/nc/point_tour.h"

/// Part programs that walk a plan. One .cpp in dialects/ per control, each with one `const Dialect <stem>_dialect =
/// {…}`; the build collects them (docs/howto/add-a-dialect.md).
namespace axiometry::nc {

enum class LengthUnit { mm, inch };

/// How the program is to be written; the plan says what it does.
/// What speaks against calling a plan one after its standard, told in a comment.
struct PlanStanding {
  std::size_t departures = 0;
  std::size_t missing = 0;  ///< points that are open
};

struct ProgramOptions {
  LengthUnit unit = LengthUnit::mm;             ///< unit of linear axes; angles are in degrees always
  bool unrolled = false;                        ///< no loops and variables even where the control has them
  std::optional<unsigned> trigger_m_code = {};  ///< M code put out at each target after half the dwell
  std::optional<unsigned> number = {};          ///< program number where the control has one
  int decimals = 4;  ///< decimals of coordinates in the program's unit, 0 to 6; more where targets need them
  bool block_numbers = true;
  bool stop_at_start = false;             ///< a stop for the operator to set the instrument, before the first target
  bool stop_at_lines = false;             ///< likewise before the first target of each plan: the beam is to be found
  std::optional<Duration> duration = {};  ///< time that all plans take, as their sheets estimate it, told in a comment
  std::optional<double> acceleration = {};  ///< acceleration that this holds for, mm/s² or °/s²
  PlanStanding standing = {};               ///< of a single plan
  std::string_view title = {};              ///< title of a program of several plans, told in a comment
  std::string frame = "active";             ///< name of the frame that positions are coordinates of (nc/work_frame.h)
  bool rollover = false;                    ///< whether the rotary axis knows its position within one turn only
};

struct Dialect {
  std::string_view id;         ///< "linuxcnc", for --dialect
  std::string_view title;      ///< "LinuxCNC"
  std::string_view extension;  ///< ending of its program files: ".ngc"
  std::string_view manual;     ///< Markdown: what the program assumes of the control, an example
  /// The axis names the control knows, as a person reads them: "X Y Z A B C U V W".
  std::string_view axes;
  bool has_loops = false;  ///< whether loops and variables are written unless unrolled

  /// One program that walks these plans, one after another. Needs sound plans. Fails on none, on several of which one
  /// is no line in space (between them nobody would know where its other axes stand), on an axis that the control
  /// cannot name, a position, feed or dwell beyond its range, and an option that it does not know, saying what it has
  /// instead.
  Result<std::string> (*write)(std::span<const Plan> plans, const ProgramOptions& options);

  /// One program of a tour. Fails likewise, and on no reading.
  Result<std::string> (*write_tour)(const PointTour& tour, const ProgramOptions& options);
};

/// Every dialect, in alphabetical order of the source files (generated).
std::span<const Dialect* const> dialect_table();

/// nullptr when there is none of that id; capitals do not matter, and "_" is as good as "-".
const Dialect* find_dialect(std::string_view id);

}  // namespace axiometry::nc
