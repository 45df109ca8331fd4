// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "axiometry/base/embedded_file.h"
#include "axiometry/base/result.h"
#include "axiometry/store/database/connection.h"

/// How an archive of an earlier program becomes one of this: numbered files (schema/NNNN_PART_NAME[.KIND].sql), applied
/// once and in order, each number in one transaction. The archive remembers number, name and SHA-256 of each.
namespace axiometry::store {

/// Built into the program from schema/.
std::span<const EmbeddedFile> migration_files();

/// Number of the last migration of this program.
int newest_schema();

/// Applies what is missing and gives the number of the last one. Fails when the archive is of a newer program, or a
/// migration that it remembers was another one.
Result<int> migrate(Connection& connection);

/// All tables of this program, where there are none yet, in a transaction of the caller's or in none.
Result<void> make_tables(Connection& connection);

/// The same checks without a change; fails, too, where something is missing.
Result<int> check_schema(Connection& connection);

/// Where the archive remembers another number, name or SHA-256 than those of this program, a sentence for each.
Result<std::vector<std::string>> other_migrations(Connection& connection);

/// All of them as text, as a database of this kind is given them.
std::string migration_text(bool sqlite);

}  // namespace axiometry::store
