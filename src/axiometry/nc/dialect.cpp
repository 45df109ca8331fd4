// SPDX-License-Identifier: Apache-2.0
#include "axiometry/nc/dialect.h"

#include <algorithm>

namespace axiometry::nc {

const Dialect* find_dialect(std::string_view id) {
  const auto table = dialect_table();
  const auto found = std::ranges::find(table, id, [](const Dialect* d) { return d->id; });
  return found == table.end() ? nullptr : *found;
}

}  // namespace axiometry::nc
