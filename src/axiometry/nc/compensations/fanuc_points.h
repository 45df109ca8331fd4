// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "axiometry/nc/axis_table.h"

/// Stored pitch errors of Fanuc: increments from point to point, in detection units times a magnification.
namespace axiometry::nc::fanuc {

inline constexpr unsigned largest_increment = 7;  ///< largest increment of the older controls
inline constexpr unsigned largest_of_any = 127;   ///< one signed byte
inline constexpr long long number_most = 9999;

// What the comments behind the points begin with: "(X : NOT READ …", "(DETECTION UNIT 0.1 um)".
inline constexpr std::string_view behind_axis = " : NOT READ BY THE CONTROL";
inline constexpr std::string_view before_count = "(DETECTION UNIT ";

inline constexpr std::string_view sign =
    "A positive number moves the axis in the positive direction, on its way from the point before to its own.";
inline constexpr std::string_view loading =
    "Read the part between the percent signs in as pitch error data (PWE on, EDIT), set the parameters that are listed "
    "behind it by hand, switch the control off and on, and return to the reference point. The points of several axes "
    "share one row of numbers: the number is that of the reference point, so that no other axis is overwritten. One "
    "count is the detection unit.";
inline constexpr std::string_view verified =
    "Numbers 3605, 3620 to 3627 of the parameters, that the data are increments in detection units times the "
    "magnification, that one is a signed byte, that a switch off and on is needed: reports and manuals of the 0i and "
    "15i, the header of FOCAS.";
inline constexpr std::string_view inferred =
    "That the data are written as N10000 and the point's number, that a point's number is used from the point before "
    "to it, that older controls take -7 to 7 (127 as largest number for those that take more), and the units of the "
    "parameters.";
inline constexpr std::string_view inferred_of_each_way =
    "As for one curve. That points of the negative direction count from 3626 in the same order and sign, and that 3627 "
    "is "
    "what is added at the reference point in the negative direction, in detection units without the magnification.";

Result<std::string> write(const AxisCorrection& correction, const AxisTableOptions& options, const AxisTable& table,
                          bool each_way);
Result<AxisCorrection> read(std::string_view text, const AxisTableOptions& options, bool each_way);
bool recognises(std::string_view text);

}  // namespace axiometry::nc::fanuc
