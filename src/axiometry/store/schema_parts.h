// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "axiometry/store/connection.h"
#include "axiometry/store/place.h"

/// Private to this folder: what the database of an archive is made of, beside its rows.
namespace axiometry::store {

/// Tables, columns, constraints, indexes, triggers, functions …: "trigger audit_unchanged of audit" and its definition
/// as the database itself spells it. PostgreSQL adds whether a trigger is switched on.
using SchemaParts = std::map<std::string, std::string>;

/// Those that are there. The statistics of ANALYZE and, in PostgreSQL, what belongs to an extension are left out.
Result<SchemaParts> schema_parts(Connection& connection);

/// Those that this program's migrations make in a database of this kind, spelled by the same database. For PostgreSQL
/// they are made in a schema of their own, within a transaction that is taken back; fails with `read_only` where the
/// user may not make one.
Result<SchemaParts> expected_schema_parts(const Place& place);

/// What is missing, altered or extra, a sentence for each.
std::vector<std::string> differences(const SchemaParts& found, const SchemaParts& expected);

}  // namespace axiometry::store
