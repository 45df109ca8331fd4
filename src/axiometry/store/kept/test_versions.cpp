// SPDX-License-Identifier: Apache-2.0
#include "axiometry/store/kept/test_versions.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "axiometry/base/json/json.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/store/kept/assets.h"
#include "axiometry/store/proof/fingerprint.h"

namespace axiometry::store {
namespace {

constexpr std::string_view version_columns =
    "test, version, at, actor, reason, sha256, title, machine, axis, axis_name, axis_kind, plan, measured_on, changes";
constexpr std::string_view evaluation_columns =
    "test, version, program, standard, options, seed, unit, conforming, verdict, label, result";
constexpr std::size_t longest_date = 200;  // an index has no room for more
constexpr std::string_view figure_columns =
    "test, version, place, parameter, value, expanded_uncertainty, tolerance, verdict, low, high, method";

/// Without sha256, in the order of version_columns.
std::vector<Cell> cells_of(const TestVersion& v) {
  return {v.test,       std::int64_t{v.version}, v.change.at,  v.change.actor, v.change.reason,
          v.title,      cell(v.machine),         cell(v.axis), v.axis_name,    v.axis_kind,
          cell(v.plan), v.measured_on,           v.changes};
}

std::vector<Cell> cells_of(const EvaluationRecord& e) {
  return {e.program, e.standard,
          e.options, e.seed ? Cell(fmt::format("{}", *e.seed)) : Cell(),
          e.unit,    std::int64_t{e.conforming},
          e.verdict, e.label,
          e.result};
}

std::vector<Cell> cells_of(const FigureRecord& f) {
  return {f.parameter, f.value, cell(f.U), cell(f.limit), f.verdict, cell(f.low), cell(f.high), f.method};
}

/// As they were fingerprinted before there was a method of record, where there is none.
std::span<const Cell> attested(std::span<const Cell> cells, const FigureRecord& figure) {
  constexpr std::size_t of_record = 3;
  return figure.method.empty() ? cells.first(cells.size() - of_record) : cells;
}

TestVersion version_from(const Row& row) {
  TestVersion version;
  version.test = row.integer(0);
  version.version = row.number(1);
  version.change = {row.text(2), row.text(3), row.text(4)};
  version.sha256 = row.text(5);
  version.title = row.text(6);
  version.machine = row.optional_integer(7);
  version.axis = row.optional_integer(8);
  version.axis_name = row.text(9);
  version.axis_kind = row.text(10);
  version.plan = row.optional_integer(11);
  version.measured_on = row.text(12);
  version.changes = row.text(13);
  return version;
}

EvaluationRecord evaluation_from(const Row& row) {
  EvaluationRecord evaluation;
  evaluation.program = row.text(2);
  evaluation.standard = row.text(3);
  evaluation.options = row.text(4);
  if (!row.null(5)) {
    evaluation.seed = parse_count(row.text(5));
    if (!evaluation.seed || fmt::format("{}", *evaluation.seed) != row.text(5)) throw DamagedCell();
  }
  evaluation.unit = row.text(6);
  evaluation.conforming = row.flag(7);
  evaluation.verdict = row.text(8);
  evaluation.label = row.text(9);
  evaluation.result = row.text(10);
  return evaluation;
}

Result<void> write_row(Connection& connection, std::string_view table, std::string_view columns,
                       const std::vector<Parameter>& parameters) {
  return connection.run(fmt::format("INSERT INTO {} ({}) VALUES ({})", table, columns, places(1, parameters.size())),
                        parameters);
}

Result<void> check_json(const std::string& text, std::string_view what) {
  const auto parsed = json::parse(text);
  if (!parsed) return fail(fmt::format("found no JSON as {}: {}", what, parsed.error().message));
  return {};
}

/// Versions of tests that follow each other: all, or the one of that number.
struct WantedVersions {
  Id first;
  Id last;
  std::optional<int> version{};
};

/// Rows of a table that belong to these versions, in their order.
Result<Rows> rows_of(Connection& connection, std::string_view columns, std::string_view table, std::string_view order,
                     const WantedVersions& wanted) {
  std::vector<Parameter> parameters = {wanted.first, wanted.last};
  if (wanted.version) parameters.emplace_back(*wanted.version);
  return connection.query(fmt::format("SELECT {} FROM {} WHERE test BETWEEN $1 AND $2{} ORDER BY {}", columns, table,
                                      wanted.version ? " AND version = $3" : "", order),
                          parameters);
}

Result<std::vector<TestVersion>> read_wanted(Connection& connection, const WantedVersions& wanted) {
  AXIOMETRY_TRY(const Rows rows, rows_of(connection, version_columns, "test_version", "test, version", wanted));
  AXIOMETRY_TRY(const Rows evaluations, rows_of(connection, evaluation_columns, "evaluation", "test, version", wanted));
  AXIOMETRY_TRY(const Rows instruments, rows_of(connection, "test, version, instrument, instrument_version",
                                                "test_instrument", "test, version, place", wanted));
  AXIOMETRY_TRY(const Rows figures, rows_of(connection, figure_columns, "figure", "test, version, place", wanted));
  std::vector<TestVersion> versions;
  std::map<std::pair<Id, int>, std::size_t> place;
  for (const Row& row : rows) {
    place[{row.integer(0), row.number(1)}] = versions.size();
    versions.push_back(version_from(row));
  }
  const auto of = [&](const Row& row) -> TestVersion& {
    const auto found = place.find({row.integer(0), row.number(1)});
    if (found == place.end()) throw DamagedCell();  // belongs to nothing, which the database does not allow
    return versions[found->second];
  };
  for (const Row& row : evaluations) of(row).evaluation = evaluation_from(row);
  for (const Row& row : instruments) of(row).instruments.push_back({row.integer(2), row.number(3)});
  for (const Row& row : figures) of(row).evaluation.figures.push_back(figure_of(row, 3));
  return versions;
}

}  // namespace

FigureRecord figure_of(const Row& row, std::size_t first) {
  return {.parameter = row.text(first),
          .value = row.real(first + 1),
          .U = row.optional_real(first + 2),
          .limit = row.optional_real(first + 3),
          .verdict = row.text(first + 4),
          .low = row.optional_real(first + 5),
          .high = row.optional_real(first + 6),
          .method = row.text(first + 7)};
}

std::string fingerprint(const TestVersion& version) {
  Fingerprint print;
  print.add(cells_of(version)).add(cells_of(version.evaluation));
  for (const InstrumentUse& use : version.instruments)
    print.add_cell(Cell(use.instrument)).add_cell(Cell(std::int64_t{use.version}));
  for (const FigureRecord& figure : version.evaluation.figures) {
    const std::vector<Cell> cells = cells_of(figure);
    print.add(attested(cells, figure));
  }
  return print.finish();
}

Result<TestVersion> version_of(Connection& connection, const TestState& state, const Change& change,
                               StatedAssets& stated) {
  AXIOMETRY_TRY_VOID(check_json(state.changes, "changes"));
  AXIOMETRY_TRY_VOID(check_json(state.evaluation.options, "options"));
  if (state.measured_on.size() > longest_date)
    return fail(fmt::format("found a date of {} bytes, expected at most {}", state.measured_on.size(), longest_date));
  TestVersion version;
  version.change = change;
  version.title = state.title;
  version.axis_name = state.axis.name;
  version.axis_kind = state.axis.kind;
  version.plan = state.plan;
  version.measured_on = state.measured_on;
  version.changes = state.changes;
  version.evaluation = state.evaluation;
  if (state.plan)
    if (const auto plan = get_asset<PlanRecord>(connection, *state.plan); !plan) return std::unexpected(plan.error());
  AXIOMETRY_TRY(version.machine, stated.machine(state.machine));
  if (version.machine) {
    AXIOMETRY_TRY(version.axis, stated.axis(*version.machine, state.axis));
  }
  std::set<std::pair<Id, int>> used;
  for (const InstrumentRecord& instrument : state.instruments) {
    AXIOMETRY_TRY(const auto use, stated.instrument(instrument));
    if (use && used.emplace(use->instrument, use->version).second) version.instruments.push_back(*use);
  }
  return version;
}

Result<void> write_version(Connection& connection, TestVersion& version) {
  version.sha256 = fingerprint(version);
  const std::vector<Cell> fields = cells_of(version);
  std::vector<Parameter> parameters = parameters_of(fields);
  parameters.insert(parameters.begin() + 5, std::string_view(version.sha256));
  AXIOMETRY_TRY_VOID(write_row(connection, "test_version", version_columns, parameters));
  for (std::size_t k = 0; k < version.instruments.size(); ++k)
    AXIOMETRY_TRY_VOID(write_row(connection, "test_instrument", "test, version, place, instrument, instrument_version",
                                 {version.test, version.version, static_cast<std::int64_t>(k + 1),
                                  version.instruments[k].instrument, version.instruments[k].version}));
  const std::vector<Cell> evaluation = cells_of(version.evaluation);
  parameters = {version.test, version.version};
  for (const Cell& value : evaluation) parameters.push_back(parameter(value));
  AXIOMETRY_TRY_VOID(write_row(connection, "evaluation", evaluation_columns, parameters));
  Rows figures;
  for (const FigureRecord& figure : version.evaluation.figures) {
    std::vector<Cell> cells = {version.test, std::int64_t{version.version},
                               static_cast<std::int64_t>(figures.size() + 1)};
    for (Cell& value : cells_of(figure)) cells.push_back(std::move(value));
    figures.emplace_back(std::move(cells));
  }
  return insert_rows(connection, "figure", figure_columns, figures);
}

Result<std::vector<TestHead>> read_heads(Connection& connection, Id first, Id last) {
  AXIOMETRY_TRY(const Rows rows,
                connection.query("SELECT id, content, file_name, format, name_in_file, at, actor, reason, latest, "
                                 "withdrawn FROM test WHERE id BETWEEN $1 AND $2 ORDER BY id",
                                 {first, last}));
  std::vector<TestHead> heads;
  for (const Row& row : rows)
    heads.push_back({.id = row.integer(0),
                     .sha256 = row.text(1),
                     .file_name = row.text(2),
                     .format = row.text(3),
                     .name_in_file = row.text(4),
                     .received = {row.text(5), row.text(6), row.text(7)},
                     .latest = row.number(8),
                     .withdrawn = row.flag(9)});
  return heads;
}

Result<TestHead> read_head(Connection& connection, Id test) {
  AXIOMETRY_TRY(const std::vector<TestHead> heads, read_heads(connection, test, test));
  if (heads.empty()) return fail(ErrorKind::not_found, fmt::format("found no test {}, expected one", test));
  return heads[0];
}

Result<std::vector<TestVersion>> read_versions(Connection& connection, Id first, Id last) {
  return read_wanted(connection, {first, last});
}

/// Not by way of all: who edits a test again and again would read more each time.
Result<TestVersion> read_version(Connection& connection, Id test, int version) {
  AXIOMETRY_TRY(std::vector<TestVersion> versions, read_wanted(connection, {test, test, version}));
  if (versions.empty())
    return fail(ErrorKind::not_found, fmt::format("found no version {} of test {}, expected one", version, test));
  return std::move(versions[0]);
}

}  // namespace axiometry::store
