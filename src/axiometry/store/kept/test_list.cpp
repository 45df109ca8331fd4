// SPDX-License-Identifier: Apache-2.0
#include "axiometry/store/kept/test_list.h"

#include <fmt/format.h>

#include <algorithm>

#include "axiometry/store/kept/assets.h"
#include "axiometry/store/kept/folded_text.h"

namespace axiometry::store {
namespace {

constexpr std::string_view list_columns =
    "test, version, withdrawn, conforming, machine, axis, value_a, value_e, value_r, value_b, unit, verdict, "
    "measured_on, received_at, title_key, file_key, machine_key, axis_key, title, file_name, machine_name, axis_name, "
    "axis_kind, label, content";

/// How test_search follows from test_list, in SQL and in list_cells().
constexpr std::string_view searched_words = "title_key || ' ' || file_key || ' ' || machine_key || ' ' || axis_key";

Cell value_of(const TestVersion& version, std::string_view parameter) {
  for (const FigureRecord& figure : version.evaluation.figures)
    if (figure.parameter == parameter) return figure.value;
  return {};
}

/// The searched words of the tests that `where` picks, after a name in them has changed.
Result<void> renew_words(Connection& connection, std::string_view where, Id id) {
  return connection.run(fmt::format("UPDATE test_search SET words = (SELECT {} FROM test_list l WHERE l.test = "
                                    "test_search.test) WHERE test IN (SELECT test FROM test_list WHERE {} = $1)",
                                    searched_words, where),
                        {id});
}

}  // namespace

std::vector<Cell> list_cells(const TestHead& head, const TestVersion& v, const std::string& machine_name,
                             const std::string& axis_name, const std::string& axis_kind) {
  const std::string keys[4] = {folded(v.title), folded(head.file_name), folded(machine_name), folded(axis_name)};
  return {v.test,
          std::int64_t{v.version},
          std::int64_t{head.withdrawn},
          std::int64_t{v.evaluation.conforming},
          cell(v.machine),
          cell(v.axis),
          value_of(v, "A"),
          value_of(v, "E"),
          value_of(v, "R"),
          value_of(v, "B"),
          v.evaluation.unit,
          v.evaluation.verdict,
          v.measured_on,
          head.received.at,
          keys[0],
          keys[1],
          keys[2],
          keys[3],
          v.title,
          head.file_name,
          machine_name,
          axis_name,
          axis_kind,
          v.evaluation.label,
          head.sha256,
          fmt::format("{} {} {} {}", keys[0], keys[1], keys[2], keys[3])};
}

Result<void> list_test(Connection& connection, const TestHead& head, const TestVersion& latest) {
  std::string machine_name;
  std::string axis_name = latest.axis_name;
  std::string axis_kind = latest.axis_kind;
  if (latest.machine) {
    AXIOMETRY_TRY(auto machine, get_asset<MachineRecord>(connection, *latest.machine));
    machine_name = std::move(machine.value.name);
  }
  if (latest.axis) {
    AXIOMETRY_TRY(auto axis, get_asset<AxisRecord>(connection, *latest.axis));
    axis_name = std::move(axis.value.name);
    axis_kind = std::move(axis.value.kind);
  }
  const std::vector<Cell> cells = list_cells(head, latest, machine_name, axis_name, axis_kind);
  std::vector<Parameter> parameters = parameters_of(cells);
  const Parameter searched = parameters.back();
  parameters.pop_back();
  AXIOMETRY_TRY_VOID(connection.run(
      fmt::format("INSERT INTO test_list ({}) VALUES ({})", list_columns, places(1, parameters.size())), parameters));
  const std::int64_t withdrawn = head.withdrawn ? 1 : 0;
  AXIOMETRY_TRY_VOID(connection.run("INSERT INTO test_search (test, withdrawn, words) VALUES ($1, $2, $3)",
                                    {latest.test, withdrawn, searched}));
  for (std::size_t k = 0; k < latest.instruments.size(); ++k) {
    const Id instrument = latest.instruments[k].instrument;
    const auto again = [&](const InstrumentUse& use) { return use.instrument == instrument; };
    if (std::ranges::any_of(std::span(latest.instruments).first(k), again)) continue;
    AXIOMETRY_TRY_VOID(connection.run("INSERT INTO list_instrument (instrument, withdrawn, test) VALUES ($1, $2, $3)",
                                      {instrument, withdrawn, latest.test}));
  }
  return {};
}

Result<void> relist_test(Connection& connection, const TestHead& head, const TestVersion& latest) {
  for (const std::string_view table : {"list_instrument", "test_search", "test_list"})
    AXIOMETRY_TRY_VOID(connection.run(fmt::format("DELETE FROM {} WHERE test = $1", table), {latest.test}));
  return list_test(connection, head, latest);
}

Result<Rows> listed(Connection& connection, Id first, Id last) {
  std::string selected = "l.";
  for (const char c : list_columns) selected += c == ' ' ? std::string(" l.") : std::string(1, c);
  return connection.query(fmt::format("SELECT {}, s.words FROM test_list l LEFT JOIN test_search s ON s.test = l.test "
                                      "AND s.withdrawn = l.withdrawn WHERE l.test BETWEEN $1 AND $2 ORDER BY l.test",
                                      selected),
                          {first, last});
}

Result<void> rename_machine_in_lists(Connection& connection, Id machine, const std::string& name) {
  AXIOMETRY_TRY_VOID(connection.run("UPDATE test_list SET machine_name = $2, machine_key = $3 WHERE machine = $1",
                                    {machine, name, folded(name)}));
  return renew_words(connection, "machine", machine);
}

Result<void> rename_axis_in_lists(Connection& connection, Id axis, const AxisRecord& now) {
  AXIOMETRY_TRY_VOID(
      connection.run("UPDATE test_list SET axis_name = $2, axis_key = $3, axis_kind = $4 WHERE axis = $1",
                     {axis, now.name, folded(now.name), now.kind}));
  return renew_words(connection, "axis", axis);
}

}  // namespace axiometry::store
