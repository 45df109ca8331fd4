// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace axiometry {

/// TestConditions::purpose of readings that nobody measured.
inline constexpr std::string_view simulation_purpose = "simulation";

/// The machine that they belong to, one of its own, so that no trend of the measured one shows them.
inline std::string simulated_machine(const std::string& name) {
  return name.empty() ? "Simulator" : name + " (simulated)";
}

}  // namespace axiometry
