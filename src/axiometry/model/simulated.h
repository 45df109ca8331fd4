// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace axiometry {

/// TestConditions::purpose of readings that nobody measured.
inline constexpr std::string_view simulation_purpose = "simulation";

}  // namespace axiometry
