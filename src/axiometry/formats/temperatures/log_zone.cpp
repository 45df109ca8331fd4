// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/temperatures/log_zone.h"

#include <algorithm>
#include <string>

#include "axiometry/base/text.h"

namespace axiometry::formats {
namespace {

/// A zone alone may be one of the hall.
constexpr std::string_view zone_heads[] = {
    "timezone",  "time zone", "tz",          "utc offset",  "offset utc",     "utcoffset",    "gmt offset",
    "tz offset", "zeitzone",  "utc versatz", "zeitversatz", "fuseau horaire", "décalage utc", "decalage utc"};

bool is_zone_head(std::string_view head) {
  std::string lower = text::to_lower(text::trim(head));
  std::ranges::replace_if(
      lower, [](char c) { return c == '_' || c == '-'; }, ' ');
  for (const std::string_view unit : {" (h)", " [h]", " (min)", " [min]", " (hh:mm)", " [hh:mm]"})
    if (lower.ends_with(unit)) lower.resize(lower.size() - unit.size());
  return text::is_one_of(lower, zone_heads);
}

/// "+01:00", "-5:30", "UTC", "UTC+1", "GMT"; "+1" and "+0100" may be numbers.
bool is_zone(std::string_view cell) {
  cell = text::trim(cell);
  const std::string lower = text::to_lower(cell);
  for (const std::string_view name : {"utc", "gmt"})
    if (lower.starts_with(name))
      return lower.size() == name.size() || lower[name.size()] == '+' || lower[name.size()] == '-';
  if (cell.size() < 5 || cell.size() > 6 || (cell.front() != '+' && cell.front() != '-')) return false;
  const std::size_t colon = cell.size() - 3;
  for (std::size_t k = 1; k < cell.size(); ++k)
    if (k == colon ? cell[k] != ':' : cell[k] < '0' || cell[k] > '9') return false;
  return true;
}

}  // namespace

std::optional<std::size_t> column_of_zone(std::span<const std::string_view> cells,
                                          std::span<const std::string_view> heads) {
  for (std::size_t k = 0; k < cells.size(); ++k)
    if (is_zone(cells[k]) || (k < heads.size() && is_zone_head(heads[k]) && !text::trim(cells[k]).empty())) return k;
  return std::nullopt;
}

}  // namespace axiometry::formats
