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

}  // namespace axiometry::iso230_2
