// SPDX-License-Identifier: Apache-2.0
#include "axiometry/nc/dialect.h"

#include <algorithm>

#include "axiometry/base/text/text.h"

namespace axiometry::nc {

const Dialect* find_dialect(std::string_view id) {
  std::string name = text::to_lower(id);
  std::ranges::replace(name, '_', '-');
  const auto table = dialect_table();
  const auto found = std::ranges::find(table, name, [](const Dialect* d) { return d->id; });
  return found == table.end() ? nullptr : *found;
}

}  // namespace axiometry::nc
