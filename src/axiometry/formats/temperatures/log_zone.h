// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

/// Private to this folder.
namespace axiometry::formats {

/// The column of a line of readings that holds nothing but the time zone: by its cell ("+01:00", "UTC") or its
/// head ("timezone", "UTC offset"). Heads may be fewer, or none.
std::optional<std::size_t> column_of_zone(std::span<const std::string_view> cells,
                                          std::span<const std::string_view> heads);

}  // namespace axiometry::formats
