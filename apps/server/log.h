// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <exception>
#include <string>
#include <string_view>

namespace axiometry::server {

/// A line on the standard error. Where that cannot be written the line is lost and nothing else happens.
void log_line(std::string_view text) noexcept;

/// A line that this has failed, and why; takes no memory, of which there may be none.
void log_failure(std::string_view what, const std::exception& exception) noexcept;

/// What somebody else said, for a line of the log: visible ASCII as it is, all else and the percent sign as %XX, so
/// that it ends neither line nor column and turns no direction of writing; "-" for nothing.
std::string log_text(std::string_view text);

}  // namespace axiometry::server
