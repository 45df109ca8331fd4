// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

#include "axiometry/simulation/virtual_axis.h"

/// Faults to look at: each an axis in good order with one thing wrong, of a size seen on machine tools.
namespace axiometry::simulation {

struct Preset {
  std::string_view id;                    ///< "worn-screw", for --fault
  std::string_view title;                 ///< what is wrong
  std::string_view sign;                  ///< how it shows in a report
  VirtualAxis (*make)(const Plan& plan);  ///< makes the axis for this plan's travel, kind and expected period
};

/// `good` first, `mixed` last.
std::span<const Preset> presets();

/// nullptr when there is none of that id.
const Preset* find_preset(std::string_view id);

}  // namespace axiometry::simulation
