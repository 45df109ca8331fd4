// SPDX-License-Identifier: Apache-2.0
#include "axiometry/store/database/migrations.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>

#include "axiometry/base/text/number_text.h"
#include "axiometry/digest/sha256.h"
#include "axiometry/store/database/clock.h"

namespace axiometry::store {
namespace {

struct Migration {
  std::string name;
  std::string sql;
  std::string sha256;
};

using Migrations = std::map<int, Migration>;

int number_of(std::string_view file) { return static_cast<int>(parse_count(file.substr(0, 4)).value_or(0)); }

/// Of this kind of database, its parts put together.
Migrations migrations(bool sqlite) {
  Migrations all;
  for (const EmbeddedFile& file : migration_files()) {
    if (file.name.ends_with(sqlite ? ".postgresql.sql" : ".sqlite.sql")) continue;
    Migration& migration = all[number_of(file.name)];
    migration.sql += file.bytes;
    const bool common = file.name.find('.') == file.name.rfind('.');
    if (common && migration.name.empty()) migration.name = file.name.substr(7, file.name.find('.') - 7);
  }
  for (auto& [number, migration] : all) migration.sha256 = sha256(migration.sql);
  return all;
}

constexpr const char* table_of_migrations = R"(
CREATE TABLE migration (
  number integer PRIMARY KEY,
  name text NOT NULL,
  sha256 text NOT NULL,
  at text NOT NULL
))";

Result<bool> has_table(Connection& connection, std::string_view name) {
  AXIOMETRY_TRY(const Rows rows,
                connection.query(connection.is_sqlite()
                                     ? "SELECT count(*) FROM sqlite_master WHERE type = 'table' AND name = $1"
                                     : "SELECT count(*) FROM pg_catalog.pg_tables WHERE schemaname = current_schema() "
                                       "AND tablename = $1",
                                 {name}));
  return rows[0].integer(0) > 0;
}

/// How many of ours the archive has, which must be the first ones as we know them.
Result<int> applied(Connection& connection, const Migrations& ours) {
  AXIOMETRY_TRY(const bool begun, has_table(connection, "migration"));
  if (!begun) return 0;
  AXIOMETRY_TRY(const Rows rows, connection.query("SELECT number, sha256 FROM migration ORDER BY number"));
  const int last = rows.empty() ? 0 : rows.back().number(0);
  if (last > newest_schema())
    return fail(
        fmt::format("found schema {}, expected at most {}: written by a newer Axiometry", last, newest_schema()));
  int expected = 1;
  for (const Row& row : rows) {
    const auto known = ours.find(row.number(0));
    if (row.number(0) != expected++ || known == ours.end() || known->second.sha256 != row.text(1))
      return fail(ErrorKind::damaged,
                  fmt::format("found migration {} with the SHA-256 {}, expected {}: made by another program",
                              row.number(0), row.text(1), known == ours.end() ? "none" : known->second.sha256));
  }
  return last;
}

/// Those behind the first `there`, within a transaction that the caller has begun.
Result<void> apply_missing(Connection& connection, const Migrations& ours, int there) {
  for (const auto& [number, migration] : ours) {
    if (number <= there) continue;
    AXIOMETRY_TRY_VOID(connection.script(migration.sql));
    AXIOMETRY_TRY_VOID(
        connection.run("INSERT INTO migration (number, name, sha256, at) VALUES ($1, $2, $3, $4)",
                       {std::int64_t{number}, std::string_view(migration.name), migration.sha256, now_text()}));
  }
  return {};
}

}  // namespace

int newest_schema() {
  int newest = 0;
  for (const EmbeddedFile& file : migration_files()) newest = std::max(newest, number_of(file.name));
  return newest;
}

Result<int> migrate(Connection& connection) {
  const Migrations ours = migrations(connection.is_sqlite());
  AXIOMETRY_TRY(const int before, applied(connection, ours));
  if (before == newest_schema()) return before;
  AXIOMETRY_TRY_VOID(connection.begin_write());
  Rollback rollback(connection);
  AXIOMETRY_TRY(const int there, applied(connection, ours));  // again, now that nobody else can do the same
  AXIOMETRY_TRY(const bool begun, has_table(connection, "migration"));
  if (!begun) AXIOMETRY_TRY_VOID(connection.run(table_of_migrations));
  AXIOMETRY_TRY_VOID(apply_missing(connection, ours, there));
  AXIOMETRY_TRY_VOID(connection.commit());
  rollback.release();
  return newest_schema();
}

Result<void> make_tables(Connection& connection) {
  AXIOMETRY_TRY_VOID(connection.run(table_of_migrations));
  return apply_missing(connection, migrations(connection.is_sqlite()), 0);
}

Result<int> check_schema(Connection& connection) {
  AXIOMETRY_TRY(const int there, applied(connection, migrations(connection.is_sqlite())));
  if (there == 0) return fail(ErrorKind::not_found, "found no archive, expected a store");
  if (there < newest_schema())
    return fail(ErrorKind::read_only,
                fmt::format("found schema {}, expected {}: it must be opened once where it can be written", there,
                            newest_schema()));
  return there;
}

Result<std::vector<std::string>> other_migrations(Connection& connection) {
  std::vector<std::string> said;
  Migrations missing = migrations(connection.is_sqlite());
  AXIOMETRY_TRY(const Rows rows, connection.query("SELECT number, name, sha256 FROM migration ORDER BY number"));
  for (const Row& row : rows) {
    const auto ours = std::ranges::find(missing, row.integer(0), [](const auto& each) { return each.first; });
    if (ours == missing.end() || ours->second.name != row.text(1) || ours->second.sha256 != row.text(2))
      said.push_back(fmt::format("migration {}: found {} with the SHA-256 {}, expected {}", row.integer(0), row.text(1),
                                 row.text(2), ours == missing.end() ? "none" : "the one of this program"));
    if (ours != missing.end()) missing.erase(ours);
  }
  for (const auto& [number, migration] : missing)
    said.push_back(fmt::format("migration {}: found none, expected {}", number, migration.name));
  return said;
}

std::string migration_text(bool sqlite) {
  std::string text = table_of_migrations;
  for (const auto& [number, migration] : migrations(sqlite)) text += "\n" + migration.sql;
  return text;
}

}  // namespace axiometry::store
