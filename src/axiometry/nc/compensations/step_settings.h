// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "axiometry/nc/axis_table.h"

/// Controls without a table: a scale factor, as steps per mm or °, and one backlash.
namespace axiometry::nc::steps {

/// How a control spells them for one axis.
struct Spelling {
  std::string_view comment;         ///< ";"
  std::string steps;                ///< what stands before the number: "$100="
  std::string backlash;             ///< "$160="
  std::vector<std::string> beside;  ///< lines that switch it on
};

inline constexpr std::string_view sign =
    "More steps per unit move the axis further. A positive backlash is driven more at each reversal: after one into "
    "the "
    "negative direction the axis stands further in the negative direction.";
inline constexpr std::string_view inferred =
    "That a backlash is made up for in whole steps, which is left out of what is predicted.";

/// Without the steps per unit of now (AxisTableOptions) the scale is left out, and the text says so. Fails on a
/// backlash below 0, or one that differs from place to place.
Result<std::string> write(const AxisCorrection& correction, const AxisTableOptions& options, const AxisTable& table,
                          const Spelling& spelling);

/// A straight line, 0 at the reference point, over the range that the head tells (a metre about it without one).
Result<AxisCorrection> read(std::string_view text, const AxisTableOptions& options, const Spelling& spelling);

/// Which of X, Y, Z, A, B, C the axis is, 0 to `count` − 1. Fails on another.
Result<unsigned> axis_number(const AxisTableOptions& options, std::size_t count);

}  // namespace axiometry::nc::steps
