// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/table/generic_table.h"

#include <fmt/format.h>

#include <algorithm>

#include "axiometry/base/text/text.h"

namespace axiometry::formats::generic {
namespace {

/// Parts between tabs and between two or more blanks.
std::vector<std::string> widely_parted(std::string_view line) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (std::size_t k = 0; k <= line.size(); ++k) {
    const bool gap = k == line.size() || line[k] == '\t' || line.substr(k, 2) == "  ";
    if (!gap) continue;
    if (const std::string_view part = text::trim(line.substr(begin, k - begin)); !part.empty())
      parts.emplace_back(part);
    begin = k + 1;
  }
  return parts;
}

/// Words, with "(mm)" as part of the word before.
std::vector<std::string> with_units(std::string_view line) {
  std::vector<std::string> names;
  for (std::string_view word : text::words(line)) {
    if (!names.empty() && (word.starts_with('(') || word.starts_with('[')))
      names.back() += " " + std::string(word);
    else
      names.emplace_back(word);
  }
  return names;
}

bool names_agree(const ImportProfile& profile, std::string_view line) {
  const std::vector<std::string> names = names_in(line, profile.delimiter, profile.columns.size());
  const std::size_t n = profile.columns.size();
  for (std::size_t k = 0; k < n; ++k)
    if (const std::string& name = profile.columns[k].name; !name.empty() && (k >= names.size() || name != names[k]))
      return false;
  return true;
}

/// The line as it is, or without the comment mark before it.
std::string_view without_mark(std::string_view line, std::string_view mark) {
  if (!is_comment(line, mark)) return line;
  return text::trim(text::trim(line).substr(mark.size()));
}

std::string wanted_names(const ImportProfile& profile) {
  std::string list;
  for (const ImportColumn& c : profile.columns)
    if (!c.name.empty()) list += (list.empty() ? "" : ", ") + text::quoted(c.name);
  return list;
}

}  // namespace

bool is_comment(std::string_view line, std::string_view mark) {
  return !mark.empty() && text::trim(line).starts_with(mark);
}

std::vector<std::string> names_in(std::string_view line, Delimiter delimiter, std::size_t count) {
  if (delimiter != Delimiter::blanks) {
    std::vector<std::string> names;
    const auto cells = cells_of({line, 0}, {delimiter, false});
    if (!cells) return names;
    for (const CsvCell& cell : *cells) names.push_back(cell.text);
    while (names.size() > count && names.back().empty()) names.pop_back();
    return names;
  }
  for (auto names : {with_units(line), widely_parted(line)})
    if (names.size() == count) return names;
  return with_units(line);
}

Result<TableRegion> find_table(const ImportProfile& profile, std::span<const PlainLine> lines) {
  TableRegion region;
  const bool named = !wanted_names(profile).empty() && profile.header_lines > 0;
  std::size_t k = std::min(profile.skip_lines, lines.size());
  for (; k < lines.size(); ++k) {
    const std::string_view line = lines[k].text;
    if (text::trim(line).empty()) continue;
    if (named ? names_agree(profile, line) || names_agree(profile, without_mark(line, profile.comment))
              : !is_comment(line, profile.comment))
      break;
  }
  if (named && k == lines.size())
    return fail(
        fmt::format("found no line with the columns {}, expected one as the profile says", wanted_names(profile)));
  region.above = lines.first(k);
  for (; k < lines.size(); ++k) {
    PlainLine line = lines[k];
    if (region.header.size() < profile.header_lines && region.header.empty() && named)
      line.text = names_agree(profile, line.text) ? line.text : without_mark(line.text, profile.comment);
    else if (is_comment(line.text, profile.comment))
      continue;
    if (text::trim(line.text).empty()) continue;
    if (!profile.end.empty() && text::trim(line.text).starts_with(profile.end)) break;
    (region.header.size() < profile.header_lines ? region.header : region.rows).push_back(line);
  }
  return region;
}

LinesAbove read_lines_above(std::span<const PlainLine> lines, AxisKind kind, char decimal_mark) {
  constexpr std::size_t most_lines = 200;
  LinesAbove above;
  for (const PlainLine& line : lines.first(std::min(lines.size(), most_lines))) {
    if (text::trim(line.text).empty()) continue;
    const auto alone = read_preamble(fmt::format("{}\ntarget_mm,direction,run,deviation_um\n", line.text));
    std::size_t taken = 0;
    if (alone) {
      taken += alone->default_units.reading != nullptr || alone->default_units.target != nullptr;
      if (alone->default_units.reading != nullptr) above.preamble.default_units.reading = alone->default_units.reading;
      if (alone->default_units.target != nullptr) above.preamble.default_units.target = alone->default_units.target;
      for (MetadataLine item : alone->metadata) {
        item.at.line = line.number;
        Preamble trial = above.preamble;
        trial.metadata.push_back(std::move(item));
        if (!metadata_of(trial, kind, decimal_mark)) continue;
        above.preamble = std::move(trial);
        ++taken;
      }
    }
    if (taken == 0) above.passed_over.add(line.text);
  }
  return above;
}

}  // namespace axiometry::formats::generic
