// SPDX-License-Identifier: Apache-2.0
#include "axiometry/nc/axis_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "axiometry/base/text.h"

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
    NamedTableOption{"inch", &AxisTableUses::inch, [](const AxisTableOptions& o) { return o.in_inch; }}};

}  // namespace

std::span<const NamedTableOption> named_table_options() { return named_options; }

Result<void> check_used(const AxisTable& table, const AxisTableOptions& options) {
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
