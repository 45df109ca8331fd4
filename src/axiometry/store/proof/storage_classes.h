// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "axiometry/store/database/connection.h"
#include "axiometry/store/proof/schema_parts.h"

/// Private to this folder.
namespace axiometry::store {

/// SQLite keeps a value of any class in any column: the bytes of a text as a blob have the hash of the text and are
/// found by nobody who looks for it. Tells of each cell of the schema's tables whose class is not that for which its
/// column is declared, NULL where it may be. PostgreSQL keeps no such cell. Costs as much as there are rows.
Result<void> verify_storage_classes(Connection& connection, const SchemaParts& schema,
                                    std::vector<std::string>& problems);

}  // namespace axiometry::store
