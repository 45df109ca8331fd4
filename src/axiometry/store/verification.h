// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/store/connection.h"
#include "axiometry/store/store.h"

/// Private to this folder.
namespace axiometry::store {

/// Reads everything that an archive holds, within a transaction that the caller has begun.
Result<Verification> verify_archive(Connection& connection);

}  // namespace axiometry::store
