// SPDX-License-Identifier: Apache-2.0
#include "cli/text/terminal.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>

#include "axiometry/base/text/text.h"
#include "axiometry/base/text/utf8.h"

namespace axiometry::cli {
namespace {

bool wants_colour(ColourChoice choice) {
  if (choice != ColourChoice::automatic) return choice == ColourChoice::always;
  const char* no_color = std::getenv("NO_COLOR");
  const char* term = std::getenv("TERM");
  if ((no_color && *no_color) || (term && std::string_view(term) == "dumb")) return false;
  return ::isatty(STDOUT_FILENO) == 1;
}

}  // namespace

Terminal::Terminal(ColourChoice choice) : colour_(wants_colour(choice)) {
  winsize size{};
  if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0)
    width_ = std::clamp<std::size_t>(size.ws_col, 60, 120);
}

std::string Terminal::styled(std::string_view s, std::string_view code) const {
  if (!colour_) return std::string(s);
  return "\033[" + std::string(code) + "m" + std::string(s) + "\033[0m";
}

std::size_t display_width(std::string_view s) {
  std::size_t width = 0;
  for (std::size_t at = 0; at < s.size();) {
    const auto [c, length] = character_at(s, at);
    const bool combining = c >= 0x300 && c <= 0x36F;
    const bool wide = (c >= 0x1100 && c <= 0x115F) || (c >= 0x2E80 && c <= 0xD7A3) || (c >= 0xF900 && c <= 0xFAFF) ||
                      (c >= 0xFF00 && c <= 0xFF60) || c >= 0x20000;
    width += combining ? 0 : wide ? 2 : 1;
    at += length;
  }
  return width;
}

std::string left(std::string_view s, std::size_t width) {
  const std::size_t taken = display_width(s);
  return std::string(s) + std::string(width > taken ? width - taken : 0, ' ');
}

std::string right(std::string_view s, std::size_t width) {
  const std::size_t taken = display_width(s);
  return std::string(width > taken ? width - taken : 0, ' ') + std::string(s);
}

std::string wrapped(std::string_view s, std::size_t width, std::size_t indent) {
  std::string result;
  std::size_t column = indent;
  for (std::string_view word : text::words(s)) {
    const std::size_t length = display_width(word);
    if (!result.empty() && column + 1 + length > width) {
      result += "\n" + std::string(indent, ' ');
      column = indent;
    } else if (!result.empty()) {
      result += ' ';
      ++column;
    }
    result += word;
    column += length;
  }
  return result;
}

}  // namespace axiometry::cli
