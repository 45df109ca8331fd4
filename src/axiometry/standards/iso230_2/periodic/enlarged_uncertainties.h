// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "axiometry/standards/iso230_2/periodic/periodic.h"

namespace axiometry::iso230_2 {

inline constexpr double nothing_known_deg = 103.92304845413264;  // 360/√12: sd of an angle that may be any

/// The fit takes residuals for independent. Where they go on from target to target, noise like them has more power at
/// long periods than white noise of the same size, and what is fitted there is as much less certain.
/// For periodic.cpp alone.
void enlarge_uncertainties(PeriodicDirection& result, std::size_t targets);

/// What the shifts of runs with missing readings are uncertain by in the means (rms), in all that is stated and in what
/// counts as significant: at most, however it goes with the period. For periodic.cpp alone.
void hold_shifts(PeriodicDirection& result, double u_means, double travel);

}  // namespace axiometry::iso230_2
