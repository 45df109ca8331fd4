// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include "axiometry/base/quantity.h"
#include "axiometry/base/result.h"
#include "axiometry/model/axis.h"

/// Amounts as people write them on a command line: a number with a decimal point and its unit, "1.5um", "20 Hz", "2%".
/// Each fails, saying what was found and which units there are, on anything else, also on units of the other kind of
/// axis. Signs and sizes are for the caller to check.
namespace axiometry::app {

Result<Deviation> parse_deviation(std::string_view text, AxisKind kind);
Result<Position> parse_position(std::string_view text, AxisKind kind);
Result<Duration> parse_duration(std::string_view text);  ///< us, ms, s, min, h
Result<Duration> parse_period(std::string_view text);    ///< period of a frequency in mHz, Hz or kHz, above 0
Result<RelativeLength> parse_slope(std::string_view text, AxisKind kind);  ///< um/m or ppm; arcsec/deg
Result<double> parse_probability(std::string_view text);                   ///< "0.02" or "2%", 0 to 1
Result<Angle> parse_phase(std::string_view text);                          ///< deg
Result<Temperature> parse_temperature(std::string_view text);              ///< C
Result<ExpansionCoefficient> parse_expansion(std::string_view text);       ///< um/m/K, also without unit
Result<double> parse_bare(std::string_view text);                          ///< a number without unit

}  // namespace axiometry::app
