// SPDX-License-Identifier: Apache-2.0
#include "axiometry/store/proof/id_walk.h"

#include <fmt/format.h>

#include <limits>

#include "axiometry/store/proof/problems.h"

namespace axiometry::store {

Result<void> walk(Connection& connection, const IdWalk& way,
                  const std::function<Result<void>(std::span<const Id>)>& visit) {
  const auto keys = [&](std::string_view relation) {
    return fmt::format("SELECT DISTINCT {0} FROM {1} WHERE {0} {2} $1 ORDER BY {0} LIMIT $2", way.key, way.table,
                       relation);
  };
  AXIOMETRY_TRY(const Rows first, connection.query(fmt::format("SELECT min({}) FROM {}", way.key, way.table)));
  if (first[0].null(0)) return {};
  AXIOMETRY_TRY(Rows rows, connection.query(keys(">="), {first[0].integer(0), way.at_once}));
  while (!rows.empty()) {
    std::vector<Id> ids;
    for (const Row& row : rows) ids.push_back(row.integer(0));
    AXIOMETRY_TRY_VOID(visit(ids));
    AXIOMETRY_TRY(rows, connection.query(keys(">"), {ids.back(), way.at_once}));
  }
  return {};
}

/// A number behind the one that is expected is never the smallest one, so what is in front of it is one, too.
void IdCount::next(Id id, std::vector<std::string>& problems) {
  if (id > expected_ && id - 1 == expected_)
    add_problem(problems, "{} {}: found none, expected all without gaps", table_, expected_);
  else if (id > expected_)
    add_problem(problems, "{} {} to {}: found none, expected all without gaps", table_, expected_, id - 1);
  if (id >= expected_) expected_ = id + (id < std::numeric_limits<Id>::max() ? 1 : 0);
}

}  // namespace axiometry::store
