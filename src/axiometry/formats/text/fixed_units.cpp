// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/text/fixed_units.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "axiometry/base/text/text.h"
#include "axiometry/formats/text/units.h"

namespace axiometry::formats {
namespace {

constexpr std::string_view unit_words[] = {"unit", "units", "einheit", "einheiten", "unité", "unités"};

/// Without what begins a comment or a block and ends it.
std::string_view plain_part(std::string_view text) {
  constexpr std::string_view marks = "/#;*![]<>() \t";
  const std::size_t begin = text.find_first_not_of(marks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(marks) - begin + 1);
}

}  // namespace

Result<void> expect_fixed_units(std::span<const TextLine> lines, std::initializer_list<std::string_view> own) {
  const AxisKind kind = find_unit(*own.begin())->kind;  // a file may hold errors of other axes too
  bool below_unit = false;
  for (const TextLine& line : lines) {
    const std::string_view content = plain_part(line.text);
    const std::size_t mark = content.find_first_of(":=");
    const std::string_view key = text::trim(content.substr(0, mark));
    const bool names_unit = text::is_one_of(key, unit_words);
    if (mark != std::string_view::npos && (names_unit || below_unit)) {
      const std::string_view value = text::trim(content.substr(mark + 1));
      const Unit* unit = find_unit(value);
      if (unit != nullptr && unit->kind == kind && std::ranges::find(own, unit->name) == own.end())
        return fail(fmt::format("found the unit {}, expected none but {}, in which this format is written",
                                text::quoted(value), fmt::join(own, " and ")),
                    line.at(value));
    }
    below_unit = mark == std::string_view::npos && names_unit;
  }
  return {};
}

}  // namespace axiometry::formats
