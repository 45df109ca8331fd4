// SPDX-License-Identifier: Apache-2.0
#include "server/log.h"

#include <fmt/format.h>

#include <cstdio>

namespace axiometry::server {

void log_line(std::string_view text) noexcept {
  static_cast<void>(std::fprintf(stderr, "%.*s\n", static_cast<int>(text.size()), text.data()));
}

void log_failure(std::string_view what, const std::exception& exception) noexcept {
  static_cast<void>(std::fprintf(stderr, "axiometry: %.*s failed: %s\n", static_cast<int>(what.size()), what.data(),
                                 exception.what()));
}

std::string log_text(std::string_view text) {
  std::string visible;
  for (const char c : text) {
    if (c > ' ' && c <= '~' && c != '%')
      visible += c;
    else
      visible += fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return visible.empty() ? "-" : visible;
}

}  // namespace axiometry::server
