// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>

/// Sizes of units in one another, where plain numbers are reckoned with; base/quantity.h has quantities.
namespace axiometry {

inline constexpr double um_per_mm = 1000.0;
inline constexpr double mm_per_m = 1000.0;
inline constexpr double urad_per_arcsec = std::numbers::pi / 180.0 / 3600.0 * 1e6;

}  // namespace axiometry
