// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <iosfwd>

#include "axiometry/store/database/connection.h"
#include "axiometry/store/store.h"

/// Private to this folder.
namespace axiometry::store {

/// A log of SQLite (-wal) as far as it is whole. Each page in it has a sum over all in front of it and the salts of its
/// log; pages of an earlier log, with other salts, may stand behind those that count.
struct LogState {
  std::int64_t pages = 0;    ///< from the first one on that are as they were written
  std::int64_t changes = 0;  ///< finished behind them, that nobody reads any more
  bool altered_head = false;
  bool altered_salts = false;  ///< the page behind them is theirs by its sum, but not by its salts

  /// A change is begun when the one in front of it is safe on the disk: of two none can be half written. One may be.
  bool is_damaged() const { return altered_salts || changes > (altered_head ? 0 : 1); }
  bool operator==(const LogState&) const = default;
};

/// Of a log as the SQLite file format has it; of one that is too short for a page nothing.
LogState log_state(std::istream& log);

/// SQLite passes over what stands in the log beside the file behind a page that is not as it was written, and says
/// nothing.
Result<void> verify_sqlite_log(Connection& connection, Verification& found);

}  // namespace axiometry::store
