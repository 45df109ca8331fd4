// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

/// Private to app/: what was written is on the disk, not only in the memory of the system, before anything says that it
/// is kept. A machine that loses its power would else leave an empty file under the new name, or none under either.
namespace axiometry::app {

/// Writes all bytes, whatever signal comes between; false where the system does not take them, and errno says why.
bool written_all(int descriptor, std::string_view bytes);

/// Whether all bytes of an open file are on the disk; errno says why not. What cannot be synced, as a pipe, is.
bool synced(int descriptor);

/// Likewise the names in the folder where this file is.
bool folder_synced(const std::string& file);

}  // namespace axiometry::app
