// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "axiometry/base/result.h"
#include "axiometry/digest/ed25519.h"
#include "axiometry/store/store.h"

/// The key that seals an archive. It lies in a file of its owner's, never in the database: who may change the one has
/// not the other by that.
namespace axiometry::app {

/// Where it is when the user does not say: beside the file of an archive ("tests.db.key"), else in axiometry/ among the
/// user's data.
Result<std::string> default_key_file(const store::Info& archive);

/// Fails where there is none, and on a file that others than its owner may read.
Result<SigningKey> read_key(const std::string& file);

/// Likewise, but makes a new one, for its owner only, where there is no such file.
Result<SigningKey> key_in(const std::string& file);

}  // namespace axiometry::app
