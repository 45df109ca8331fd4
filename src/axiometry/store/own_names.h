// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

/// By which names the program itself stands in the trail of changes. Nobody else may go by them.
namespace axiometry::store {

inline constexpr std::string_view restorer = "restore";         ///< who restores a backup
inline constexpr std::string_view example_loader = "examples";  ///< who puts the examples into an empty archive
inline constexpr std::string_view nobody_named = "workbench";   ///< who does not say a name

inline constexpr std::array own_names = {restorer, example_loader, nobody_named};

}  // namespace axiometry::store
