// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/text/table_heads.h"

#include <fmt/format.h>

#include <cmath>

#include "axiometry/base/contract.h"
#include "axiometry/base/reading_limits.h"
#include "axiometry/formats/text/text_lines.h"

namespace axiometry::formats {
namespace {

constexpr std::string_view length_difference_words[] = {
    "length difference", "length change", "delta length", "delta l", "deltal", "dl", "d l",
    "\u0394l",           "\u0394L",       "\u2206l",      "\u2206L"};

struct UnitKind {
  AxisKind kind;
  std::string_view expected;
};

Result<const Unit*> unit_of_kind(const CsvCell& head, const TableHead& named, UnitKind kind, std::string_view canonical,
                                 std::size_t line) {
  if (named.unit.empty())
    return fail(
        fmt::format("found the column {} without a unit, expected one as in {}", text::quoted(head.text), canonical),
        {line, head.column});
  const Unit* unit = find_unit(named.unit);
  if (unit == nullptr || unit->kind != kind.kind)
    return fail(fmt::format("found the unit {} of the column {}, expected {}", text::quoted(named.unit),
                            text::quoted(head.text), kind.expected),
                {line, head.column});
  return unit;
}

}  // namespace

TableHead table_head(std::string_view head) {
  head = text::trim(head);
  const std::size_t open = head.find_first_of("[(");
  if (open != std::string_view::npos && (head.ends_with(']') || head.ends_with(')')))
    return {plain_name(text::trim(head.substr(0, open))),
            std::string(text::trim(head.substr(open + 1, head.size() - open - 2)))};
  const std::size_t mark = head.find_last_of("_ ");
  if (mark != std::string_view::npos && (find_unit(head.substr(mark + 1)) != nullptr || head.substr(mark + 1) == "s"))
    return {plain_name(head.substr(0, mark)), std::string(head.substr(mark + 1))};
  return {plain_name(head), ""};
}

bool is_length_difference(std::string_view name) {
  return std::ranges::find(length_difference_words, name) != std::end(length_difference_words);
}

Result<const Unit*> length_unit(const CsvCell& head, const TableHead& named, std::string_view canonical,
                                std::size_t line) {
  return unit_of_kind(head, named, {AxisKind::linear, "a unit of length: um, mm, nm, m or in"}, canonical, line);
}

Result<const Unit*> angle_unit(const CsvCell& head, const TableHead& named, std::string_view canonical,
                               std::size_t line) {
  return unit_of_kind(head, named, {AxisKind::rotary, "a unit of angle: deg, arcsec, mdeg, rad, mrad or urad"},
                      canonical, line);
}

Result<double> length_in_mm(const Unit& unit, double value, std::string_view cell, TextPosition at) {
  const double mm = position_in(unit, value).in_native();
  if (std::abs(mm) <= largest_stated) return mm;
  return fail(fmt::format("found {}, expected a length up to 1e9 mm", text::quoted(cell)), at);
}

std::string passed_over(std::span<const std::string> columns) {
  AXIOMETRY_CONTRACT(!columns.empty());
  std::string list;
  for (const std::string& name : columns) list += fmt::format("{}{}", list.empty() ? "" : ", ", text::quoted(name));
  return fmt::format("passed over the column{} {}", columns.size() == 1 ? "" : "s", list);
}

}  // namespace axiometry::formats
