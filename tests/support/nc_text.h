// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <charconv>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

/// Text of part programs, as the interpreters of the tests take it apart.
namespace axiometry::testing_support {

inline double nc_number(std::string_view text) {
  double x = 0.0;
  const auto [end, fault] = std::from_chars(text.data() + text.starts_with('+'), text.data() + text.size(), x);
  if (fault != std::errc() || end != text.data() + text.size())
    throw std::runtime_error("no number: " + std::string(text));
  if (text.starts_with("-0") && x == 0.0) throw std::runtime_error("negative zero");
  return x;
}

/// Everything up to `end` from `text`, which loses it.
inline std::string_view take_until(std::string_view& text, std::string_view end) {
  const std::size_t at = text.find(end);
  if (at == std::string_view::npos) throw std::runtime_error("no " + std::string(end) + " in " + std::string(text));
  const std::string_view taken = text.substr(0, at);
  text.remove_prefix(at + end.size());
  return taken;
}

inline std::string_view trimmed(std::string_view s) {
  while (s.starts_with(' ')) s.remove_prefix(1);
  while (s.ends_with(' ')) s.remove_suffix(1);
  return s;
}

inline std::vector<std::string_view> lines_of(std::string_view program) {
  std::vector<std::string_view> lines;
  while (!program.empty()) {
    lines.push_back(take_until(program, "\n"));
    if (lines.back().ends_with('\r')) lines.back().remove_suffix(1);
  }
  return lines;
}

/// Whether lines end with CR LF; throws when they do not agree.
inline bool ends_crlf(std::string_view program) {
  std::size_t all = 0, with = 0;
  for (std::size_t k = 0; k < program.size(); ++k) {
    if (program[k] == '\r' && program.substr(k, 2) != "\r\n") throw std::runtime_error("a lonely CR");
    if (program[k] == '\n') ++all;
    if (program[k] == '\n' && k > 0 && program[k - 1] == '\r') ++with;
  }
  if (with != 0 && with != all) throw std::runtime_error("line ends of two kinds");
  return with > 0;
}

}  // namespace axiometry::testing_support
