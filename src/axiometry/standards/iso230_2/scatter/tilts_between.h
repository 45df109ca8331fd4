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

/// `tables` without the slopes that the runs of `seen` have, which are the same readings but for some that lack there.
Tables untilted(Tables tables, Tables seen, std::span<const double> levers, std::size_t runs);

}  // namespace axiometry::iso230_2::scatter
