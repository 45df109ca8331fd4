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

/// How many of the control's units of length or angle one µm (″) of correction is: 0.001 in mm, 1/25400 in inch,
/// 1/3600 in °.
double unit_per_deviation(const AxisTableOptions& options);
/// How many mm (°) the control's unit of length (angle) is: 1, 25.4, 1.
double position_per_unit(const AxisTableOptions& options);

/// A nanometre and better: 6 decimals of mm and °, 8 of inch.
int table_decimals(const AxisTableOptions& options);

struct TableLine {
  std::size_t number = 0;  ///< from 1
  std::string_view text;   ///< without its end
};
/// Lines as they stand, empty ones too; a last one without content is none.
std::vector<TableLine> lines_of(std::string_view text);

/// All numbers of a text that holds nothing else, parted by blanks or by any character of `parting`.
std::optional<std::vector<double>> numbers_of(std::string_view text, std::string_view parting = "");

/// Fails, naming the limit, where the positions are more, or not as evenly spaced, as the table allows, or the kind of
/// axis is one that it does not take.
Result<void> check_limits(const AxisCorrection& correction, const AxisTable& table);

/// The spacing where all are the same within what decimals of the control hold; nothing else.
std::optional<double> common_step(const std::vector<double>& positions);

/// Found as whole multiples of `resolution`: round(value/resolution), ties away from 0.
long long counts(double value, double resolution);

/// Fails where a control that has one curve would get two.
Result<void> check_one_curve(const AxisCorrection& correction);

}  // namespace axiometry::nc
