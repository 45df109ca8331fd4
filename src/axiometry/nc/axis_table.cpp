// SPDX-License-Identifier: Apache-2.0
#include "axiometry/nc/axis_table.h"

#include <fmt/format.h>

#include <algorithm>

#include "axiometry/base/text.h"

namespace axiometry::nc {

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
