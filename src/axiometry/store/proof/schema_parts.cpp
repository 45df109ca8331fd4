// SPDX-License-Identifier: Apache-2.0
#include "axiometry/store/proof/schema_parts.h"

#include <fmt/format.h>

#include <algorithm>

#include "axiometry/base/text/text.h"
#include "axiometry/store/database/migrations.h"
#include "axiometry/store/database/sqlite_connection.h"

namespace axiometry::store {
namespace {

/// At the end of the definition of an index by which the database may refuse a row: a unique one, or one that computes
/// something, its condition included. The queries below spell it so.
constexpr std::string_view may_refuse = ", may refuse rows";

/// At that of a trigger that is off for who writes here: it was switched off, or fires in replicas only.
constexpr std::string_view switched_off = ", switched off";

constexpr std::string_view parts_of_sqlite =
    "SELECT type || ' ' || name || CASE WHEN type = 'table' THEN '' ELSE ' of ' || tbl_name END, coalesce(sql, '') || "
    "CASE WHEN type = 'index' AND (EXISTS (SELECT 1 FROM pragma_index_list(m.tbl_name) l WHERE l.name = m.name AND "
    "(l.\"unique\" OR l.partial)) OR EXISTS (SELECT 1 FROM pragma_index_info(m.name) i WHERE i.cid = -2)) THEN ', may "
    "refuse rows' ELSE '' END FROM sqlite_master m WHERE NOT (type = 'table' AND name IN ('sqlite_stat1', "
    "'sqlite_stat4'))";

/// Each gives name and definition. Definitions name no schema, because the one that is looked at is the first of the
/// search path. A trigger that was switched off stands in the catalogue as it did; so do those behind a reference. Who
/// reads a table also reads those that inherit from it, in whatever schema they are.
constexpr std::string_view parts_of_postgresql[] = {
    "SELECT 'table ' || c.relname, concat_ws(' ', c.relkind::text, c.relpersistence::text, c.relrowsecurity::text, "
    "CASE WHEN c.relkind IN ('v', 'm') THEN pg_get_viewdef(c.oid) END) FROM pg_class c WHERE c.relkind IN ('r', 'p', "
    "'v', 'm', 'f', 'S') AND c.relnamespace = quote_ident(current_schema())::regnamespace AND NOT EXISTS (SELECT 1 "
    "FROM pg_depend d "
    "WHERE d.classid = 'pg_class'::regclass AND d.objid = c.oid AND d.deptype = 'e')",

    "SELECT 'column ' || a.attname || ' of ' || c.relname, concat_ws(' ', a.attnum::text, format_type(a.atttypid, "
    "a.atttypmod), l.collname::text, CASE WHEN a.attnotnull THEN 'not null' END, pg_get_expr(e.adbin, e.adrelid)) FROM "
    "pg_attribute a JOIN pg_class c ON c.oid = a.attrelid LEFT JOIN pg_attrdef e ON e.adrelid = a.attrelid AND e.adnum "
    "= a.attnum LEFT JOIN pg_collation l ON l.oid = a.attcollation WHERE a.attnum > 0 AND NOT a.attisdropped AND "
    "c.relkind IN ('r', 'p') AND c.relnamespace = quote_ident(current_schema())::regnamespace",

    "SELECT 'constraint ' || k.conname || ' of ' || c.relname, concat_ws(' ', pg_get_constraintdef(k.oid, true), CASE "
    "WHEN NOT k.convalidated THEN 'not validated' END) FROM pg_constraint k JOIN pg_class c ON c.oid = k.conrelid "
    "WHERE "
    "c.relnamespace = quote_ident(current_schema())::regnamespace",

    "SELECT 'index ' || i.relname || ' of ' || c.relname, concat_ws(' ', pg_get_indexdef(x.indexrelid, 0, true), CASE "
    "WHEN NOT x.indisvalid THEN 'not valid' END) || CASE WHEN x.indisunique OR x.indexprs IS NOT NULL OR x.indpred IS "
    "NOT NULL THEN ', may refuse rows' ELSE '' END FROM pg_index x JOIN pg_class i ON i.oid = x.indexrelid JOIN "
    "pg_class c ON c.oid = x.indrelid WHERE c.relkind IN ('r', 'p') AND c.relnamespace = "
    "quote_ident(current_schema())::regnamespace",

    "SELECT 'inheritance ' || CASE WHEN c.relnamespace = p.relnamespace THEN c.relname ELSE c.oid::regclass::text END "
    "|| ' of ' || p.relname, '' FROM pg_inherits h JOIN pg_class c ON c.oid = h.inhrelid JOIN pg_class p ON p.oid = "
    "h.inhparent WHERE c.relkind IN ('r', 'p', 'f') AND p.relnamespace = quote_ident(current_schema())::regnamespace",

    "SELECT 'trigger ' || t.tgname || ' of ' || c.relname, pg_get_triggerdef(t.oid, true) || CASE t.tgenabled WHEN 'O' "
    "THEN '' WHEN 'A' THEN ', on in replicas, too' WHEN 'R' THEN ', on in replicas only, switched off' ELSE ', "
    "switched off' END FROM pg_trigger t JOIN pg_class c ON c.oid = t.tgrelid WHERE NOT t.tgisinternal AND "
    "c.relnamespace = quote_ident(current_schema())::regnamespace",

    "SELECT 'reference ' || k.conname || ' (' || p.proname || ' of ' || c.relname || ')', 'trigger' || CASE "
    "t.tgenabled WHEN 'O' THEN '' WHEN 'A' THEN ', on in replicas, too' WHEN 'R' THEN ', on in replicas only, switched "
    "off' ELSE ', switched off' END FROM pg_trigger t JOIN pg_class c ON c.oid = t.tgrelid JOIN pg_constraint k ON "
    "k.oid = t.tgconstraint JOIN pg_proc p ON p.oid = t.tgfoid WHERE "
    "t.tgisinternal AND c.relnamespace = quote_ident(current_schema())::regnamespace",

    "SELECT 'function ' || p.proname || '(' || pg_get_function_identity_arguments(p.oid) || ')', concat_ws(' ', "
    "l.lanname::text, pg_get_function_result(p.oid), p.prokind::text, p.provolatile::text, p.prosecdef::text, "
    "p.proconfig::text, p.prosrc) FROM pg_proc p JOIN pg_language l ON l.oid = p.prolang WHERE p.pronamespace = "
    "quote_ident(current_schema())::regnamespace AND NOT EXISTS (SELECT 1 FROM pg_depend d WHERE d.classid = "
    "'pg_proc'::regclass AND "
    "d.objid = p.oid AND d.deptype = 'e')",

    "SELECT 'domain ' || t.typname, concat_ws(' ', format_type(t.typbasetype, t.typtypmod), l.collname::text, "
    "t.typnotnull::text, t.typdefault) FROM pg_type t LEFT JOIN pg_collation l ON l.oid = t.typcollation WHERE "
    "t.typtype = 'd' AND t.typnamespace = quote_ident(current_schema())::regnamespace",

    "SELECT 'rule ' || r.rulename || ' of ' || c.relname, pg_get_ruledef(r.oid, true) FROM pg_rewrite r JOIN pg_class "
    "c "
    "ON c.oid = r.ev_class WHERE r.rulename <> '_RETURN' AND c.relnamespace = "
    "quote_ident(current_schema())::regnamespace",

    "SELECT 'policy ' || y.polname || ' of ' || c.relname, pg_get_expr(y.polqual, y.polrelid) FROM pg_policy y JOIN "
    "pg_class c ON c.oid = y.polrelid WHERE c.relnamespace = quote_ident(current_schema())::regnamespace",
};

Result<void> collect(Connection& connection, std::string_view sql, SchemaParts& parts) {
  AXIOMETRY_TRY(const Rows rows, connection.query(sql));
  for (const Row& row : rows) parts[row.text(0)] = row.null(1) ? "" : row.text(1);
  return {};
}

Result<SchemaParts> expected_of_sqlite() {
  AXIOMETRY_TRY(SqliteDatabase database, open_sqlite(":memory:", SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE));
  SqliteConnection connection(std::move(database));
  AXIOMETRY_TRY_VOID(make_tables(connection));
  return schema_parts(connection);
}

/// Nothing of it is ever committed, and nobody else sees it.
Result<SchemaParts> expected_of_postgresql(const Place& place) {
  AXIOMETRY_TRY(const std::unique_ptr<Connection> connection, place.connect());
  AXIOMETRY_TRY(const Rows standby, connection->query("SELECT pg_is_in_recovery()"));
  if (standby[0].flag(0))
    return fail(ErrorKind::read_only, "its server is a standby, where no tables can be made to compare them");
  AXIOMETRY_TRY_VOID(connection->script("BEGIN ISOLATION LEVEL READ COMMITTED READ WRITE"));
  const Rollback rollback(*connection);
  AXIOMETRY_TRY(const Rows own, connection->query("SELECT 'axiometry_comparison_' || pg_backend_pid()"));
  AXIOMETRY_TRY_VOID(connection->script(fmt::format("CREATE SCHEMA {0}; SET LOCAL search_path = {0}", own[0].text(0))));
  AXIOMETRY_TRY_VOID(make_tables(*connection));
  return schema_parts(*connection);
}

/// From a little in front of where they part.
std::pair<std::string, std::string> where_they_part(std::string_view found, std::string_view expected) {
  constexpr std::size_t in_front = 12;
  const auto part = static_cast<std::size_t>(std::ranges::mismatch(found, expected).in1 - found.begin());
  const std::size_t from = part - std::min(part, in_front);
  return {text::quoted(found.substr(from)), text::quoted(expected.substr(from))};
}

/// "figure" of "index by_value of figure"; empty of what belongs to no table.
std::string_view table_of(std::string_view name) {
  const std::size_t of = name.rfind(" of ");
  return of == std::string_view::npos ? "" : name.substr(of + 4);
}

bool is_table(std::string_view name) { return name.starts_with("table "); }

/// What only answers, and takes no part in what the archive's own tables keep.
bool is_harmless(std::string_view name, std::string_view definition) {
  return is_table(name) || name.starts_with("view ") ||
         (name.starts_with("index ") && !definition.ends_with(may_refuse));
}

void add_missing(SchemaDifferences& said, std::string_view name) {
  const std::string& told =
      said.problems.emplace_back(fmt::format("{}: found none, expected the one of schema {}", name, newest_schema()));
  said.of_tables |= is_table(name);
  if (name.starts_with("index ")) said.missing_indexes.push_back(told);
}

/// A column, constraint or index of a table that is extra itself, which is told of the table, or what inherits from it
/// and is extra as well. Not what acts by itself.
bool belongs_to_extra_table(std::string_view name, const SchemaParts& found, const SchemaParts& expected) {
  constexpr std::string_view inheritance = "inheritance ";
  const auto is_extra = [&](std::string_view table) {
    const std::string part = fmt::format("table {}", table);
    return found.contains(part) && !expected.contains(part);
  };
  if (name.starts_with(inheritance)) {
    const std::string_view heir = name.substr(inheritance.size(), name.rfind(" of ") - inheritance.size());
    return is_extra(heir) && is_extra(table_of(name));
  }
  return (name.starts_with("column ") || name.starts_with("constraint ") || name.starts_with("index ")) &&
         is_extra(table_of(name));
}

/// "trigger audit_unchanged" of each statement that makes something.
std::vector<std::string> names_in(std::string_view sql) {
  std::vector<std::string> names;
  for (const std::string_view line : text::split(sql, '\n')) {
    const auto words = text::split(line, ' ');
    if (words.size() < 3 || words[0] != "CREATE") continue;
    names.push_back(fmt::format("{} {}", text::to_lower(words[1]), words[2].substr(0, words[2].find('('))));
  }
  return names;
}

/// Whether a part begins so, before "of" or a list of arguments.
bool has_part(const SchemaParts& parts, const std::string& name) {
  const auto part = parts.lower_bound(name);
  if (part == parts.end() || !part->first.starts_with(name)) return false;
  const std::string_view rest = std::string_view(part->first).substr(name.size());
  return rest.empty() || rest[0] == ' ' || rest[0] == '(';
}

}  // namespace

Result<SchemaParts> schema_parts(Connection& connection) {
  SchemaParts parts;
  if (connection.is_sqlite()) {
    AXIOMETRY_TRY_VOID(collect(connection, parts_of_sqlite, parts));
    return parts;
  }
  for (const std::string_view sql : parts_of_postgresql) AXIOMETRY_TRY_VOID(collect(connection, sql, parts));
  return parts;
}

Result<SchemaParts> expected_schema_parts(const Place& place) {
  return place.info().kind == "sqlite" ? expected_of_sqlite() : expected_of_postgresql(place);
}

SchemaDifferences differences(const SchemaParts& found, const SchemaParts& expected) {
  SchemaDifferences said;
  for (const auto& [name, definition] : expected) {
    const auto there = found.find(name);
    if (there == found.end()) {
      add_missing(said, name);
    } else if (there->second != definition) {
      const auto [is, shall] = where_they_part(there->second, definition);
      said.problems.push_back(
          fmt::format("{}: found it altered, {}, expected {} of schema {}", name, is, shall, newest_schema()));
      said.of_tables |= is_table(name);
    }
  }
  for (const auto& [name, definition] : found) {
    if (expected.contains(name) || belongs_to_extra_table(name, found, expected)) continue;
    if (is_harmless(name, definition))
      said.extras.push_back(fmt::format("{}: somebody's own, no part of schema {}", name, newest_schema()));
    else
      said.problems.push_back(
          fmt::format("{}: found one that schema {} does not have, expected none", name, newest_schema()));
  }
  return said;
}

SchemaDifferences differences_by_name(const SchemaParts& found, bool sqlite) {
  SchemaDifferences said;
  for (const std::string& name : names_in(migration_text(sqlite)))
    if (!has_part(found, name)) add_missing(said, name);
  for (const auto& [name, definition] : found)
    if ((name.starts_with("trigger ") || name.starts_with("reference ")) && definition.ends_with(switched_off))
      said.problems.push_back(fmt::format("{}: found it switched off, expected it on", name));
  return said;
}

}  // namespace axiometry::store
