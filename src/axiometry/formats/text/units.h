// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "axiometry/base/result.h"
#include "axiometry/model/axis.h"

/// Units in which files state positions and deviations, and the step from them to the model's native
/// units (mm and µm, ° and ″).
namespace axiometry::formats {

struct Unit {
  std::string_view name;    ///< name in the JSON format and column names: "um"
  std::string_view symbol;  ///< symbol that people read: "µm"
  AxisKind kind;            ///< kind of the axes that it serves
  double factor;            ///< one unit is factor / divisor µm or ″
  double divisor;
};

std::span<const Unit> units();

/// By name, symbol or a usual spelling ("micron", "μm" with either mu, "arcseconds"), in any case; nullptr
/// when unknown.
const Unit* find_unit(std::string_view spelling);

/// "um, mm, nm, …", for messages.
std::string unit_names();

Position position_in(const Unit& unit, double x);
Deviation deviation_in(const Unit& unit, double x);

/// What the readings of a file are: deviations, or measured positions from which the target is taken.
enum class Measured { deviation, position };

struct ReadingRule {
  Measured measured = Measured::deviation;
  const Unit* unit = nullptr;
};

/// The deviation x_ij in native units of one reading. Fails beyond 1e9 native units (a kilometre), and on
/// measured positions of a rotary axis more than half a turn from the target: such a position counts
/// another turn, which no reader may correct on its own.
Result<double> native_deviation(const ReadingRule& rule, Position target, double value);

/// Fails when the units of targets and readings belong to different kinds of axes.
Result<AxisKind> kind_of(const Unit& target_unit, const Unit& reading_unit);

}  // namespace axiometry::formats
