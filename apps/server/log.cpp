// SPDX-License-Identifier: Apache-2.0
#include "log.h"

#include <cstdio>

namespace axiometry::server {

void log_line(const std::string& text) noexcept { static_cast<void>(std::fprintf(stderr, "%s\n", text.c_str())); }

}  // namespace axiometry::server
