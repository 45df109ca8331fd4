// SPDX-License-Identifier: Apache-2.0
#include "axiometry/language/phrase_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "axiometry/base/contract.h"
#include "axiometry/base/embedded_file.h"

namespace axiometry::language {

std::span<const EmbeddedFile> pairs_files();  // generated

namespace {

constexpr std::string_view page_subject = "The page";

bool has_blank_end(std::string_view line) {
  const auto is_blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  return is_blank(line.front()) || is_blank(line.back());
}

/// The text of a comment's first line.
std::string_view subject_of(std::string_view line) {
  line.remove_prefix(1);
  if (line.starts_with(' ')) line.remove_prefix(1);
  return line;
}

}  // namespace

Result<std::vector<PhrasePair>> read_pairs(std::string_view text) {
  std::vector<PhrasePair> pairs;
  std::string_view subject;
  std::size_t number = 0;
  std::size_t lines = 0;  // of the pair that is read
  bool in_comment = false;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    ++number;
    const bool is_comment = line.starts_with('#');
    if (is_comment && !in_comment) subject = subject_of(line);
    in_comment = is_comment;
    if (line.empty() || is_comment) {
      if (lines == 1) return fail(fmt::format("line {}: found no line after '{}'", number, pairs.back().english));
      lines = 0;
      continue;
    }
    if (has_blank_end(line)) return fail(fmt::format("line {}: found a blank at an end of '{}'", number, line));
    if (lines == 2) return fail(fmt::format("line {}: found a third line '{}', expected a blank one", number, line));
    if (lines == 0)
      pairs.push_back({std::string(line), {}, std::string(subject), subject.starts_with(page_subject)});
    else
      pairs.back().other = line;
    ++lines;
  }
  if (lines == 1) return fail(fmt::format("line {}: found no line after '{}'", number, pairs.back().english));
  return pairs;
}

std::vector<PhrasePair> pairs_of(std::string_view tag) {
  const auto files = pairs_files();
  const auto file = std::ranges::find(files, std::string(tag) + ".txt", &EmbeddedFile::name);
  AXIOMETRY_CONTRACT(file != files.end());
  auto pairs = read_pairs(file->bytes);
  AXIOMETRY_CONTRACT(pairs.has_value());
  return *std::move(pairs);
}

}  // namespace axiometry::language
