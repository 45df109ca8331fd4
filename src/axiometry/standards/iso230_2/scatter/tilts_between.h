// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "axiometry/standards/iso230_2/scatter/direction_tables.h"
#include "axiometry/standards/iso230_2/scatter/outliers.h"
#include "axiometry/standards/iso230_2/scatter/run_tilts.h"

/// The parts of run_tilts.h that work on tables, for scatter.cpp. Private to standards/.
namespace axiometry::iso230_2::scatter {

/// `level`: where p is surely above it, it is 1.
TiltStudy tilt_study(const DirectionFits& fits, std::span<const double> levers, const Rounding& rounding,
                     double level = 1.0);

/// Present where chance makes such tilts in tilt_level of all tests at most, and where they make a fifth or more of
/// what is left of s_i² beside shifts.
std::optional<TiltStudy> tilts_between(const DirectionFits& fits, std::span<const double> levers,
                                       const Rounding& rounding);

/// The tables without the slopes of the runs, about the middle of the targets that each run has.
Tables untilted(Tables tables, DirectionFits fits, std::span<const double> levers);

}  // namespace axiometry::iso230_2::scatter
