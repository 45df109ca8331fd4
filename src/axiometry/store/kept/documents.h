// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "axiometry/store/database/connection.h"
#include "axiometry/store/kept/test_records.h"

/// Reports as issued, and attachments, within a transaction. As in store.h.
namespace axiometry::store {

Result<DocumentRecord> write_document(Connection& connection, const DocumentRecord& document, std::string_view bytes,
                                      const By& by);
Result<std::vector<DocumentRecord>> documents_of(Connection& connection, Id test);
Result<DocumentRecord> read_document(Connection& connection, Id id);

/// The hash of all its fields.
std::string fingerprint(const DocumentRecord& document);

/// The bytes of this hash, whatever they are of. Fails with `damaged` when they no longer have it.
Result<Content> read_content(Connection& connection, const std::string& sha256);
/// How many bytes those are, which nobody reads.
Result<std::int64_t> content_size(Connection& connection, const std::string& sha256);
Result<std::vector<std::string>> list_contents(Connection& connection, std::string_view format);

}  // namespace axiometry::store
