// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/store/database/connection.h"
#include "axiometry/store/records.h"

/// Private to this folder: ways through a table that cost as much as rows are there, however far apart their numbers
/// are, which somebody else may have given them.
namespace axiometry::store {

struct IdWalk {
  std::string_view table;
  std::string_view key;      ///< an integer with an index
  std::int64_t at_once = 1;  ///< keys that are shown together
};

/// Shows all keys that are there, each once and in their order.
Result<void> walk(Connection& connection, const IdWalk& way,
                  const std::function<Result<void>(std::span<const Id>)>& visit);

/// Numbers count from 1 without gaps.
class IdCount {
 public:
  explicit IdCount(std::string_view table) : table_(table) {}

  /// The next number that is there; one sentence for all that are missing in front of it.
  void next(Id id, std::vector<std::string>& problems);

 private:
  std::string table_;
  Id expected_ = 1;
};

}  // namespace axiometry::store
