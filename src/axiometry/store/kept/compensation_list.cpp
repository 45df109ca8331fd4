// SPDX-License-Identifier: Apache-2.0
#include "axiometry/store/kept/compensation_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "axiometry/store/kept/assets.h"
#include "axiometry/store/kept/test_records.h"

namespace axiometry::store {

Result<std::vector<CompensationRow>> find_compensations(Connection& connection, const CompensationFilter& filter) {
  std::vector<Parameter> parameters = {std::clamp<std::int64_t>(filter.limit, 0, largest_page)};
  std::string where = filter.withdrawn ? "WHERE v.withdrawn >= 0" : "WHERE v.withdrawn = 0";
  if (filter.test) {
    parameters.emplace_back(*filter.test);
    where += fmt::format(" AND (v.test = ${0} OR v.retest = ${0})", parameters.size());
  }
  if (filter.axis) {
    parameters.emplace_back(*filter.axis);
    where += fmt::format(" AND v.axis = ${}", parameters.size());
  }
  AXIOMETRY_TRY(auto found,
                latest_assets<CompensationRecord>(connection, where + " ORDER BY v.id DESC LIMIT $1", parameters));
  std::vector<CompensationRow> rows;
  for (auto& compensation : found) {
    AXIOMETRY_TRY(
        const Rows first,
        connection.query("SELECT at FROM compensation_version WHERE id = $1 AND version = 1", {compensation.id}));
    rows.push_back({std::move(compensation), first.empty() ? std::string() : first[0].text(0)});
  }
  return rows;
}

}  // namespace axiometry::store
