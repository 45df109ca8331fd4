// SPDX-License-Identifier: Apache-2.0
#include "axiometry/store/kept/assets.h"

#include <fmt/format.h>

#include <algorithm>

#include "axiometry/base/counted.h"
#include "axiometry/store/kept/asset_tables.h"
#include "axiometry/store/kept/test_list.h"
#include "axiometry/store/proof/audit_trail.h"
#include "axiometry/store/proof/fingerprint.h"

namespace axiometry::store {
namespace {

constexpr std::size_t most_parameters = 600;  // parameters of one INSERT
constexpr std::size_t own_columns = 6;        // id, version, at, actor, reason, sha256

std::string fingerprint(Id id, int version, const Change& change, std::span<const Cell> cells) {
  return Fingerprint()
      .add_cell(Cell(id))
      .add_cell(Cell(std::int64_t{version}))
      .add(change.at)
      .add(change.actor)
      .add(change.reason)
      .add(cells)
      .finish();
}

template <typename Asset>
std::string selection(std::string_view rest) {
  using Table = AssetTable<Asset>;
  std::string columns;
  std::string_view names = Table::columns;
  while (!names.empty()) {
    const std::size_t end = names.find(", ");
    columns += fmt::format(", v.{}", names.substr(0, end));
    names = end == std::string_view::npos ? "" : names.substr(end + 2);
  }
  return fmt::format("SELECT v.id, v.version, v.at, v.actor, v.reason, v.sha256{} FROM {}_version v {}", columns,
                     Table::name, rest);
}

template <typename Asset>
Result<Versioned<Asset>> versioned(const Row& row) {
  AXIOMETRY_TRY(Asset asset, AssetTable<Asset>::asset(row, own_columns));
  return Versioned<Asset>{row.integer(0), row.number(1), {row.text(2), row.text(3), row.text(4)}, std::move(asset)};
}

template <typename Asset>
Result<std::vector<Versioned<Asset>>> all_versioned(const Rows& rows) {
  std::vector<Versioned<Asset>> assets;
  for (const Row& row : rows) {
    AXIOMETRY_TRY(Versioned<Asset> asset, versioned<Asset>(row));
    assets.push_back(std::move(asset));
  }
  return assets;
}

template <typename Asset>
Result<void> write_version(Connection& connection, const Versioned<Asset>& asset, std::string_view what) {
  using Table = AssetTable<Asset>;
  const std::vector<Cell> cells = Table::cells(asset.value);
  const Change& change = asset.change;
  const std::string hash = fingerprint(asset.id, asset.version, change, cells);
  std::vector<Parameter> parameters = {asset.id, asset.version, change.at, change.actor, change.reason, hash};
  for (const Cell& cell : cells) parameters.push_back(parameter(cell));
  AXIOMETRY_TRY_VOID(
      connection.run(fmt::format("INSERT INTO {}_version (id, version, at, actor, reason, sha256, {}) VALUES ({})",
                                 Table::name, Table::columns, places(1, parameters.size())),
                     parameters));
  json::Value detail = json::Value::object();
  detail.add("version", asset.version);
  detail.add("sha256", hash);
  return record(connection, change,
                {fmt::format("{}.{}", Table::name, what), fmt::format("{} {}", Table::name, asset.id), detail});
}

Result<void> follow(Connection& connection, const Versioned<MachineRecord>&, const Versioned<MachineRecord>& now) {
  return rename_machine_in_lists(connection, now.id, now.value.name);
}

/// A test belongs to the machine for good, and its axis with it.
Result<void> follow(Connection& connection, const Versioned<AxisRecord>& before, const Versioned<AxisRecord>& now) {
  if (before.value.machine != now.value.machine)
    return fail(fmt::format("found the machine {} for an axis of machine {}, expected it to stay", now.value.machine,
                            before.value.machine));
  return rename_axis_in_lists(connection, now.id, now.value);
}

Result<void> follow(Connection&, const Versioned<InstrumentRecord>&, const Versioned<InstrumentRecord>&) { return {}; }
Result<void> follow(Connection&, const Versioned<PlanRecord>&, const Versioned<PlanRecord>&) { return {}; }

bool has_same_bytes(const std::vector<KeptFile>& a, const std::vector<KeptFile>& b) {
  return std::ranges::equal(a, b, {}, &KeptFile::content, &KeptFile::content);
}

/// What was measured stays what it was evaluated from.
Result<void> follow(Connection&, const Versioned<CalibrationRecord>& before, const Versioned<CalibrationRecord>& now) {
  if (before.value.kind != now.value.kind || !has_same_bytes(before.value.files, now.value.files))
    return fail(fmt::format(
        "found another kind or other files for calibration {}, expected those that it was kept with", now.id));
  return {};
}

/// What is in the control stays what it was made of.
Result<void> follow(Connection&, const Versioned<CompensationRecord>& before,
                    const Versioned<CompensationRecord>& now) {
  const CompensationRecord &a = before.value, &b = now.value;
  if (a.test == b.test && a.test_version == b.test_version && a.axis == b.axis && a.control == b.control &&
      a.options == b.options && has_same_bytes(a.files, b.files))
    return {};
  return fail(
      fmt::format("found another test, control or other files for compensation {}, expected those that it was "
                  "kept with",
                  now.id));
}

/// What the trail says was done to an asset.
template <typename Asset>
std::string_view deed(const Versioned<Asset>&, const Versioned<Asset>&) {
  return "changed";
}

template <typename Asset>
requires requires(const Asset& asset) { asset.withdrawn; }
std::string_view deed(const Versioned<Asset>& before, const Versioned<Asset>& now) {
  if (before.value.withdrawn == now.value.withdrawn) return "changed";
  return now.value.withdrawn ? "withdrawn" : "reinstated";
}

}  // namespace

std::string places(std::size_t first, std::size_t count) {
  std::string text;
  for (std::size_t k = 0; k < count; ++k) text += fmt::format("{}${}", k == 0 ? "" : ", ", first + k);
  return text;
}

std::vector<Parameter> parameters_of(const std::vector<Cell>& cells) {
  std::vector<Parameter> parameters;
  for (const Cell& cell : cells) parameters.push_back(parameter(cell));
  return parameters;
}

Result<void> insert_rows(Connection& connection, std::string_view table, std::string_view columns,
                         std::span<const Row> rows) {
  if (rows.empty()) return {};
  const std::size_t width = rows[0].cells().size();
  const std::size_t at_once = std::max<std::size_t>(1, most_parameters / width);
  for (std::size_t first = 0; first < rows.size(); first += at_once) {
    std::string values;
    std::vector<Parameter> parameters;
    for (const Row& row : rows.subspan(first, std::min(at_once, rows.size() - first))) {
      values += fmt::format("{}({})", values.empty() ? "" : ", ", places(parameters.size() + 1, width));
      for (const Cell& cell : row.cells()) parameters.push_back(parameter(cell));
    }
    AXIOMETRY_TRY_VOID(connection.run(fmt::format("INSERT INTO {} {}{}{} VALUES {}", table, columns.empty() ? "" : "(",
                                                  columns, columns.empty() ? "" : ")", values),
                                      parameters));
  }
  return {};
}

Result<Id> next_id(Connection& connection, std::string_view table) {
  AXIOMETRY_TRY(const Rows rows, connection.query(fmt::format("SELECT coalesce(max(id), 0) + 1 FROM {}", table)));
  return rows[0].integer(0);
}

template <typename Asset>
Result<Versioned<Asset>> add_asset(Connection& connection, const Asset& asset, const Change& change) {
  using Table = AssetTable<Asset>;
  AXIOMETRY_TRY_VOID(Table::check(connection, asset));
  AXIOMETRY_TRY(const Id id, next_id(connection, Table::name));
  Versioned<Asset> added{id, 1, change, asset};
  AXIOMETRY_TRY_VOID(connection.run(fmt::format("INSERT INTO {} (id, latest) VALUES ($1, 1)", Table::name), {id}));
  AXIOMETRY_TRY_VOID(write_version(connection, added, "added"));
  return added;
}

template <typename Asset>
Result<Versioned<Asset>> change_asset(Connection& connection, const Versioned<Asset>& changed) {
  using Table = AssetTable<Asset>;
  AXIOMETRY_TRY(const Versioned<Asset> latest, get_asset<Asset>(connection, changed.id));
  if (changed.version != latest.version + 1)
    return fail(ErrorKind::conflict,
                fmt::format("found version {} of this {}, made by {} at {}, expected version {} to be the latest",
                            latest.version, Table::name, latest.change.actor, latest.change.at, changed.version - 1));
  AXIOMETRY_TRY_VOID(Table::check(connection, changed.value));
  AXIOMETRY_TRY_VOID(connection.run(fmt::format("UPDATE {} SET latest = $2 WHERE id = $1", Table::name),
                                    {changed.id, changed.version}));
  AXIOMETRY_TRY_VOID(write_version(connection, changed, deed(latest, changed)));
  AXIOMETRY_TRY_VOID(follow(connection, latest, changed));
  return changed;
}

template <typename Asset>
Result<Versioned<Asset>> get_asset(Connection& connection, Id id, std::optional<int> version) {
  using Table = AssetTable<Asset>;
  const std::string latest = fmt::format("(SELECT latest FROM {} WHERE id = $1)", Table::name);
  std::vector<Parameter> parameters = {id};
  if (version) parameters.emplace_back(*version);
  AXIOMETRY_TRY(const Rows rows, connection.query(selection<Asset>(fmt::format("WHERE v.id = $1 AND v.version = {}",
                                                                               version ? "$2" : latest.c_str())),
                                                  parameters));
  if (rows.empty())
    return fail(ErrorKind::not_found, fmt::format("found no {} {}{}, expected one", Table::name, id,
                                                  version ? fmt::format(" in version {}", *version) : ""));
  return versioned<Asset>(rows[0]);
}

template <typename Asset>
Result<std::vector<Versioned<Asset>>> latest_assets(Connection& connection, std::string_view rest,
                                                    std::span<const Parameter> parameters) {
  AXIOMETRY_TRY(const Rows rows,
                connection.query(selection<Asset>(fmt::format("JOIN {} t ON t.id = v.id AND t.latest = v.version {}",
                                                              AssetTable<Asset>::name, rest)),
                                 parameters));
  return all_versioned<Asset>(rows);
}

template <typename Asset>
Result<std::vector<Versioned<Asset>>> all_assets(Connection& connection) {
  return latest_assets<Asset>(connection, "ORDER BY v.id", {});
}

Result<std::vector<Versioned<AxisRecord>>> axes_of(Connection& connection, Id machine) {
  return latest_assets<AxisRecord>(connection, "WHERE v.machine = $1 ORDER BY v.id", std::vector<Parameter>{machine});
}

template <typename Asset>
Result<std::vector<Versioned<Asset>>> asset_versions(Connection& connection, Id id) {
  AXIOMETRY_TRY(const Rows rows, connection.query(selection<Asset>("WHERE v.id = $1 ORDER BY v.version"), {id}));
  if (rows.empty())
    return fail(ErrorKind::not_found, fmt::format("found no {} {}, expected one", AssetTable<Asset>::name, id));
  return all_versioned<Asset>(rows);
}

template <typename Asset>
Result<void> verify_assets(Connection& connection, const Attested& attested, std::vector<std::string>& problems) {
  using Table = AssetTable<Asset>;
  AXIOMETRY_TRY(const Rows heads, connection.query(fmt::format("SELECT id, latest FROM {} ORDER BY id", Table::name)));
  AXIOMETRY_TRY(const Rows rows, connection.query(selection<Asset>("ORDER BY v.id, v.version")));
  auto row = rows.begin();
  for (std::size_t k = 0; k < heads.size(); ++k) {
    const Id id = heads[k].integer(0);
    const std::string subject = fmt::format("{} {}", Table::name, id);
    if (id != static_cast<Id>(k) + 1)
      problems.push_back(fmt::format("{}: found the number {}, expected {}", Table::name, id, k + 1));
    int version = 0;
    for (; row != rows.end() && row->integer(0) == id; ++row) {
      if (row->number(1) != ++version)
        problems.push_back(fmt::format("{}: found version {}, expected {}", subject, row->number(1), version));
      const auto fields = std::span(row->cells()).subspan(own_columns);
      const std::string hash = fingerprint(id, row->number(1), {row->text(2), row->text(3), row->text(4)}, fields);
      if (hash != row->text(5) || !attested.knows(subject, row->number(1), hash))
        problems.push_back(fmt::format("{}: found version {} changed after it was kept", subject, row->number(1)));
    }
    if (version != heads[k].number(1))
      problems.push_back(fmt::format("{}: found {}, expected {}", subject,
                                     counted(static_cast<std::size_t>(version), "version"), heads[k].number(1)));
  }
  if (attested.count(Table::name) != static_cast<std::int64_t>(rows.size()))
    problems.push_back(fmt::format("{}: found {}, expected the {} of the audit trail", Table::name,
                                   counted(rows.size(), "version"), attested.count(Table::name)));
  return {};
}

#define AXIOMETRY_ASSET(Asset)                                                                       \
  template Result<Versioned<Asset>> add_asset(Connection&, const Asset&, const Change&);             \
  template Result<Versioned<Asset>> change_asset(Connection&, const Versioned<Asset>&);              \
  template Result<Versioned<Asset>> get_asset<Asset>(Connection&, Id, std::optional<int>);           \
  template Result<std::vector<Versioned<Asset>>> latest_assets<Asset>(Connection&, std::string_view, \
                                                                      std::span<const Parameter>);   \
  template Result<std::vector<Versioned<Asset>>> all_assets<Asset>(Connection&);                     \
  template Result<std::vector<Versioned<Asset>>> asset_versions<Asset>(Connection&, Id);             \
  template Result<void> verify_assets<Asset>(Connection&, const Attested&, std::vector<std::string>&)

AXIOMETRY_ASSET(MachineRecord);
AXIOMETRY_ASSET(AxisRecord);
AXIOMETRY_ASSET(InstrumentRecord);
AXIOMETRY_ASSET(PlanRecord);
AXIOMETRY_ASSET(CalibrationRecord);
AXIOMETRY_ASSET(CompensationRecord);

#undef AXIOMETRY_ASSET

}  // namespace axiometry::store
