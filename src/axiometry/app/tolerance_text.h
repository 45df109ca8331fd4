// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/standards/iso230_2_tolerance.h"

namespace axiometry::app {

/// A limit as written by the user, before the kind of the axis is known: "A=10um", "R_up=0.003mm".
struct ToleranceText {
  const iso230_2::ParameterInfo* parameter = nullptr;
  double value = 0.0;
  std::string unit;
};

/// Fails on an unknown parameter, a missing or unknown unit, a limit that is no number or negative.
Result<ToleranceText> parse_tolerance(std::string_view text);

/// The limits in the unit of the axis. Fails when a length is given for a rotary axis or an angle for
/// a linear one.
Result<std::vector<iso230_2::Tolerance>> tolerances_for(AxisKind kind, const std::vector<ToleranceText>& texts);

}  // namespace axiometry::app
