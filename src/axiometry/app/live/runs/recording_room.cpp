// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/live/runs/recording_room.h"

#include <fmt/format.h>

namespace axiometry::app {

bool has_room(DiskRoom& disk, RoomForBytes bytes, const std::function<void(const std::string&)>& notice) {
  if (bytes.coming > bytes.left) {
    notice("the recording has become as long as one may be: it ends here");
    return false;
  }
  const DiskRoom::Answer answer = disk.before(bytes.coming);
  if (answer.warn)
    notice(fmt::format("found {} MiB left on the disk of the recording; at {} MiB the capture ends", *answer.warn >> 20,
                       DiskRoom::least >> 20));
  if (!answer.enough)
    notice(fmt::format("found less than {} MiB left on the disk of the recording: it ends here",
                       (DiskRoom::least >> 20) + 1));
  return answer.enough;
}

}  // namespace axiometry::app
