// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "axiometry/base/result.h"
#include "axiometry/model/axis.h"
#include "axiometry/model/tracking.h"

/// How a set-up of a tracking interferometer is asked for on the command line. Lengths are in mm unless they carry a
/// unit: "0.2m", "300um". Each fails on anything else, saying what was found and what was expected.
namespace axiometry::app {

struct LowHigh {
  double low = 0.0;
  double high = 0.0;
};

/// "X=0:500,Y=0:400,Z=-300:0": all three, in any order.
Result<TravelBox> parse_travel_box(std::string_view text);

/// Periods of X, Y and Z: "10" for all, or "X=10,Z=5", mm.
Result<std::array<std::optional<Position>, 3>> parse_periods(std::string_view text);

/// "0.2m:15m" or "200:15000", mm.
Result<LowHigh> parse_range(std::string_view text);

/// "-20:80", °; the unit "deg" may be given.
Result<LowHigh> parse_elevation(std::string_view text);

/// "[NAME=]box:X,Y,Z:X,Y,Z" (two opposite corners), "[NAME=]sphere:X,Y,Z:RADIUS" or
/// "[NAME=]cylinder:X,Y,Z:RADIUS:HEIGHT" (middle of its lower end; upright), mm.
Result<Obstacle> parse_obstacle(std::string_view text);

/// "0.2um+0.3um/m": U = a + b·L, k = 2. The second part may be left out. Or a kind of tracking::tracker_kinds() by its
/// name, "leica-at901": what it states of changes of length, ":adm" behind it of absolute ones.
Result<RangingUncertainty> parse_ranging(std::string_view text);

/// A standard uncertainty with its unit, "0.5um"; 0 or more.
Result<Length> parse_length_sigma(std::string_view text);

}  // namespace axiometry::app
