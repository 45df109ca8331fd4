// SPDX-License-Identifier: Apache-2.0
#include "axiometry/store/copy.h"

#include <fmt/format.h>

#include <array>

#include "axiometry/store/things.h"

namespace axiometry::store {
namespace {

struct Table {
  std::string_view name;
  std::string_view key;  ///< an integer that counts from 1
  std::int64_t at_once;  ///< keys whose rows are in memory together
};

/// What is referred to comes first.
constexpr std::array tables = {
    Table{"content", "id", 1},
    Table{"machine", "id", 1000},
    Table{"machine_version", "id", 100},
    Table{"axis", "id", 1000},
    Table{"axis_version", "id", 100},
    Table{"instrument", "id", 1000},
    Table{"instrument_version", "id", 100},
    Table{"plan", "id", 1000},
    Table{"plan_version", "id", 100},
    Table{"test", "id", 1000},
    Table{"test_version", "test", 100},
    Table{"test_instrument", "test", 500},
    Table{"evaluation", "test", 50},
    Table{"figure", "test", 100},
    Table{"document", "id", 1000},
    Table{"audit", "id", 1000},
    Table{"test_list", "test", 500},
    Table{"test_search", "test", 1000},
    Table{"list_instrument", "test", 1000},
};

Result<void> copy(Connection& from, Connection& to, const Table& table) {
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
  for (const Table& table : tables) AXIOMETRY_TRY_VOID(copy(from, to, table));
  return {};
}

}  // namespace axiometry::store
