// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/recording.h"

#include <algorithm>

namespace axiometry::formats {

const Recording* find_recording(std::string_view id) {
  const auto table = recording_table();
  const auto found = std::ranges::find(table, id, [](const Recording* r) { return r->id; });
  return found == table.end() ? nullptr : *found;
}

}  // namespace axiometry::formats
