// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/base/json/json.h"
#include "axiometry/store/database/connection.h"
#include "axiometry/store/kept/test_records.h"

/// The audit trail: one line for each change, chained by hashes.
namespace axiometry::store {

struct Entry {
  std::string_view action;  ///< "test.received"
  std::string subject;      ///< "test 12"
  json::Value detail = json::Value::object();
};

/// Within the transaction of the change itself.
Result<void> record(Connection& connection, const Change& change, const Entry& entry);

/// The hash that an entry must have after one with `previous` ("" in front of the first).
std::string chained_hash(const std::string& previous, const AuditEntry& entry);

/// The newest `limit` before the id `before` (0: of all), newest first; of all subjects when it is empty.
Result<std::vector<AuditEntry>> entries(Connection& connection, const std::string& subject, std::int64_t before,
                                        std::int64_t limit);

/// Follows the chain from its beginning, shows each entry to `visit` and gives their number; what is wrong goes into
/// `problems`.
Result<std::int64_t> verify_chain(Connection& connection, std::vector<std::string>& problems,
                                  const std::function<void(const AuditEntry&)>& visit);

}  // namespace axiometry::store
