// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/store/database/connection.h"

namespace axiometry::store {

/// Copies all rows from one archive into an empty one, whatever databases they are. Both are of this program's schema
/// and in a transaction, that of `to` one that writes; the caller ends them.
Result<void> copy_rows(Connection& from, Connection& to);

}  // namespace axiometry::store
