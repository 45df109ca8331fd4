// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace axiometry {

/// TestConditions::purpose of readings that nobody measured.
inline constexpr std::string_view simulation_purpose = "simulation";

/// TestConditions::date of such a test without a day: there is none, and why.
inline constexpr std::string_view simulated_date = "None: simulated";

/// A line that says it, above a recording or a table.
inline constexpr std::string_view simulated_note = "Simulated, not measured";

/// The machine of a simulation that no plan names one for.
inline constexpr std::string_view virtual_machine = "Virtual machine";

/// The machine that they belong to, one of its own, so that no trend of the measured one shows them.
inline std::string simulated_machine(const std::string& name) {
  constexpr std::string_view mark = " (simulated)";
  if (name.empty()) return "Simulator";
  if (name == virtual_machine) return name;
  return name.ends_with(mark) ? name : name + std::string(mark);
}

/// Why readings of this purpose are none of a machine; nothing of another one. A purpose may be written by hand, in
/// English, German or French; one that only speaks of a simulation, such as "comparison with the simulation", leaves
/// open what was measured, and that is said.
std::optional<std::string> simulated_by_purpose(std::string_view purpose);

}  // namespace axiometry
