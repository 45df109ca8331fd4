// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "axiometry/store/database/connection.h"
#include "axiometry/store/place.h"
#include "axiometry/store/proof/schema_parts.h"
#include "axiometry/store/store.h"

/// Private to this folder.
namespace axiometry::store {

/// What an archive is held against.
struct Expectations {
  Result<SchemaParts> schema;  ///< parts, or why nobody can say what they must be
  std::span<const Seal> seals{};
  std::span<const Head> heads{};  ///< heads whose hashes may be cut short
};

/// Of an archive in that place. Fails only where the place cannot be used.
Result<Expectations> expectations(const Place& place);

/// Reads everything that an archive holds, within a transaction that the caller has begun.
Result<Verification> verify_archive(Connection& connection, const Expectations& expected);

}  // namespace axiometry::store
