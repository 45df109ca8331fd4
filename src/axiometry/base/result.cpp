// SPDX-License-Identifier: Apache-2.0
#include "axiometry/base/result.h"

#include <fmt/format.h>

namespace axiometry {

std::string Error::to_string() const {
  std::string place = file;
  if (at.line > 0) place += fmt::format("{}{}", place.empty() ? "line " : ":", at.line);
  if (at.line > 0 && at.column > 0) place += fmt::format(":{}", at.column);
  return place.empty() ? message : place + ": " + message;
}

}  // namespace axiometry
