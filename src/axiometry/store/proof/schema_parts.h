// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "axiometry/store/database/connection.h"
#include "axiometry/store/place.h"

/// Private to this folder: what the database of an archive is made of, beside its rows.
namespace axiometry::store {

/// Tables, columns, constraints, indexes, triggers, functions …: "trigger audit_unchanged of audit" and its definition
/// as the database itself spells it, and of an index whether it may refuse rows. PostgreSQL adds whether a trigger is
/// switched on, and what inherits from a table: "inheritance notes of content".
using SchemaParts = std::map<std::string, std::string>;

/// Those that are there. The tables of ANALYZE's statistics and, in PostgreSQL, what belongs to an extension are left
/// out.
Result<SchemaParts> schema_parts(Connection& connection);

/// Those that this program's migrations make in a database of this kind, spelled by the same database. For PostgreSQL
/// they are made in a schema of their own, within a transaction that is taken back; fails with `read_only` where the
/// user may not make one, or the server is a standby, which makes nothing.
Result<SchemaParts> expected_schema_parts(const Place& place);

/// A sentence for each.
struct SchemaDifferences {
  std::vector<std::string> missing_indexes{};  ///< indexes that are missing, which are among the problems too
  std::vector<std::string> problems;  ///< what is missing, altered, or extra and may change what is written or read
  std::vector<std::string> extras;    ///< tables, views and indexes of somebody's own that refuse no row
  bool of_tables = false;  ///< a table of ours is missing or altered: what is read of that name proves nothing
};

SchemaDifferences differences(const SchemaParts& found, const SchemaParts& expected);

/// Where nobody can say how a database spells them: that all are there by their names, and triggers switched on.
SchemaDifferences differences_by_name(const SchemaParts& found, bool sqlite);

}  // namespace axiometry::store
