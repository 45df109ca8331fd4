// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <string_view>

#include "axiometry/base/result.h"

/// Private to app/: what the system refused.
namespace axiometry::app {

/// "cannot write: No space left on device", of the file of that name; the reason is errno's.
inline std::unexpected<Error> fail_system(const std::string& name, std::string_view doing) {
  return std::unexpected(Error{fmt::format("cannot {}: {}", doing, std::strerror(errno)), name, {}});
}

}  // namespace axiometry::app
