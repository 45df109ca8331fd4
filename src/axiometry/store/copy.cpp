// SPDX-License-Identifier: Apache-2.0
#include "axiometry/store/copy.h"

#include <fmt/format.h>

#include <array>

#include "axiometry/store/things.h"

namespace axiometry::store {
namespace {

struct CopiedTable {
  std::string_view name;
  std::string_view key;  ///< an integer that counts from 1
  std::int64_t at_once;  ///< keys whose rows are in memory together
};

/// What is referred to comes first.
constexpr std::array copied_tables = {
    CopiedTable{"content", "id", 1},
    CopiedTable{"machine", "id", 1000},
    CopiedTable{"machine_version", "id", 100},
    CopiedTable{"axis", "id", 1000},
    CopiedTable{"axis_version", "id", 100},
    CopiedTable{"instrument", "id", 1000},
    CopiedTable{"instrument_version", "id", 100},
    CopiedTable{"plan", "id", 1000},
    CopiedTable{"plan_version", "id", 100},
    CopiedTable{"test", "id", 1000},
    CopiedTable{"test_version", "test", 100},
    CopiedTable{"test_instrument", "test", 500},
    CopiedTable{"evaluation", "test", 50},
    CopiedTable{"figure", "test", 100},
    CopiedTable{"document", "id", 1000},
    CopiedTable{"audit", "id", 1000},
    CopiedTable{"test_list", "test", 500},
    CopiedTable{"test_search", "test", 1000},
    CopiedTable{"list_instrument", "test", 1000},
};

Result<void> copy(Connection& from, Connection& to, const CopiedTable& table) {
  AXIOMETRY_TRY(const Rows last, from.query(fmt::format("SELECT coalesce(max({}), 0) FROM {}", table.key, table.name)));
  for (std::int64_t first = 1; first <= last[0].integer(0); first += table.at_once) {
    AXIOMETRY_TRY(const Rows rows,
                  from.query(fmt::format("SELECT * FROM {} WHERE {} BETWEEN $1 AND $2", table.name, table.key),
                             {first, first + table.at_once - 1}));
    AXIOMETRY_TRY_VOID(insert_rows(to, table.name, "", rows));
  }
  return {};
}

}  // namespace

Result<void> copy_rows(Connection& from, Connection& to) {
  for (const CopiedTable& table : copied_tables) AXIOMETRY_TRY_VOID(copy(from, to, table));
  return {};
}

}  // namespace axiometry::store
