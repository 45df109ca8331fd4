// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "axiometry/base/result.h"

/// The M code that is put out at each target: only the coolant, an output of its own, or what neither RS-274-D nor its
/// maker has given away; the builder of the machine may have.
namespace axiometry::nc {

/// From `first` to `last`; none when `last` is less.
struct MCodes {
  unsigned first = 1;
  unsigned last = 0;
};

/// What a control may be told for a trigger: an output of its own, the coolant, or what neither RS-274-D nor its maker
/// has given away.
using TriggerCodes = std::array<MCodes, 5>;

/// Fails on a code that is not among them, saying what it does where that is known, and naming those there are.
Result<void> check_trigger(std::optional<unsigned> code, const TriggerCodes& allowed);

}  // namespace axiometry::nc
