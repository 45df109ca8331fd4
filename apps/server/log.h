// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace axiometry::server {

/// A line on the standard error. Where that cannot be written the line is lost and nothing else happens.
void log_line(const std::string& text) noexcept;

}  // namespace axiometry::server
