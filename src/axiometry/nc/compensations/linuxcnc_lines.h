// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "axiometry/nc/axis_table.h"

/// The two types of LinuxCNC's COMP_FILE: lines of a nominal position and two numbers, forward and reverse.
namespace axiometry::nc::linuxcnc {

inline constexpr std::size_t points_most = 256;  ///< emcmot's EMCMOT_COMP_SIZE
inline constexpr std::string_view loading =
    "Name it COMP_FILE in the joint's section of the INI file, with COMP_FILE_TYPE, and start LinuxCNC anew. The "
    "joint's BACKLASH does nothing then. A reversal is driven with half of the joint's limits of velocity and "
    "acceleration: leave it room in STEPGEN_MAXVEL and STEPGEN_MAXACCEL or the like. After homing nothing is added "
    "until "
    "the joint has passed a position of the table (seen on 2.9): drive it once over the whole of it.";

enum class Type { positions, trims };

Result<std::string> write(const AxisCorrection& correction, const AxisTableOptions& options, const AxisTable& table,
                          Type type);
Result<AxisCorrection> read(std::string_view text, const AxisTableOptions& options, Type type);

}  // namespace axiometry::nc::linuxcnc
