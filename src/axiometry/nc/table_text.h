// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/nc/axis_table.h"

/// Numbers and lines of the tables by which controls correct an axis. Internal to compensations/.
namespace axiometry::nc {

/// Fixed decimals, a decimal point, never "-0": "-12.500000".
std::string fixed_number(double x, int decimals);

/// The same without the zeros at its end, but for one: "5.0".
std::string trimmed_fixed(double x, int decimals);

/// How many of the control's units of length or angle one µm (″) of correction is: 0.001 in mm, 1/25400 in inch,
/// 1/3600 in °.
double unit_per_deviation(const AxisTableOptions& options);
/// How many mm (°) the control's unit of length (angle) is: 1, 25.4, 1.
double position_per_unit(const AxisTableOptions& options);

/// A nanometre and better: 6 decimals of mm and °, 8 of inch.
int table_decimals(const AxisTableOptions& options);

struct TableLine {
  std::size_t number = 0;  ///< number of the line, from 1
  std::string_view text;   ///< line without its end
};
/// Lines as they stand, empty ones too; a last one without content is none.
std::vector<TableLine> lines_of(std::string_view text);

/// All numbers of a text that holds nothing else, separated by blanks or by any character of `separators`.
std::optional<std::vector<double>> numbers_of(std::string_view text, std::string_view separators = "");

/// Fails, naming the limit, where the positions are more, or not as evenly spaced, as the table allows, or the kind of
/// axis is one that it does not take.
Result<void> check_limits(const AxisCorrection& correction, const AxisTable& table);

/// Fails, where the limits name an origin, unless the reference point lies where the table needs it and the positive
/// curve (of one curve: it) is 0 there; beyond the positions: at the nearest.
Result<void> check_origin(const AxisCorrection& correction, const AxisTable& table, double reference);

/// Fails on a name of an axis that is no word of letters, digits, _ and the characters of `beside` (at most 32).
Result<void> check_axis_word(const AxisTableOptions& options, std::string_view beside = "");

/// Whether an axis that a table names is the one that is asked for, whatever its capitals. Where none was told, it is
/// from then on: a table is of one axis.
bool is_axis_named(std::string_view found, AxisTableOptions& options);
/// Fails where a line of a table names another axis.
Result<void> check_axis_named(std::string_view found, AxisTableOptions& options, const TableLine& line);

/// What one count stands for, as comments of tables say it: "0.1 um".
std::string count_text(const AxisTableOptions& options);
/// Fails where such a comment says another amount than the options; where none was told, it is that of the comment.
Result<void> check_count_text(std::string_view said, AxisTableOptions& options, const TableLine& line);

/// Whether the positions of a rotary axis are a whole turn.
bool is_whole_turn(const AxisCorrection& correction);

/// A text as lines of comment, wrapped: "; …".
std::string comment_lines(std::string_view mark, std::string_view text);

/// A table with a warning before the comment that says what its sign does, as comment of the same mark. A table without
/// that comment, whose format has none, stays as it is, and so does one without a warning.
std::string with_warning(std::string table, std::string_view sign, std::string_view warning);

/// NAME(INDEX,INDEX) = VALUE, the indices in round or square brackets or none, blanks anywhere between.
struct Assignment {
  std::string_view name;
  std::vector<std::string_view> indices;
  std::string_view value;
};
std::optional<Assignment> assignment_of(std::string_view line);

/// A whole number with or without sign, of at most 9 digits.
std::optional<long long> whole_number(std::string_view text);

/// "found TEXT, expected WHAT", at this line.
std::unexpected<Error> refused(const TableLine& line, std::string_view expected);

/// Of positions first, first + step, …, by the values beside them, which are in the unit of corrections.
Result<AxisCorrection> even_correction(AxisKind kind, double first, double step, std::vector<double> up,
                                       std::vector<double> down);

/// The spacing where all are the same within what decimals of the control hold; nothing else.
std::optional<double> common_step(const std::vector<double>& positions);

/// Found as whole multiples of `resolution`: round(value/resolution), ties away from 0.
long long counts(double value, double resolution);

/// Fails where a control that has one curve would get two.
Result<void> check_one_curve(const AxisCorrection& correction);

/// What the axis falls back by at a reversal, c↑ − c↓, µm or ″; below 0 where it goes too far. Fails where it differs
/// from place to place.
Result<double> backlash_of(const AxisCorrection& correction);

/// The comment that tells the number beside a table of one curve: "; MD32450 = its value while the axis was measured +
/// 0.003700". A table that is read off a control has lost it, so that no earlier value can be counted from.
std::string backlash_line(std::string_view mark, const AxisTable& table, double backlash,
                          const AxisTableOptions& options);
/// The number of that comment, µm or ″; 0 without one. Fails on a second one.
Result<double> backlash_in(std::string_view text, std::string_view mark, const AxisTable& table,
                           const AxisTableOptions& options);

}  // namespace axiometry::nc
