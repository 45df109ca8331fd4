// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/store/records.h"

/// What is found of compensations.
namespace axiometry::store {

class Connection;

struct CompensationFilter {
  std::optional<Id> test{};  ///< made from it or proved by it
  std::optional<Id> axis{};
  bool withdrawn = false;   ///< show withdrawn ones too
  std::int64_t limit = 50;  ///< most records, at most largest_page
};

struct CompensationRow {
  Versioned<CompensationRecord> compensation;  ///< the latest version
  std::string made_at;                   ///< time of the first version
};

/// The newest first.
Result<std::vector<CompensationRow>> find_compensations(Connection& connection, const CompensationFilter& filter);

}  // namespace axiometry::store
