// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "axiometry/base/result.h"
#include "axiometry/model/axis_correction.h"

/// Tables by which a control corrects one axis: written, and read back by the control's own rule. One .cpp in
/// compensations/ per control, each with one `const AxisTable <stem>_axis_table = {…}`; the build collects them.
namespace axiometry::nc {

/// What stands in a table beside its values, or must be known of the control to read them.
struct AxisTableOptions {
  std::string axis = "X";     ///< as the control names it
  std::string output_axis{};  ///< axis that is moved while `axis` stands at the positions; empty: `axis` itself
  AxisKind kind = AxisKind::linear;
  bool in_inch = false;         ///< whether the control measures a linear axis in inches
  unsigned number = 0;          ///< number of the table, encoder, joint or first point, as the control counts
  double reference = 0.0;       ///< machine position of the reference point, mm or °
  double resolution = 1.0;      ///< what one count stands for, µm or ″ (detection unit, encoder step)
  unsigned magnification = 1;   ///< factor by which the control multiplies the table's numbers
  unsigned largest = 0;         ///< number that the control takes in its table; 0: the least that is known of its kind
  double step = 0.0;            ///< spacing of a table that is read and does not say it, mm or °; 0: it says it
  double steps_per_unit = 0.0;  ///< what the control drives now, steps per mm or °; 0: not told
  bool turned_sign = false;     ///< the control's sign is the other one than was inferred of it
  std::string warning{};        ///< ASCII text before the other comments of a table that is written; may be empty

  bool axis_told = true;        ///< else a table that is read may be of any one axis
  bool resolution_told = true;  ///< else a table that says what one count is is read by that
};

/// What one count may stand for, µm or ″.
inline constexpr double resolution_least = 1e-6, resolution_most = 1e4;

/// Where the reference point is, at which the correction is 0.
enum class TableOrigin {
  anywhere,
  on_grid,  ///< a whole number of steps from the positions, in or out of them
  first,
  last,
};

/// How many positions, and where. 0: nothing is known to limit it.
struct AxisTableLimits {
  std::size_t points = 0;  ///< 1: no table, a backlash alone; 2: a scale factor and a backlash
  bool equidistant = false;
  double step_native = 0.0;  ///< the only spacing that there is, mm
  TableOrigin origin = TableOrigin::anywhere;
  bool zero_upwards = false;  ///< whether of two curves the positive one is 0 at the reference point, not their mean
  bool closes = false;        ///< whether values of a rotary axis a whole turn apart are one
  bool linear = true, rotary = true;
  bool cross_only = false;  ///< it moves another axis than the one at whose positions it stands, never that one
  bool rolls_over = false;  ///< whether it goes on beyond either end, over one step, to the value of the other end
};

/// Which of AxisTableOptions a control has at all.
struct AxisTableUses {
  bool number = false;
  bool resolution = false;
  bool magnification = false;
  bool largest = false;
  bool steps_per_unit = false;
  bool output_axis = false;
  bool turned_sign = false;  ///< its sign was inferred and may be the other one
  bool inch = true;          ///< it may count in inches; else in the one unit that its format has
  bool told_step = false;    ///< whether the spacing of a table that is read may be a parameter of the control alone
};

struct AxisTable {
  std::string_view id;         ///< "linuxcnc", for --for
  std::string_view title;      ///< "LinuxCNC"
  std::string_view extension;  ///< ending of its files: ".comp"
  TableCurves curves = TableCurves::both_ways;
  AxisTableLimits limits;
  AxisTableUses uses{};
  std::string_view sign;      ///< what a positive number in the file does, a sentence
  std::string_view loading;   ///< how the table gets into the control and becomes active, sentences
  std::string_view verified;  ///< what of this format was seen in a file, a source or a manual
  std::string_view inferred;  ///< what was not; "" where nothing

  /// What a positive number does if the sign that was inferred is the other one; "" where it is verified.
  std::string_view turned_sign{};
  /// Of a control with one curve that has a number for the reversal beside it: how it calls that; "" without one.
  std::string_view backlash{};

  /// The file. Fails on what the control cannot hold, saying what it can. Called by write_table() alone.
  Result<std::string> (*write)(const AxisCorrection& correction, const AxisTableOptions& options);

  /// What the control adds with this file loaded, by its own rule and rounded as the file has it. Written apart from
  /// `write`, so that one proves the other. Fails on what the control would not take, naming the line. Called by
  /// read_table() alone.
  Result<AxisCorrection> (*read)(std::string_view text, const AxisTableOptions& options);

  /// Whether a text can be of this kind, by its first lines; nullptr: it has nothing to be known by.
  bool (*recognises)(std::string_view text) = nullptr;

  /// What is wrong with a file in a form that earlier versions of this program wrote and that is not read any more, as
  /// a refusal; "" of any other. nullptr: there was no other form.
  std::string_view (*former)(std::string_view text) = nullptr;
};

/// What a positive number of such a file does.
std::string_view sign_of(const AxisTable& table, const AxisTableOptions& options);

/// The file of a control; of a turned sign every number has the other one. Fails as the table's `write`.
Result<std::string> write_table(const AxisTable& table, const AxisCorrection& correction,
                                const AxisTableOptions& options);

/// What the control adds with a file. Fails as the table's `read`; on a mark of the byte order at the head, which
/// controls take for a part of the first line, a NUL byte, and a file that says itself to have the other sign.
Result<AxisCorrection> read_table(const AxisTable& table, std::string_view text, const AxisTableOptions& options);

/// An option by the name of its flag and of its member in requests.
struct NamedTableOption {
  std::string_view name;
  bool AxisTableUses::*used;
  bool (*is_given)(const AxisTableOptions& options);  ///< differs from what it is when nobody says anything
};
std::span<const NamedTableOption> named_table_options();

/// Fails on an option that is given for a control that has no use for it: nothing that somebody says is passed over. So
/// does a turned sign where the sign is verified.
Result<void> check_used(const AxisTable& table, const AxisTableOptions& options);

/// Every table, in alphabetical order of the source files (generated).
std::span<const AxisTable* const> axis_table_table();

/// Fails with the ids that there are; capitals do not matter, and "_" is as good as "-".
Result<const AxisTable*> axis_table_named(std::string_view id);

}  // namespace axiometry::nc
