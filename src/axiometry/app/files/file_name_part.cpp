// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/files/file_name_part.h"

#include <algorithm>

namespace axiometry::app {

std::string file_name_part(std::string name) {
  std::ranges::replace_if(
      name, [](unsigned char c) { return c == '/' || c < 0x20; }, '_');
  return name;
}

}  // namespace axiometry::app
