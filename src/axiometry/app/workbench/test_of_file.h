// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>

#include "axiometry/base/result.h"
#include "axiometry/store/store.h"

/// Private to app/.
namespace axiometry::app {

/// What the archive may know a file by.
struct KnownFile {
  std::string name;
  std::span<const std::string> sha256s;  ///< hashes of contents, of which any will do
};

/// The test that it became, be it withdrawn, as that transaction sees the archive.
Result<std::optional<store::Id>> test_of_file(const store::Transaction& archive, const KnownFile& file);

}  // namespace axiometry::app
