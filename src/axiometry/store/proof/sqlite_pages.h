// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "axiometry/store/database/connection.h"
#include "axiometry/store/store.h"

/// Private to this folder.
namespace axiometry::store {

/// What SQLite itself finds wrong with its pages and references; and whether the file has the bytes of its pages, no
/// fewer and no more: SQLite reads zeros for what was cut off the last one, and passes over what stands behind it.
Result<void> verify_sqlite_pages(Connection& connection, std::vector<std::string>& problems);

/// SQLite passes over what stands in the log beside the file behind a page that is not as it was written, and says
/// nothing.
Result<void> verify_sqlite_log(Connection& connection, Verification& found);

}  // namespace axiometry::store
