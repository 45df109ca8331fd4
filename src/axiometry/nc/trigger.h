// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "axiometry/base/result.h"

/// The M code that is put out at each target: only the coolant, an output of its own, or what neither RS-274-D nor its
/// maker has given away; the builder of the machine may have. An output that stays on is switched off before the axis
/// moves on: an instrument sees its rise, and there is one at each target only where there is a fall behind each.
namespace axiometry::nc {

/// From `first` to `last`; none when `last` is less. What stays on is switched off by `off` to `last_off`, one after
/// another, the last for all that are left; 0 where it ends by itself, or only the builder of the machine knows.
struct MCodes {
  unsigned first = 1;
  unsigned last = 0;
  unsigned off = 0;
  unsigned last_off = 0;
};

inline constexpr MCodes coolant = {7, 8, 9, 9};

/// What a control may be told for a trigger: an output of its own, the coolant, or what neither RS-274-D nor its maker
/// has given away.
using TriggerCodes = std::array<MCodes, 5>;

/// Fails on a code that is not among them, saying what it does where that is known, and naming those there are.
Result<void> check_trigger(std::optional<unsigned> code, const TriggerCodes& allowed);

/// What switches off what the trigger switches on; nothing where it is not known to stay on.
std::optional<unsigned> off_code(unsigned trigger, const TriggerCodes& allowed);

}  // namespace axiometry::nc
