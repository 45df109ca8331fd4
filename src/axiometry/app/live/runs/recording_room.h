// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

#include "axiometry/app/files/disk_room.h"

namespace axiometry::app {

struct RoomForBytes {
  std::uint64_t left = UINT64_MAX;  ///< bytes that a recording may still become longer
  std::size_t coming = 0;
};

/// Whether bytes that came have room, by the length that a recording may have and on its disk; tells what is short. A
/// capture ends before the disk is full, so that what came is kept whole, and the test with it.
bool has_room(DiskRoom& disk, RoomForBytes bytes, const std::function<void(const std::string&)>& notice);

}  // namespace axiometry::app
