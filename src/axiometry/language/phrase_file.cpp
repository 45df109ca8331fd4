// SPDX-License-Identifier: Apache-2.0
#include "axiometry/language/phrase_file.h"

#include <fmt/format.h>

#include <algorithm>

namespace axiometry::language {
namespace {

bool has_blank_end(std::string_view line) {
  const auto is_blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  return is_blank(line.front()) || is_blank(line.back());
}

}  // namespace

Result<std::vector<PhrasePair>> read_pairs(std::string_view text) {
  std::vector<PhrasePair> pairs;
  std::size_t number = 0;
  std::size_t subject = 0;
  std::size_t lines = 0;  // of the pair that is read
  bool in_comment = false;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    ++number;
    const bool is_comment = line.starts_with('#');
    if (is_comment && !in_comment) ++subject;
    in_comment = is_comment;
    if (line.empty() || is_comment) {
      if (lines == 1) return fail(fmt::format("line {}: found no line after '{}'", number, pairs.back().english));
      lines = 0;
      continue;
    }
    if (has_blank_end(line)) return fail(fmt::format("line {}: found a blank at an end of '{}'", number, line));
    if (lines == 2) return fail(fmt::format("line {}: found a third line '{}', expected a blank one", number, line));
    if (lines == 0)
      pairs.push_back({std::string(line), {}, subject});
    else
      pairs.back().other = line;
    ++lines;
  }
  if (lines == 1) return fail(fmt::format("line {}: found no line after '{}'", number, pairs.back().english));
  return pairs;
}

std::vector<Phrase> phrases_of(std::span<const PhrasePair> pairs) {
  std::vector<Phrase> phrases;
  phrases.reserve(pairs.size());
  for (const PhrasePair& pair : pairs) phrases.push_back({pair.english, pair.other});
  return phrases;
}

}  // namespace axiometry::language
