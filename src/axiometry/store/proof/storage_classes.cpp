// SPDX-License-Identifier: Apache-2.0
#include "axiometry/store/proof/storage_classes.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "axiometry/store/proof/problems.h"

namespace axiometry::store {
namespace {

constexpr std::pair<std::string_view, std::string_view> class_of_type[] = {
    {"integer", "integer"}, {"bigint", "integer"}, {"double precision", "real"},
    {"plain_text", "text"}, {"text", "text"},      {"blob", "blob"},
};

struct StoredColumn {
  std::string name;
  std::string storage_class;
  bool nullable = false;
};

struct StoredTable {
  std::string name;
  std::vector<StoredColumn> columns;
  std::string key = "'a row'";  ///< SQL that says which
};

/// As SQL takes it, whatever somebody has called it.
std::string between(char quote, std::string_view name) {
  std::string text(1, quote);
  for (const char letter : name) text.append(letter == quote ? 2 : 1, letter);
  return text + quote;
}

std::string spelled(std::string_view name) { return between('"', name); }

std::string expected_of(const StoredColumn& column) {
  return column.storage_class + (column.nullable ? " or null" : "");
}

/// Without columns where there is no such table, of which the comparison of schemas tells.
Result<StoredTable> stored_table(Connection& connection, std::string name, std::vector<std::string>& problems) {
  StoredTable table{.name = std::move(name), .columns = {}};
  AXIOMETRY_TRY(
      const Rows columns,
      connection.query("SELECT name, lower(type), \"notnull\" = 0 AND pk = 0, pk > 0 FROM pragma_table_info($1) "
                       "WHERE EXISTS (SELECT 1 FROM sqlite_master WHERE type = 'table' AND name = $1) ORDER BY "
                       "cid",
                       {table.name}));
  std::vector<std::string> keys;
  for (const Row& column : columns) {
    const std::string& called = column.text(0);
    if (column.flag(3))
      keys.push_back(fmt::format("{} || substr(quote({}), 1, 40)", between('\'', called + " "), spelled(called)));
    const auto known = std::ranges::find(class_of_type, column.text(1), [](const auto& type) { return type.first; });
    if (known == std::end(class_of_type))
      add_problem(problems, "{}: found {} declared as {}, expected a type of which it is known how it is stored",
                  table.name, called, column.text(1));
    else
      table.columns.push_back({called, std::string(known->second), column.flag(2)});
  }
  if (!keys.empty()) table.key = fmt::format("{}", fmt::join(keys, " || ', ' || "));
  return table;
}

/// A look at the class reads no more of a cell than its head.
Result<void> verify_table(Connection& connection, const StoredTable& table, std::vector<std::string>& problems) {
  std::vector<std::string> classes, conditions;
  for (const StoredColumn& column : table.columns) {
    classes.push_back(fmt::format("typeof({})", spelled(column.name)));
    conditions.push_back(fmt::format("typeof({}) NOT IN ('{}'{})", spelled(column.name), column.storage_class,
                                     column.nullable ? ", 'null'" : ""));
  }
  AXIOMETRY_TRY(const Rows rows, connection.query(fmt::format("SELECT {}, {} FROM {} NOT INDEXED WHERE {} LIMIT {}",
                                                              table.key, fmt::join(classes, ", "), spelled(table.name),
                                                              fmt::join(conditions, " OR "), most_problems)));
  for (const Row& row : rows)
    for (std::size_t k = 0; k < table.columns.size(); ++k) {
      const StoredColumn& column = table.columns[k];
      const std::string& found = row.text(k + 1);
      if (found != column.storage_class && !(column.nullable && found == "null"))
        add_problem(problems, "{}: found {} of {} stored as {}, expected {}", table.name, column.name, row.text(0),
                    found, expected_of(column));
    }
  return {};
}

}  // namespace

Result<void> verify_storage_classes(Connection& connection, const SchemaParts& schema,
                                    std::vector<std::string>& problems) {
  if (!connection.is_sqlite()) return {};
  constexpr std::string_view table_part = "table ";
  for (const auto& [part, definition] : schema) {
    if (!part.starts_with(table_part)) continue;
    AXIOMETRY_TRY(const StoredTable table, stored_table(connection, part.substr(table_part.size()), problems));
    if (!table.columns.empty()) AXIOMETRY_TRY_VOID(verify_table(connection, table, problems));
  }
  return {};
}

}  // namespace axiometry::store
