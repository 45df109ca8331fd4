// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/temperatures/log_zone.h"

#include <fmt/format.h>

#include <algorithm>

#include "axiometry/base/text/text.h"
#include "axiometry/formats/text/name_words.h"

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

constexpr std::string_view zone_names[] = {"z", "utc", "gmt", "cet", "cest", "mez", "mesz"};
constexpr std::string_view zone_areas[] = {"africa", "america",   "antarctica", "arctic", "asia",   "atlantic",
                                           "etc",    "australia", "europe",     "indian", "pacific"};
constexpr std::size_t zone_bytes_max = 40;

/// Of columns of names, unless they speak of the time.
constexpr NameWord name_words[] = {{"logger", WordPlace::anywhere},
                                   {"enregistreur"},
                                   {"device", WordPlace::front},
                                   {"gerät", WordPlace::front_or_back},
                                   {"appareil"},
                                   {"serial"},
                                   {"seriennummer"},
                                   {"sensor", WordPlace::front_or_back},
                                   {"fühler", WordPlace::back},
                                   {"capteur"},
                                   {"probe"},
                                   {"channel"},
                                   {"kanal", WordPlace::back},
                                   {"station"},
                                   {"name", WordPlace::back},
                                   {"nom"},
                                   {"model", WordPlace::front},
                                   {"axis"},
                                   {"achse"},
                                   {"axe"}};
constexpr NameWord time_words[] = {{"zone", WordPlace::anywhere},
                                   {"offset", WordPlace::anywhere},
                                   {"versatz", WordPlace::back},
                                   {"time", WordPlace::front_or_back},
                                   {"zeit", WordPlace::front_or_back},
                                   {"fuseau"},
                                   {"utc"}};

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// "+01:00", "-5:30"; "+1" may be a number.
bool is_offset(std::string_view cell) {
  if (cell.size() < 5 || cell.size() > 6 || (cell.front() != '+' && cell.front() != '-')) return false;
  const std::size_t colon = cell.size() - 3;
  for (std::size_t k = 1; k < cell.size(); ++k)
    if (k == colon ? cell[k] != ':' : !is_digit(cell[k])) return false;
  return true;
}

/// "+0100", "-0330"; -1000 rather says that a sensor had no value.
bool is_offset_in_digits(std::string_view cell) {
  if (cell.size() != 5 || (cell.front() != '+' && !cell.starts_with("-0"))) return false;
  const std::string_view digits = cell.substr(1);
  constexpr std::string_view minutes[] = {"00", "15", "30", "45"};
  return std::ranges::all_of(digits, is_digit) && digits.substr(0, 2) <= "14" &&
         text::is_one_of(digits.substr(2), minutes);
}

/// "utc+1", "gmt-7", "utc +01:00"; "utc-logger 3" is a name.
bool is_named_offset(std::string_view lower) {
  if (!lower.starts_with("utc") && !lower.starts_with("gmt")) return false;
  const std::string_view offset = text::trim(lower.substr(3));
  return offset.size() > 1 && offset.size() <= 6 && (offset.front() == '+' || offset.front() == '-') &&
         std::ranges::all_of(offset.substr(1), [](char c) { return is_digit(c) || c == ':'; });
}

/// "europe/berlin", "etc/gmt+1"
bool is_area_and_city(std::string_view lower) {
  const std::size_t slash = lower.find('/');
  if (slash == lower.npos || slash + 1 == lower.size() || !text::is_one_of(lower.substr(0, slash), zone_areas))
    return false;
  return std::ranges::all_of(lower.substr(slash + 1), [](char c) {
    return (c >= 'a' && c <= 'z') || is_digit(c) || std::string_view("/_+-").contains(c);
  });
}

bool is_zone(std::string_view cell, bool digits) {
  if (cell.empty() || cell.size() > zone_bytes_max) return false;
  if (is_offset(cell) || (digits && is_offset_in_digits(cell))) return true;
  const std::string lower = text::to_lower(cell);
  return text::is_one_of(lower, zone_names) || is_named_offset(lower) || is_area_and_city(lower);
}

}  // namespace

std::optional<ZoneColumn> zone_column(std::size_t place, std::string_view head, bool digits) {
  head = text::trim(head);
  if (has_any_word(head, name_words) && !has_any_word(head, time_words)) return std::nullopt;
  return ZoneColumn{place, head.empty() ? fmt::format("column {}", place + 1) : text::quoted(head), is_zone_head(head),
                    digits};
}

Result<void> check_zones(std::span<const std::string_view> cells, std::span<const ZoneColumn> columns) {
  for (const ZoneColumn& column : columns) {
    if (column.place >= cells.size()) continue;
    const std::string_view cell = text::trim(cells[column.place]);
    if (column.by_head ? cell.empty() : !is_zone(cell, column.digits)) continue;
    return fail(
        fmt::format("found the time zone {} in a column of its own ({}), expected it behind the time, such as "
                    "2026-03-02T09:00+01:00",
                    text::quoted(cell), column.name));
  }
  return {};
}

}  // namespace axiometry::formats
