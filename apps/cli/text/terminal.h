// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace axiometry::cli {

enum class ColourChoice { automatic, always, never };

/// How to write to the standard output: with colour only on a terminal (and not under NO_COLOR).
class Terminal {
 public:
  explicit Terminal(ColourChoice choice);

  std::string bold(std::string_view s) const { return styled(s, "1"); }
  std::string faint(std::string_view s) const { return styled(s, "2"); }
  std::string red(std::string_view s) const { return styled(s, "31"); }
  std::string green(std::string_view s) const { return styled(s, "32"); }
  std::string yellow(std::string_view s) const { return styled(s, "33"); }
  std::size_t width() const { return width_; }  ///< columns, 60 to 120; 100 when it is no terminal

 private:
  std::string styled(std::string_view s, std::string_view code) const;
  bool colour_ = false;
  std::size_t width_ = 100;
};

/// Columns that a UTF-8 text takes: combining marks none, ideographs two.
std::size_t display_width(std::string_view s);

std::string left(std::string_view s, std::size_t width);   ///< padded on the right
std::string right(std::string_view s, std::size_t width);  ///< padded on the left

/// Breaks at blanks so that no line is wider; lines after the first begin with `indent` blanks.
std::string wrapped(std::string_view s, std::size_t width, std::size_t indent);

}  // namespace axiometry::cli
