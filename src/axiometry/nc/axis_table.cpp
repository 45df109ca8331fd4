// SPDX-License-Identifier: Apache-2.0
#include "axiometry/nc/axis_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "axiometry/base/text/text.h"
#include "axiometry/nc/table_text.h"

namespace axiometry::nc {
namespace {

constexpr std::array named_options = {
    NamedTableOption{"number", &AxisTableUses::number, [](const AxisTableOptions& o) { return o.number != 0; }},
    NamedTableOption{"resolution", &AxisTableUses::resolution,
                     [](const AxisTableOptions& o) { return o.resolution != AxisTableOptions{}.resolution; }},
    NamedTableOption{"magnification", &AxisTableUses::magnification,
                     [](const AxisTableOptions& o) { return o.magnification != AxisTableOptions{}.magnification; }},
    NamedTableOption{"largest", &AxisTableUses::largest, [](const AxisTableOptions& o) { return o.largest != 0; }},
    NamedTableOption{"steps_per_unit", &AxisTableUses::steps_per_unit,
                     [](const AxisTableOptions& o) { return o.steps_per_unit != 0.0; }},
    NamedTableOption{"output_axis", &AxisTableUses::output_axis,
                     [](const AxisTableOptions& o) { return !o.output_axis.empty() && o.output_axis != o.axis; }},
    NamedTableOption{"turned_sign", &AxisTableUses::turned_sign,
                     [](const AxisTableOptions& o) { return o.turned_sign; }},
    NamedTableOption{"inch", &AxisTableUses::inch, [](const AxisTableOptions& o) { return o.in_inch; }}};

/// The same with the other sign.
Result<AxisCorrection> turned(const AxisCorrection& correction) {
  std::vector<double> up, down;
  for (const double value : correction.values(Direction::up)) up.push_back(-value);
  for (const double value : correction.values(Direction::down)) down.push_back(-value);
  return AxisCorrection::make(correction.kind(), correction.positions(), std::move(up), std::move(down));
}

/// What a sign's sentence begins with, which no wrapping of lines parts: "A positive number moves the axis in the …".
std::string_view beginning_of(std::string_view sign) { return sign.substr(0, sign.find_first_of(":,")); }

Result<void> check_bytes(std::string_view text) {
  if (text.starts_with("\uFEFF"))
    return fail(
        "found a mark of the byte order (BOM) at the head of the table, expected none: a control takes it for a "
        "part of the first line; save the file as UTF-8 without BOM",
        {1, 1});
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
    return fail("found UTF-16 text, expected a table of single bytes; save the file as UTF-8 without BOM", {1, 1});
  const std::size_t nul = text.find('\0');
  if (nul == std::string_view::npos) return {};
  const auto line = 1 + static_cast<std::size_t>(std::ranges::count(text.substr(0, nul), '\n'));
  return fail("found a NUL byte, so this is a binary file, expected a table", {line, 0});
}

}  // namespace

std::string_view sign_of(const AxisTable& table, const AxisTableOptions& options) {
  return options.turned_sign ? table.turned_sign : table.sign;
}

Result<std::string> write_table(const AxisTable& table, const AxisCorrection& correction,
                                const AxisTableOptions& options) {
  AXIOMETRY_TRY_VOID(check_used(table, options));
  std::optional<AxisCorrection> other;
  if (options.turned_sign) {
    AXIOMETRY_TRY(other, turned(correction));
  }
  AXIOMETRY_TRY(std::string text, table.write(other ? *other : correction, options));
  return with_warning(std::move(text), sign_of(table, options), options.warning);
}

Result<AxisCorrection> read_table(const AxisTable& table, std::string_view text, const AxisTableOptions& options) {
  AXIOMETRY_TRY_VOID(check_used(table, options));
  AXIOMETRY_TRY_VOID(check_bytes(text));
  if (!table.turned_sign.empty()) {
    const std::string_view other = beginning_of(options.turned_sign ? table.sign : table.turned_sign);
    if (text.contains(other))
      return fail(fmt::format(
          "found a table that says: {}; expected the sign that was asked for, turned or not as the table was made",
          other));
  }
  AXIOMETRY_TRY(AxisCorrection found, table.read(text, options));
  if (!options.turned_sign) return found;
  return turned(found);
}

std::span<const NamedTableOption> named_table_options() { return named_options; }

Result<void> check_used(const AxisTable& table, const AxisTableOptions& options) {
  if (options.turned_sign && !table.uses.turned_sign)
    return fail(
        fmt::format("found a turned sign asked for of {}, expected it as it is: that sign is verified", table.title));
  for (const NamedTableOption& option : named_options)
    if (!(table.uses.*option.used) && option.is_given(options))
      return fail(fmt::format("found {} given for {}, which has no use for it; expected it to be left out", option.name,
                              table.title));
  return {};
}

Result<const AxisTable*> axis_table_named(std::string_view id) {
  std::string name = text::to_lower(id);
  std::ranges::replace(name, '_', '-');
  std::string known;
  for (const AxisTable* table : axis_table_table()) {
    if (table->id == name) return table;
    known += fmt::format("{}{}", known.empty() ? "" : ", ", table->id);
  }
  return fail(fmt::format("found no control {}, expected one of {}", text::quoted(id), known));
}

}  // namespace axiometry::nc
