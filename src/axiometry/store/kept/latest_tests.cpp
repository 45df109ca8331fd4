// SPDX-License-Identifier: Apache-2.0
#include "axiometry/store/kept/latest_tests.h"

#include <fmt/format.h>

#include <string_view>
#include <utility>

#include "axiometry/store/database/connection.h"

namespace axiometry::store {
namespace {

/// The newest test of an owner (a machine n, an axis a) with a day of measurement, or without one: either comes out of
/// an index.
std::string newest_of(std::string_view owner, std::string_view which) {
  return fmt::format(
      "(SELECT m.test FROM test_list m WHERE {} AND m.withdrawn = 0 AND m.measured_on {} "
      "ORDER BY m.measured_on DESC, m.test DESC LIMIT 1)",
      owner, which);
}

/// Of rows of one owner that follow each other the one of the latest day; of several on a day the last.
template <typename Found>
void keep_latest(std::vector<Found>& found, Found next, Id Found::*owner) {
  if (found.empty() || found.back().*owner != next.*owner)
    found.push_back(std::move(next));
  else if (next.latest.day() >= found.back().latest.day())
    found.back() = std::move(next);
}

}  // namespace

Result<std::vector<MachineTests>> find_machine_tests(Connection& connection, std::optional<Id> machine) {
  std::vector<Parameter> parameters;
  if (machine) parameters.emplace_back(*machine);
  // The counts come out of the index list_machine too; of the table two rows for each machine are read.
  AXIOMETRY_TRY(
      const Rows rows,
      connection.query(
          fmt::format(
              "SELECT n.machine, n.total, l.test, l.measured_on, l.received_at, l.verdict FROM (SELECT machine, "
              "count(*) AS total FROM test_list WHERE withdrawn = 0 AND machine {} GROUP BY machine) n JOIN "
              "test_list l ON l.test IN ({}, {}) ORDER BY n.machine, l.test",
              machine ? "= $1" : "IS NOT NULL", newest_of("m.machine = n.machine", "> ''"),
              newest_of("m.machine = n.machine", "= ''")),
          parameters));
  std::vector<MachineTests> found;
  for (const Row& row : rows)
    keep_latest(found,
                MachineTests{row.integer(0), row.integer(1), {row.integer(2), row.text(3), row.text(4), row.text(5)}},
                &MachineTests::machine);
  return found;
}

Result<std::vector<AxisLatest>> find_axes_latest(Connection& connection, std::optional<Id> machine) {
  std::vector<Parameter> parameters;
  if (machine) parameters.emplace_back(*machine);
  AXIOMETRY_TRY(
      const Rows rows,
      connection.query(fmt::format("SELECT l.machine, l.axis, l.test, l.measured_on, l.received_at, l.verdict "
                                   "FROM axis a JOIN test_list l ON l.test IN ({}, {}) WHERE l.machine {} "
                                   "ORDER BY l.machine, l.axis, l.test",
                                   newest_of("m.axis = a.id", "> ''"), newest_of("m.axis = a.id", "= ''"),
                                   machine ? "= $1" : "IS NOT NULL"),
                       parameters));
  std::vector<AxisLatest> found;
  for (const Row& row : rows)
    keep_latest(found,
                AxisLatest{row.integer(0), row.integer(1), {row.integer(2), row.text(3), row.text(4), row.text(5)}},
                &AxisLatest::axis);
  return found;
}

}  // namespace axiometry::store
