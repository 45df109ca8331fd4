// SPDX-License-Identifier: Apache-2.0
#include "axiometry/store/proof/copy.h"

#include <fmt/format.h>

#include <array>

#include "axiometry/store/kept/assets.h"
#include "axiometry/store/proof/id_walk.h"

namespace axiometry::store {
namespace {

/// What is referred to comes first; rows of the keys that are walked together are in memory together.
constexpr std::array copied_tables = {
    IdWalk{"content", "id", 1},
    IdWalk{"machine", "id", 1000},
    IdWalk{"machine_version", "id", 100},
    IdWalk{"axis", "id", 1000},
    IdWalk{"axis_version", "id", 100},
    IdWalk{"instrument", "id", 1000},
    IdWalk{"instrument_version", "id", 100},
    IdWalk{"plan", "id", 1000},
    IdWalk{"plan_version", "id", 100},
    IdWalk{"calibration", "id", 1000},
    IdWalk{"calibration_version", "id", 100},
    IdWalk{"test", "id", 1000},
    IdWalk{"test_version", "test", 100},
    IdWalk{"test_instrument", "test", 500},
    IdWalk{"evaluation", "test", 50},
    IdWalk{"figure", "test", 100},
    IdWalk{"compensation", "id", 1000},
    IdWalk{"compensation_version", "id", 100},
    IdWalk{"document", "id", 1000},
    IdWalk{"audit", "id", 1000},
    IdWalk{"test_list", "test", 500},
    IdWalk{"test_search", "test", 1000},
    IdWalk{"list_instrument", "test", 1000},
};

Result<void> copy(Connection& from, Connection& to, const IdWalk& table) {
  const std::string rows_between = fmt::format("SELECT * FROM {} WHERE {} BETWEEN $1 AND $2", table.table, table.key);
  return walk(from, table, [&](std::span<const Id> keys) -> Result<void> {
    AXIOMETRY_TRY(const Rows rows, from.query(rows_between, {keys.front(), keys.back()}));
    return insert_rows(to, table.table, "", rows);
  });
}

}  // namespace

Result<void> copy_rows(Connection& from, Connection& to) {
  for (const IdWalk& table : copied_tables) AXIOMETRY_TRY_VOID(copy(from, to, table));
  return {};
}

}  // namespace axiometry::store
